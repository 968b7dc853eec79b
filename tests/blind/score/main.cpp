// blind_score TRUTH ANSWERS [--json FILE]: scores answers to blind test cases without the program that gave them.
#include "sweep/study/score.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <fstream>
#include <iterator>

namespace {

std::string read(const std::string& file)
{
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App app{"Scores answers.json of blind test cases against their truth."};
    std::string truth, answers, json;
    app.add_option("TRUTH", truth, "what the generator wrote")->required()->check(CLI::ExistingFile);
    app.add_option("ANSWERS", answers, "what the diagnosis answered")->required()->check(CLI::ExistingFile);
    app.add_option("--json", json, "also write the score here");
    CLI11_PARSE(app, argc, argv);
    try {
        const auto score = stickslip::blind::score(stickslip::blind::parse_answers(read(answers)),
                                                   stickslip::blind::parse_truths(read(truth)));
        std::fputs(score_text(score).c_str(), stdout);
        if (!json.empty() && !(std::ofstream(json) << score_json(score)))
            throw std::runtime_error("cannot write " + json);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "blind_score: %s\n", e.what());
        return 2;
    }
    return 0;
}
