// Why a verdict is open, in words.
#include "sweep/words/reason_text.h"

#include "sweep/words/detail_text.h"

namespace stickslip {

std::string reason_text(Reason reason)
{
    switch (reason) {
        case Reason::none:
            return "none";
        case Reason::no_velocity:
            return "neither control.V0 nor control.force_rate is set";
        case Reason::law_needs_motion:
            return "the joint cannot slide at this velocity: V_0 = 0 is a set point, and laws that need motion take "
                   "V_0 > 0 only";
        case Reason::no_steady_state:
            return "there is no steady sliding at the commanded velocity";
        case Reason::not_finite:
            return "a number overflowed";
        case Reason::linear_only:
            return "the law is linear by definition";
        case Reason::not_converged:
            return "the motion is too slow to decide within the allowed work";
        case Reason::solver_failed:
            return "both solvers failed";
        case Reason::unsupported:
            return "this combination of friction law, joint and disturbance is not computed";
        case Reason::neutral:
            return "neutral: small disturbances neither grow nor decay, as nothing damps them";
        case Reason::limit_too_low:
            return "the effort limit is below the effort that steady sliding needs: the joint cannot slide at this "
                   "velocity";
        case Reason::diverges:
            return "the motion runs away from steady sliding: no spring and no damper holds it back";
    }
    return "unknown";
}

std::string reason_text(const NonlinearVerdict& verdict)
{
    if (verdict.detail != Detail::none) return detail_text(verdict.detail);
    return verdict.reason == Reason::none ? std::string() : reason_text(verdict.reason);
}

}  // namespace stickslip
