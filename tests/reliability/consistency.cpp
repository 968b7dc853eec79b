// Random joints of every law, model and control: does any linear answer contradict another? With --loops joints with
// real loops: does any verb, and the motion itself, contradict another? With --roots the same joints: is every root
// one, and does none lie right of the growth? Usage:
// reliability_consistency --joints N [--from K] [--loops | --roots] [--seconds S] [--log FILE], for the joints
// K … N − 1. A joint is drawn from its number alone. The log holds one line a thousand joints, with --loops one a
// joint; a run that finds one goes on behind it, and --seconds ends a slice of it at the first joint after so much CPU
// time. Standard error tells every ten seconds of CPU time how far it is.
#include "tests/analysis/loop/random_loop.h"
#include "tests/analysis/loop/real_roots.h"
#include "tests/analysis/stability/random_joint.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <exception>
#include <fstream>
#include <map>

namespace {

double cpu_seconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

// In one piece: one loop over joints with its tallies.
int main(int argc, char** argv)
{
    using namespace stickslip;
    std::uint64_t joints = 10'000, number = 0, faults = 0;
    std::string log;
    bool loops = false, roots = false;
    samples::RootsSeen seen;
    double slice = HUGE_VAL;
    for (int i = 1; i < argc; ++i) {
        const bool more = i + 1 < argc;
        if (!std::strcmp(argv[i], "--loops"))
            loops = true;
        else if (!std::strcmp(argv[i], "--roots"))
            roots = true;
        else if (more && !std::strcmp(argv[i], "--joints"))
            joints = std::stoull(argv[++i]);
        else if (more && !std::strcmp(argv[i], "--from"))
            number = std::stoull(argv[++i]);
        else if (more && !std::strcmp(argv[i], "--seconds"))
            slice = std::stod(argv[++i]);
        else if (more && !std::strcmp(argv[i], "--log"))
            log = argv[++i];
        else
            return std::fprintf(stderr, "unknown option %s\n", argv[i]), 2;
    }
    if (!log.empty()) {
        std::ifstream before(log);
        std::uint64_t reached, found;
        while (before >> reached >> found) number = reached, faults = found;
    }
    std::map<std::string, std::uint64_t> kinds;
    std::vector<std::pair<double, std::uint64_t>> slowest;  // CPU time in s, joint
    const std::uint64_t first = number, a_line = loops ? 1 : 1000;
    constexpr double a_while = 10;  // s of CPU time
    double told = 0;
    for (; number < joints && cpu_seconds() < slice; ++number) {
        if (cpu_seconds() > told + a_while) {
            told = cpu_seconds();
            std::fprintf(stderr, "joint %llu of %llu, %llu contradictions, %.0f s\n",
                         static_cast<unsigned long long>(number), static_cast<unsigned long long>(joints),
                         static_cast<unsigned long long>(faults), told);
        }
        std::string fault;
        const double begun = cpu_seconds();
        try {
            fault = roots   ? samples::contradiction_of_roots(samples::random_loop(number), seen)
                    : loops ? samples::contradiction_of_verbs(samples::random_loop(number))
                            : samples::contradiction(samples::random_joint(number));
        } catch (const std::exception& e) {
            fault = std::string("exception: ") + e.what();
        }
        slowest.emplace_back(cpu_seconds() - begun, number);
        std::sort(slowest.rbegin(), slowest.rend());
        slowest.resize(std::min<std::size_t>(slowest.size(), 5));
        if (!fault.empty()) {
            ++faults;
            if (++kinds[fault] <= 5)
                std::printf("FAULT joint %llu: %s\n", static_cast<unsigned long long>(number), fault.c_str()),
                    std::fflush(stdout);
        }
        if (!log.empty() && (number + 1) % a_line == 0)
            std::ofstream(log, std::ios::app) << number + 1 << ' ' << faults << std::endl;
    }
    std::printf("%s compared: %llu joints, %llu of them in this run, contradictions: %llu\n",
                roots   ? "roots of real loops"
                : loops ? "answers of the verbs about real loops"
                        : "linear answers",
                static_cast<unsigned long long>(number), static_cast<unsigned long long>(number - first),
                static_cast<unsigned long long>(faults));
    if (roots) std::printf("  roots: %ld, counts: %ld, counts left open: %ld\n", seen.roots, seen.counts, seen.open);
    for (const auto& [kind, count] : kinds)
        std::printf("  %s: %llu\n", kind.c_str(), static_cast<unsigned long long>(count));
    for (const auto& [seconds, joint] : slowest)
        std::printf("  slow: joint %llu, %.2f s\n", static_cast<unsigned long long>(joint), seconds);
    return faults == 0 ? 0 : 1;
}
