#include "sweep/words/open_text.h"

#include "sweep/words/verdict_text.h"

namespace stickslip {

std::string open_text(const NonlinearVerdict& verdict)
{
    const std::string reason = reason_text(verdict), because = reason.empty() ? "." : ": " + reason + ".";
    return (verdict.outcome == Outcome::stable_sliding
                ? "Undecided whether larger disturbances also end in steady sliding" + because
                : "Undecided how the motion after the disturbance ends" + because) +
           " About small disturbances:";
}

std::string contradicted_text(const LinearVerdict& linear, const NonlinearVerdict& motion)
{
    const bool grows = motion.region == NonlinearRegion::stick_slip;
    const bool decays = motion.region == NonlinearRegion::stable || motion.region == NonlinearRegion::bistable;
    if (linear.steady.reason != Reason::none || linear.state_variable.neutral) return "";
    if (!(linear.state_variable.stable ? grows : decays)) return "";
    std::string missing;
    for (const auto& term : linear.loop.not_used)
        if (term.matters) missing += (missing.empty() ? "" : ", ") + term.key;
    if (missing.empty()) return "";
    return std::string(grows ? "Stick-slip: small disturbances grow" : "Smooth sliding: small disturbances decay") +
           " in the simulation of this joint. The linear theory, which has no term for " + missing +
           ", says otherwise:";
}

}  // namespace stickslip
