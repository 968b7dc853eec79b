// What `evaluate --json` and `margins` take in CPU time, over random joints of every law, model and control. Usage:
// reliability_times [--joints N] [--from K] [--loops] [--margins] [--limit SECONDS] [--slow FOLDER], for the joints
// K … N − 1, drawn as reliability_consistency draws them. Joints above the limit are printed, and written to FOLDER for
// `stickslip`.
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/stability/integral_cost.h"
#include "analysis/stability/neighbour_modes.h"
#include "analysis/stability/real_loop.h"
#include "analysis/stability/study.h"
#include "analysis/stability/verdict.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/files/toml/joint_file.h"
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

/// All that the verb computes, from one joint.
void evaluate(const Joint& joint)
{
    auto verdict = linear_verdict(joint);
    add_margins(joint, verdict);
    NonlinearOptions options;
    options.bifurcation = true;
    nonlinear_verdict(joint, options);
    linear_study(joint);
    near_modes(joint);
    integral_cost(joint, verdict);
}

}  // namespace

int main(int argc, char** argv)
{
    std::uint64_t joints = 200, from = 0;
    double limit = 1;
    bool margins = false, loops = false;
    std::filesystem::path folder;
    for (int i = 1; i < argc; ++i) {
        const bool more = i + 1 < argc;
        if (more && !std::strcmp(argv[i], "--joints"))
            joints = std::stoull(argv[++i]);
        else if (more && !std::strcmp(argv[i], "--from"))
            from = std::stoull(argv[++i]);
        else if (more && !std::strcmp(argv[i], "--limit"))
            limit = std::stod(argv[++i]);
        else if (more && !std::strcmp(argv[i], "--slow"))
            folder = argv[++i];
        else if (!std::strcmp(argv[i], "--margins"))
            margins = true;
        else if (!std::strcmp(argv[i], "--loops"))
            loops = true;
        else
            return std::fprintf(stderr, "unknown option %s\n", argv[i]), 2;
    }
    std::vector<double> seconds;
    int slow = 0;
    for (std::uint64_t number = from; number < joints; ++number) {
        const Joint joint = loops ? samples::random_loop(number) : samples::random_joint(number);
        const double begin = cpu_seconds();
        if (margins)
            margins_of(joint);
        else
            evaluate(joint);
        const double took = cpu_seconds() - begin;
        seconds.push_back(took);
        if (took <= limit) continue;
        ++slow;
        std::printf("SLOW joint %llu: %.2f s\n", static_cast<unsigned long long>(number), took);
        std::fflush(stdout);
        if (!folder.empty()) write_whole(folder / ("joint-" + std::to_string(number) + ".toml"), joint_text(joint));
    }
    std::sort(seconds.begin(), seconds.end());
    if (seconds.empty()) return 2;
    std::printf("CPU time of %s: %zu joints, above %g s: %d, median %.3f s, longest %.2f s\n",
                margins ? "margins" : "evaluate --json", seconds.size(), limit, slow, seconds[seconds.size() / 2],
                seconds.back());
    return slow == 0 ? 0 : 1;
}
