// What `evaluate --json`, with --text `evaluate`, and `margins` take in CPU time, over random joints of every law,
// model and control. Usage:
// reliability_times [--joints N] [--from K] [--loops] [--text] [--margins] [--effort E] [--limit SECONDS]
// [--slow FOLDER], for the joints K … N − 1, drawn as reliability_consistency draws them. Joints above the limit are
// printed with the times of their stages (roots, nonlinear, study, rest), and written to FOLDER for `stickslip`.
#include "analysis/stability/frequency_search.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/study/evaluation.h"
#include "sweep/study/margins_answer.h"
#include "tests/analysis/loop/random_loop.h"
#include "tests/analysis/stability/random_joint.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <vector>

namespace {

using namespace stickslip;

double cpu_seconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// What the verb computes, and the CPU time of each of its stages.
std::vector<double> evaluate(const Joint& joint, bool text, double effort)
{
    EvaluationQuestion question;
    question.joint = joint;
    question.nonlinear.bifurcation = true;
    question.nonlinear.effort = effort;
    question.study = !text;
    std::vector<double> begun;
    evaluate_joint(question, [&](EvaluationStage) { begun.push_back(cpu_seconds()); });
    begun.push_back(cpu_seconds());
    for (std::size_t i = 0; i + 1 < begun.size(); ++i) begun[i] = begun[i + 1] - begun[i];
    begun.pop_back();
    return begun;
}

}  // namespace

int main(int argc, char** argv)
{
    std::uint64_t joints = 200, from = 0;
    double limit = 1, effort = 1;
    bool margins = false, loops = false, text = false;
    std::filesystem::path folder;
    for (int i = 1; i < argc; ++i) {
        const bool more = i + 1 < argc;
        if (more && !std::strcmp(argv[i], "--joints"))
            joints = std::stoull(argv[++i]);
        else if (more && !std::strcmp(argv[i], "--from"))
            from = std::stoull(argv[++i]);
        else if (more && !std::strcmp(argv[i], "--limit"))
            limit = std::stod(argv[++i]);
        else if (more && !std::strcmp(argv[i], "--effort"))
            effort = std::stod(argv[++i]);
        else if (more && !std::strcmp(argv[i], "--slow"))
            folder = argv[++i];
        else if (!std::strcmp(argv[i], "--margins"))
            margins = true;
        else if (!std::strcmp(argv[i], "--text"))
            text = true;
        else if (!std::strcmp(argv[i], "--loops"))
            loops = true;
        else
            return std::fprintf(stderr, "unknown option %s\n", argv[i]), 2;
    }
    set_search_effort(effort);
    std::vector<double> seconds;
    int slow = 0;
    for (std::uint64_t number = from; number < joints; ++number) {
        const Joint joint = loops ? samples::random_loop(number) : samples::random_joint(number);
        const double begin = cpu_seconds();
        std::vector<double> stages;
        if (margins)
            margins_of(joint);
        else
            stages = evaluate(joint, text, effort);
        const double took = cpu_seconds() - begin;
        seconds.push_back(took);
        if (took <= limit) continue;
        ++slow;
        std::printf("SLOW joint %llu: %.2f s", static_cast<unsigned long long>(number), took);
        for (const double stage : stages) std::printf(" %.2f", stage);
        std::printf("\n");
        std::fflush(stdout);
        if (!folder.empty()) write_whole(folder / ("joint-" + std::to_string(number) + ".toml"), joint_text(joint));
    }
    std::sort(seconds.begin(), seconds.end());
    if (seconds.empty()) return 2;
    std::printf("CPU time of %s: %zu joints, above %g s: %d, median %.3f s, longest %.2f s\n",
                margins ? "margins"
                : text  ? "evaluate"
                        : "evaluate --json",
                seconds.size(), limit, slow, seconds[seconds.size() / 2], seconds.back());
    return slow == 0 ? 0 : 1;
}
