#include "sweep/words/verdict_text.h"
#include "sweep/words/reason_text.h"

#include "analysis/joint/gains.h"
#include "analysis/results/text.h"
#include "sweep/words/interval_text.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/resistance_text.h"
#include "sweep/words/searched_gains.h"

#include <cmath>

namespace stickslip {
namespace {

std::string stiffness(double k, Units units)
{
    return with_unit(k, Quantity::position_gain, units);
}

/// k_p per the critical gain; beside it by how much, as "1 ×" would not tell the side.
std::string beside_k_cr(double k_p, const StateVariableVerdict& memory, Units units)
{
    const double ratio = k_p / memory.k_cr;
    constexpr double beside = 0.005;
    const bool close = std::abs(ratio - 1) < beside && ratio != 1;
    const std::string side = ratio > 1 ? " above" : " below";
    const std::string place =
        close ? plain_number(100 * std::abs(ratio - 1)) + " %" + side : plain_number(ratio) + " ×";
    return ": k_{p} = " + stiffness(k_p, units) + " is " + place +
           " the critical gain k_{cr} = " + stiffness(memory.k_cr, units) + ".";
}

/// The stable set in k_p where it is no single half-line above a critical gain. `bistable`: of small disturbances.
std::string stable_gains(const Joint& joint, const StateVariableVerdict& memory, bool bistable = false)
{
    if (!searched_in_k_p(joint)) return ".";
    const Units units = units_of(joint);
    const auto& stable = memory.stable_intervals;
    const bool limited = std::isfinite(memory.searched_to);
    if (stable.empty()) return limited ? "." : ". No k_{p} makes it stable.";
    const bool all = stable.size() == 1 && stable[0].low == 0 && stable[0].high == infinity;
    if (all && memory.stable)
        return std::string(bistable ? ". Small disturbances decay" : "") + " for every k_{p} > 0.";
    if (all) return ". Every k_{p} > 0 is stable.";
    return ". k_{p} = " + stiffness(joint.control.k_p, units) +
           (memory.stable ? " is one of the stable gains: " : " is not among the stable gains: ") +
           intervals_text(stable, Quantity::position_gain, units) +
           (memory.searched_from > 0
                ? ", searched " + range_text(memory.searched_from, memory.searched_to, Quantity::position_gain, units) +
                      "."
            : limited ? ", searched up to " + stiffness(memory.searched_to, units) + "."
                      : ".");
}

/// What the velocity-only model would require where it says no, and memory does not.
std::string asked_by_velocity(const Joint& joint, const LoopUse& loop, const VelocityOnlyVerdict& velocity_only)
{
    if (!searched_in_k_v(joint, loop)) return ".";
    if (velocity_only.stable_k_v.empty()) return " at every k_{v}.";
    return " and requires " + required_text(velocity_only.stable_k_v, units_of(joint)) + ".";
}

/// Above the upper end of a real loop's stable gains it is dead time, lag or sampling that destabilises, not friction.
bool above_the_loops_window(const Joint& joint, const LinearVerdict& v)
{
    const auto& stable = v.state_variable.stable_intervals;
    return v.loop.kind != LoopKind::ideal && !stable.empty() && gains_of(joint.control).k_p > stable.back().high;
}

/// The first words: what the joint does, and how fast.
std::string first_words(const Joint& joint, const LinearVerdict& v, TakenOut taken, bool rests)
{
    const auto in_words = [&](double V) { return with_unit(V, Quantity::velocity, units_of(joint)); };
    auto speed = in_words(v.steady.slides_at);
    if (v.steady.slides_at != v.steady.velocity) speed += " (commanded: " + in_words(v.steady.velocity) + ")";
    if (v.state_variable.stable && taken == TakenOut::by_noise)
        return "Not smooth: the encoder's steps, noise or forces that change on the way alone bring sliding at " +
               speed + " into a lasting cycle";
    if (v.state_variable.stable && taken == TakenOut::by_larger)
        return "Bistable: slides smoothly at " + speed + ", but a large enough disturbance " +
               (rests ? "brings it to rest for good" : "leads to lasting stick-slip");
    if (v.state_variable.stable) return "Slides smoothly at " + speed;
    if (v.state_variable.neutral)
        return "Neutral: small disturbances of sliding at " + speed + " neither decay nor grow";
    if (joint.control.k_p < 0)
        return "Unstable: with k_{p} < 0 the loop pushes away from the commanded motion, sliding at " + speed +
               " does not last";
    if (above_the_loops_window(joint, v))
        return "Unstable loop: k_{p} is above every gain with which the loop itself is stable, sliding at " + speed +
               " does not last";
    if (rests)
        return "Comes to rest for good: sliding at " + speed +
               " is unstable, and at rest the limits leave less effort than breaks static friction";
    return "Stick-slip: sliding at " + speed + " is unstable";
}

/// What holds the joint on the imaginary axis, and what would not.
std::string neutral_words(const Joint& joint, const StateVariableVerdict& memory)
{
    if (joint.control.k_p == 0) return ". Nothing brings the position back: k_{p} = 0.";
    if (!memory.stable_intervals.empty() || !memory.crossings.empty())
        return ". The design lies on the boundary of stability" + stable_gains(joint, memory);
    return ". Friction and k_{v} together neither feed nor damp the oscillation, and no k_{p} changes that.";
}

/// The other theory's word, where it differs.
std::string other_theory(const Joint& joint, const LinearVerdict& v)
{
    const auto& simple = v.velocity_only;
    const auto& memory = v.state_variable;
    if (simple.stable == memory.stable && simple.neutral == memory.neutral) return "";
    const std::string says = " The velocity-only model calls it ";
    return says + (simple.stable    ? "stable."
                   : simple.neutral ? "neutral."
                                    : "stick-slip" + asked_by_velocity(joint, v.loop, simple));
}

}  // namespace

TakenOut taken_out(bool bistable, const NonlinearVerdict& verdict)
{
    if (!bistable) return TakenOut::by_nothing;
    return verdict.noise_suffices ? TakenOut::by_noise : TakenOut::by_larger;
}

std::string verdict_text(const Joint& joint, const LinearVerdict& v, TakenOut taken, bool rests)
{
    const Units units = units_of(joint);
    if (v.steady.reason == Reason::no_steady_state) return "Undecided: the design point has no steady sliding.";
    if (v.steady.reason == Reason::limit_too_low)
        return "No steady sliding: the effort limit is not above what it takes against " +
               resistance_words(joint, v.steady.friction) + ".";
    if (v.steady.reason != Reason::none)
        return "Undecided at the design point: " + reason_text(v.steady.reason, joint) + ".";
    const auto& memory = v.state_variable;
    const double k_p = joint.control.k_p;
    std::string text = first_words(joint, v, taken, rests);
    if (memory.neutral)
        text += neutral_words(joint, memory);
    else if (std::isfinite(memory.k_cr) && k_p > 0)
        text += beside_k_cr(k_p, memory, units);
    else
        text += stable_gains(joint, memory, taken != TakenOut::by_nothing);
    return text + other_theory(joint, v) + loop_text(v.loop);
}

std::string design_point_text(Region region, double spectral_abscissa, bool rests)
{
    if (region == Region::bistable)
        return std::string("The design is stable for small disturbances only: a larger one ") +
               (rests ? "leaves it at rest for good." : "ends in stick-slip.");
    if (region == Region::undecided) return "The design is undecided.";
    if (region == Region::neutral) return "The design is neutral: small disturbances neither decay nor grow.";
    return spectral_abscissa < 0 ? "The design slides smoothly."
           : rests               ? "The design comes to rest for good."
                                 : "The design sticks and slips.";
}

}  // namespace stickslip
