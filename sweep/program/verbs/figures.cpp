// stickslip figures: the paper's figures and numbers, computed anew.
#include "sweep/files/text/whole_file.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/verbs.h"
#include "sweep/report/pages/figures_report.h"
#include "sweep/report/write_report.h"
#include "sweep/words/plain_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>

namespace stickslip {
namespace {

struct Options {
    std::string directory = "figures";
    bool json = false;
};

int figures(const Options& options)
{
    const std::filesystem::path directory = options.directory;
    std::filesystem::create_directories(directory / "models");
    const auto answer = paper_answer();
    const auto page = write_report(figures_report(answer), directory);
    for (const auto& model : answer.models) {
        const auto drawn = directory / "charts" / (model.id + ".svg");
        if (std::filesystem::exists(drawn))
            std::filesystem::copy_file(drawn, directory / "models" / drawn.filename(),
                                       std::filesystem::copy_options::overwrite_existing);
    }

    bool met = true;
    auto numbers = nlohmann::ordered_json::array();
    for (const auto& n : answer.numbers) {
        const double difference = std::abs(n.computed / n.printed - 1);
        met = met && difference < figure_tolerance;
        numbers.push_back({{"equation", n.equation},
                           {"statement", plain_text(n.statement)},
                           {"paper", n.printed},
                           {"computed", n.computed},
                           {"relative_difference", difference},
                           {"unit", unit_of(n.quantity, Units(Motion::prismatic))}});
        if (!options.json)
            fmt::print("{:<8} {:<66} {:>16.10g} {:>16.10g} {:<8} {:.1e}\n", n.equation, plain_text(n.statement),
                       n.printed, n.computed, unit_of(n.quantity, Units(Motion::prismatic)), difference);
    }
    const nlohmann::ordered_json answer_json{{"format", "stickslip-figures/1"}, {"numbers", std::move(numbers)}};
    const std::string json = answer_json.dump(2) + "\n";
    write_whole(directory / "figures.json", json);
    if (options.json)
        fmt::print("{}", json);
    else
        fmt::print("page: {}\n", page.string());
    return met ? exit_done : exit_not_met;
}

}  // namespace

void add_figures(CommandLine& line, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto verb = line.add_verb("figures", "Compute the paper's figures, lumped models and numbers");
    verb.add_option("-o,--output", options->directory,
                    "directory of the page, figures.json, the charts and the drawings")
        ->capture_default_str();
    verb.add_flag("--json", options->json, "print figures.json: the numbers, machine-readable");
    verb.footer("Exit 1 if a number of the paper is not reproduced.\nExample: stickslip figures -o figures");
    verb.callback([options, &invocation] { invocation.exit_code = figures(*options); });
}

}  // namespace stickslip
