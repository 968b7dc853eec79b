#include "sweep/words/study_text.h"

#include "analysis/results/text.h"

#include <fmt/format.h>

#include <cmath>

namespace stickslip {

std::string study_text(StudyReason reason)
{
    switch (reason) {
        case StudyReason::no_stable_velocity:
            return "no velocity of the searched range is stable with these gains";
        case StudyReason::stable_at_lowest:
            return "sliding is stable at the lowest velocity searched, so the least lies below it";
        case StudyReason::unstable_at_highest:
            return "the highest velocity searched is not stable";
        case StudyReason::kernel_at_one_speed:
            return "a kernel is measured at one velocity and not valid at others";
        case StudyReason::no_single_k_v:
            return "in the velocity-only model no single k_v is stable at every velocity of the range with this k_p";
        case StudyReason::not_stable:
            return "sliding is not stable: there is no steady response to a sine";
        case StudyReason::no_boundary_above:
            return "no boundary lies above this k_p";
        case StudyReason::no_crossover:
            return "|L| is 1 nowhere, no lag makes the joint unstable";
        case StudyReason::neutral:
            return "sliding is neutral: the response to a sine at peak_omega grows without bound";
        case StudyReason::no_linear_response:
            return "the linear theory has no response of this loop with this friction";
        case StudyReason::no_period:
            return "control.period is not set: the noise of a differentiated velocity depends on it";
        case StudyReason::not_searched:
            return "not searched within the usual effort; --effort 10 does";
        case StudyReason::no_pair_on_boundary:
            return "no pair of gains on a boundary of stability was found";
        case StudyReason::gains_not_alone:
            return "this loop has no independent gains k_p and k_v";
        case StudyReason::no_boundary:
            return "neither joint has a boundary along the searched range: nothing to compare";
        case StudyReason::boundaries_differ:
            return "the joints differ in the number of boundaries along the searched range";
    }
    return "unknown";
}

std::string velocities_text(const std::vector<StudyReason>& reasons)
{
    std::string text;
    for (const auto reason : reasons) text += (text.empty() ? "" : "; ") + study_text(reason);
    return text;
}

std::string margins_reason_text(const std::vector<StudyReason>& reasons, double searched_to)
{
    std::string text;
    for (const auto reason : reasons) {
        if (!text.empty()) text += "; ";
        if (reason == StudyReason::not_stable)
            text += "sliding is not stable with these gains: there is no margin";
        else if (reason == StudyReason::no_boundary_above)
            text += "gain_above: " + study_text(reason) +
                    (std::isfinite(searched_to) ? fmt::format(" up to {:.4g}, as far as was searched", searched_to)
                                                : std::string());
        else
            text += "phase: " + study_text(reason);
    }
    return text;
}

std::string refused_text(const ReductionStudy& r)
{
    return r.unsearched ? "not searched within the usual effort for delayed friction; --effort 10 does" : r.refused;
}

std::string error_text(const ReductionStudy& r)
{
    const auto range = fmt::format("{} from {:.4g} to {:.4g}", r.boundary_path, r.searched_low, r.searched_high);
    if (std::isnan(r.own.error)) return "neither joint has a boundary along " + range + ": nothing to compare";
    return fmt::format("boundaries along {}: {} of the full joint, {} of the reduced one", range, r.own.full.size(),
                       r.own.reduced.size());
}

std::string reduction_error_text(double error)
{
    return std::isnan(error)   ? "nothing to compare"
           : std::isinf(error) ? "different number of boundaries"
                               : percent(error);
}

std::string rightmost_roots_text()
{
    return "these are the rightmost ones, and no other lies right of the last of them: memory that is a delay or a "
           "table has infinitely many, and growth beyond all numbers within a tick hides the others";
}

}  // namespace stickslip
