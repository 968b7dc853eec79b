// Why a verdict is open, in words.
#include "sweep/words/reason_text.h"

#include "sweep/words/detail_text.h"

#include <utility>

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
            return "the effort limit is not above the effort that steady sliding needs: the joint cannot slide at "
                   "this velocity";
        case Reason::impossible:
            return "there is no such joint: these values together break a rule between keys, which evaluate with --set "
                   "names";
        case Reason::diverges:
            return "the motion runs away from steady sliding, and the loop does not return it";
    }
    return "unknown";
}

std::string reason_text(Reason reason, const Joint& joint)
{
    if (reason != Reason::unsupported) return reason_text(reason);
    const auto& f = joint.frictions;
    const bool single = joint.mechanism.model == Model::single_mass;
    const std::pair<const Friction*, std::string> bodies[] = {
        {single ? &joint.friction : &f.motor, single ? "friction" : "friction.motor"},
        {single ? nullptr : &f.transmission, "friction.transmission"},
        {single ? nullptr : &f.link, "friction.link"}};
    for (const auto& [body, table] : bodies) {
        if (!body || !body->has_bristle()) continue;
        if (body->has_lag()) return table + ".bristle with " + table + ".memory.lag is not computed";
        if (body->has_memory()) return table + ".bristle with " + table + ".memory is not computed";
    }
    return reason_text(reason);
}

std::string reason_text(const NonlinearVerdict& verdict)
{
    if (verdict.detail != Detail::none) return detail_text(verdict.detail);
    return verdict.reason == Reason::none ? std::string() : reason_text(verdict.reason);
}

}  // namespace stickslip
