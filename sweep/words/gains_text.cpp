#include "sweep/words/gains_text.h"

#include "analysis/results/text.h"
#include "sweep/words/reason_text.h"

#include <cmath>

namespace stickslip {
namespace {

std::string gains_words(double k_p, double k_v, const CorrectedGains& g, Units units)
{
    return "k_{p} = " + with_unit(k_p / g.per_drive, Quantity::position_gain, units) +
           ", k_{v} = " + with_unit(k_v / g.per_drive, Quantity::velocity_gain, units);
}

/// Under which assumptions gains are recommended.
std::string premises(const CorrectedGains& g, Units units)
{
    std::string text = "least noise of the link at a margin of " + plain_number(g.required.margin);
    if (is_set(g.required.k_p_low))
        text +=
            " with a k_{p} of at least " + with_unit(g.required.k_p_low / g.per_drive, Quantity::position_gain, units);
    if (std::isfinite(g.required.effort_limit))
        text += " within " + with_unit(g.required.effort_limit, Quantity::effort, units);
    if (!g.noise_is_stated)
        text += "; the joint file states no noise of its position, which scales that of the link alone";
    if (!g.rate_is_stated)
        text +=
            "; it states no period, and " + with_unit(g.required.noise.period, Quantity::time, units) + " was taken";
    return text;
}

std::string no_gains_words(const CorrectedGains& g)
{
    switch (g.none) {
        case NoGains::force_control:
            return "the motor is a source of force, whose loop has no gains to choose";
        case NoGains::dead_time:
            return "behind dead time without a period each pair of gains takes a search for roots; stickslip design "
                   "corrected-joint.toml does it";
        case NoGains::interrupted:
            return "the search was interrupted; stickslip design corrected-joint.toml does it";
        case NoGains::looked_for:
        case NoGains::refused:
            break;
    }
    return g.refusal;
}

}  // namespace

std::string right_gains_text(const CorrectedGains& g, Units units, const std::string& with)
{
    if (g.none != NoGains::looked_for) return "No gains were looked for: " + no_gains_words(g) + ".";
    if (!g.right || !g.right->decided)
        return "No gains can be recommended: the joint " + with + " has no steady sliding here.";
    const auto& best = g.right->best;
    const std::string gains = gains_words(best.k_p, best.k_v, g, units);
    if (!g.right->feasible)
        return "No gains meet all requirements in the joint " + with + "; nearest to it are " + gains + " (" +
               premises(g, units) + ").";
    return "Recommended for the joint " + with + ": " + gains + " (" + premises(g, units) +
           "). For other requirements: stickslip design corrected-joint.toml.";
}

std::string settled_text(const SettledMotion& motion, Units units)
{
    if (!is_set(motion.low)) return "not simulated: " + reason_text(motion.reason);
    return span_text(motion.low, motion.high, Quantity::velocity, units) +
           (motion.rest_share > 0 ? ", at rest for " + percent(motion.rest_share) + " of it" : "");
}

}  // namespace stickslip
