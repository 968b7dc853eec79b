#include "sweep/words/ending_text.h"

#include "analysis/results/text.h"
#include "sweep/words/open_text.h"
#include "sweep/words/verdict_text.h"

namespace stickslip {
namespace {

using Tone = Headline::Tone;

bool oscillates(Outcome outcome)
{
    return outcome == Outcome::stick_slip || outcome == Outcome::limit_cycle || outcome == Outcome::reversal ||
           outcome == Outcome::period_n || outcome == Outcome::irregular;
}

}  // namespace

std::string ending_text(const NonlinearVerdict& v)
{
    const auto resting = [&] {
        return v.stick_fraction > 0 ? " It spends " + percent(v.stick_fraction) + " of each cycle " + rest_text(v) + "."
                                    : std::string();
    };
    switch (v.outcome) {
        case Outcome::stable_sliding:
            return v.comes_to_rest()
                       ? "Smooth for this disturbance: it decays, but a larger one brings the joint to rest for good."
                   : v.region == NonlinearRegion::bistable
                       ? "Smooth for this disturbance: it decays, but a larger one ends in a limit cycle."
                       : "Smooth: the disturbance decays.";
        case Outcome::stick_slip:
            return "Stick-slip: the motion ends in a cycle that comes to rest again and again." + resting();
        case Outcome::limit_cycle:
            return "Oscillation: the motion ends in a limit cycle that never comes to rest.";
        case Outcome::reversal:
            return "Oscillation: the motion ends in a limit cycle that reverses." + resting();
        case Outcome::period_n:
            return "Oscillation: the motion repeats after " + std::to_string(v.repeats) + " turns." + resting();
        case Outcome::irregular:
            return "Oscillation: the motion does not settle to any cycle." + resting();
        case Outcome::held:
            return "At rest for good: the limits leave less effort than breaks static friction.";
        case Outcome::linear_only:
            return "Judged by the linear theory only.";
        case Outcome::solver_failure:
        case Outcome::undecided:
        case Outcome::not_asked:
            break;
    }
    return open_ending_text(v);
}

Headline::Tone ending_tone(const NonlinearVerdict& v)
{
    if (oscillates(v.outcome) || v.outcome == Outcome::held) return Tone::bad;
    if (v.outcome == Outcome::linear_only) return Tone::neutral;
    return v.outcome == Outcome::stable_sliding && v.region != NonlinearRegion::bistable ? Tone::good : Tone::warning;
}

std::vector<Headline> ending_headlines(const Joint& joint, const NonlinearVerdict& v)
{
    const Units units = units_of(joint);
    std::vector<Headline> list;
    const auto add = [&](double value, Quantity quantity, std::string meaning) {
        if (is_set(value)) list.push_back({Tone::neutral, with_unit(value, quantity, units), std::move(meaning)});
    };
    if (oscillates(v.outcome)) {
        add(v.amplitude, Quantity::position, "position amplitude of the limit cycle (half peak to peak)");
        add(v.period, Quantity::time, "period of the cycle");
        add(joint.control.V0 < 0 ? v.velocity_min : v.velocity_max, Quantity::velocity,
            "peak velocity of the cycle; commanded are " + with_unit(joint.control.V0, Quantity::velocity, units));
        if (is_set(v.stick_fraction))
            list.push_back({Tone::neutral, percent(v.stick_fraction),
                            "of each cycle " + rest_text(v) + ", below a hundredth of the commanded velocity"});
    }
    if (is_set(v.growth_rate))
        list.push_back({v.growth_rate < 0 ? Tone::good : Tone::bad, with_unit(v.growth_rate, Quantity::rate, units),
                        v.growth_rate < 0 ? "rate at which a small disturbance decays; stable below 0"
                                          : "rate at which a small disturbance grows; stable below 0"});
    return list;
}

}  // namespace stickslip
