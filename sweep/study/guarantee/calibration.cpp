#include "sweep/study/guarantee/calibration.h"

#include "sweep/study/guarantee/order_statistic.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace stickslip::guarantee {
namespace {

bool same_answer(const CalibrationCase& one, const CalibrationCase& other)
{
    return one.truth.effects == other.truth.effects && one.truth.verdict == other.truth.verdict &&
           one.answer.verdict == other.answer.verdict && one.answer.ranked == other.answer.ranked &&
           one.answer.probabilities == other.answer.probabilities;
}

}  // namespace

void merge(Calibration& into, const Calibration& other)
{
    if (into.method != other.method)
        throw std::invalid_argument("was answered by other sources of the diagnosis (" + other.method + ") than " +
                                    into.method);
    if (into.joint != other.joint) throw std::invalid_argument("is of another joint");
    for (const auto& one : other.cases) {
        const auto known = std::ranges::find(into.cases, one.name, &CalibrationCase::name);
        if (known == into.cases.end())
            into.cases.push_back(one);
        else if (!same_answer(*known, one))
            throw std::invalid_argument("has another answer to case " + one.name + " than an earlier file");
    }
    for (const auto& one : other.populations)
        if (std::ranges::find(into.populations, one) == into.populations.end()) into.populations.push_back(one);
}

std::string Calibration::population() const
{
    std::string all;
    for (const auto& one : populations) all += (all.empty() ? "" : "; ") + one;
    return all;
}

double Promise::limit(const std::string& cause) const
{
    if (holds == CauseSet::Holds::population) return threshold;
    const auto found = thresholds.find(cause);
    return found == thresholds.end() ? std::numeric_limits<double>::infinity() : found->second;
}

Promise promise_of(const Calibration& calibration, double coverage, double confidence)
{
    Promise p{.coverage = coverage, .confidence = confidence};
    p.cases = static_cast<int>(calibration.cases.size());
    p.needed = fewest_that_cover(coverage, confidence);
    std::map<std::string, std::vector<double>> by_cause;
    std::vector<double> all;
    for (const auto& c : calibration.cases) {
        for (const auto& cause : causes_of(c.truth)) by_cause[cause].push_back(nonconformity(c.answer, cause));
        all.push_back(nonconformity(c.answer, c.truth));
    }
    bool every = !by_cause.empty();
    for (const auto& [cause, scores] : by_cause) {
        p.thresholds[cause] = score_that_covers(scores, coverage, confidence);
        p.cases_of[cause] = static_cast<int>(scores.size());
        every = every && p.cases_of[cause] >= p.needed;
    }
    p.threshold = score_that_covers(all, coverage, confidence);
    p.holds = every ? CauseSet::Holds::every_cause : CauseSet::Holds::population;
    p.kept = every || p.cases >= p.needed;
    return p;
}

CauseSet set_of(const blind::Answer& answer, const Promise& promise, const Calibration& calibration,
                const std::vector<std::string>& catalogue)
{
    CauseSet set{.coverage = promise.coverage, .confidence = promise.confidence, .holds = promise.holds};
    set.cases = promise.cases;
    set.population = calibration.population();
    const bool every = promise.holds == CauseSet::Holds::every_cause;
    const auto stays = [&](const std::string& cause) {
        const bool calibrated = promise.cases_of.contains(cause);
        if (!calibrated) set.uncalibrated.push_back(cause);
        const double score = nonconformity(answer, cause);
        // a promise over the population says nothing of a cause that it does not have: only what the answer names stays
        const bool considered = calibrated || every || score < 1;
        return considered && score <= promise.limit(cause);
    };
    for (const auto& cause : catalogue)
        if (stays(cause)) set.names.push_back({cause});
    std::ranges::stable_sort(set.names, {}, [&](const auto& names) { return nonconformity(answer, names.front()); });
    set.no_gap = stays(no_gap);
    set.none_of_these = stays(none_of_these);
    return set;
}

bool holds(const CauseSet& set, const blind::Truth& truth)
{
    const auto has = [&](const std::string& cause) {
        if (cause == no_gap) return set.no_gap;
        if (cause == none_of_these) return set.none_of_these;
        return std::ranges::count(set.names, blind::EffectSet{cause}) > 0;
    };
    return std::ranges::all_of(causes_of(truth), [&](const std::string& cause) {
        if (has(cause)) return true;
        if (cause == none_of_these || (cause == no_gap && !truth.dirty)) return false;
        return std::ranges::any_of(truth.equivalent, has);
    });
}

}  // namespace stickslip::guarantee
