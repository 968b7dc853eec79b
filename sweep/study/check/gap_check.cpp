#include "sweep/study/check/gap_check.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

using Kind = GapRegression::Kind;

/// Data-sheet numbers have a size of their own, by which a move is measured; those of a cause alone are judged only
/// where the cause changes no documented number.
bool counts(const NumberChange& change, const DiagnosisComparison& c)
{
    if (change.of == FoundNumber::Of::correction) return false;  // a nuisance: it takes a part of what causes take
    if (change.of == FoundNumber::Of::sheet) return true;
    return std::none_of(c.numbers.begin(), c.numbers.end(),
                        [](const auto& other) { return other.of == FoundNumber::Of::sheet && other.in_both(); });
}

bool beyond(const NumberChange& change, const GapTolerance& tolerance)
{
    return change.moved(tolerance.standard_errors) &&
           std::abs(change.change) > tolerance.number * std::abs(change.before->value);
}

bool grown(double was, double is, double share)
{
    return is > (1 + share) * was;
}

}  // namespace

std::vector<GapRegression> gap_regressions(const DiagnosisComparison& c, const GapTolerance& tolerance)
{
    const auto &was = c.before, &is = c.after;
    if (is.interrupted) return {{Kind::no_answer, {}, {}}};
    if (!is.answered()) {
        if (was.answered()) return {{Kind::no_answer, {}, {}}};
        return {};
    }
    if (!is.differs()) return {};
    if (!was.differs()) return {{Kind::new_gap, {}, {}}};
    std::vector<GapRegression> found;
    if (grown(was.overall.before, is.overall.before, tolerance.gap)) found.push_back({Kind::grown, {}, {}});
    // a gap is in multiples of the noise floor: what a true model leaves scatters round 1
    const double left = std::max(was.overall.after, 1.0);
    if (is.verdict == Verdict::gap && was.verdict == Verdict::gap && grown(left, is.overall.after, tolerance.gap))
        found.push_back({Kind::remainder, {}, {}});
    if (was.verdict == Verdict::gap && !c.perhaps_same_cause)
        for (const auto& name : c.appeared) found.push_back({Kind::new_cause, name, {}});
    for (const auto& change : c.numbers)
        if (counts(change, c) && beyond(change, tolerance)) found.push_back({Kind::number_moved, change.name, change});
    return found;
}

}  // namespace stickslip
