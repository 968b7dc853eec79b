// Do sets keep their promise? reliability_guarantee CALIBRATION… --fresh CASES… [--coverage 0.95]: answered fresh
// cases, in the same format, that no calibration holds. Prints coverage with its exact bounds, and the sizes of the
// sets.
#include "analysis/diagnosis/fit/effect.h"
#include "sweep/files/json/calibration_json.h"
#include "sweep/study/binomial.h"
#include "sweep/words/guarantee_text.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

using namespace stickslip;

namespace {

struct Count {
    int held = 0, of = 0;
    double size = 0;
    void add(bool holds, const CauseSet& set)
    {
        held += holds, ++of;
        size += static_cast<double>(set.size());
    }
};

void print(const std::string& what, const Count& c)
{
    fmt::print("{:<32} {:>4} of {:<4} {:>6.1f} %   at least {:>5.1f} %, at most {:>5.1f} %   mean set {:>5.2f}\n", what,
               c.held, c.of, 100.0 * c.held / std::max(1, c.of), 100 * blind::share_at_least(c.held, c.of),
               100 * blind::share_at_most(c.held, c.of), c.size / std::max(1, c.of));
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App app{"Coverage and size of conformal sets on fresh answered cases"};
    std::vector<std::string> calibrations, fresh;
    double coverage = 0.95;
    app.add_option("CALIBRATION", calibrations, "files of calibrate or blind --calibration")->required();
    app.add_option("--fresh", fresh, "files of fresh cases")->required();
    app.add_option("--coverage", coverage, "share that was promised");
    CLI11_PARSE(app, argc, argv);
    const auto calibration = read_calibrations(calibrations);
    const auto promise = guarantee::promise_of(calibration, coverage);
    if (!promise.kept) {
        fmt::print("{}\n", too_few_cases_text(promise));
        return 2;
    }
    std::vector<std::string> catalogue;
    for (const auto& effect : gap::effects()) catalogue.emplace_back(effect.name);
    Count all;
    std::map<std::string, Count> by_cause;
    int strangers = 0, known = 0;
    std::vector<guarantee::Place> population;
    for (const auto& c : calibration.cases) population.push_back(c.place);
    for (const auto& c : read_calibrations(fresh).cases) {
        if (std::ranges::find(calibration.cases, c.name, &guarantee::CalibrationCase::name) !=
            calibration.cases.end()) {
            ++known;
            continue;
        }
        strangers += !guarantee::strangers(c.place, population).empty();
        const auto set = guarantee::set_of(c.answer, promise, calibration, catalogue);
        const bool holds = guarantee::holds(set, c.truth);
        all.add(holds, set);
        for (const auto& cause : guarantee::causes_of(c.truth)) by_cause[cause].add(holds, set);
    }
    fmt::print("{} cases, promise {} at {:g}", promise.cases, name_of(promise.holds), coverage);
    if (promise.holds == CauseSet::Holds::population) fmt::print(", threshold {:.3f}", promise.threshold);
    fmt::print("; left out: {} that the calibration holds; {} would have been refused as strangers\n", known,
               strangers);
    print("all", all);
    for (const auto& [cause, count] : by_cause) print("  " + cause, count);
    return blind::share_at_most(all.held, all.of) < coverage ? 1 : 0;
}
