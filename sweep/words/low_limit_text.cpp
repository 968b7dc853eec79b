#include "sweep/words/low_limit_text.h"

#include "analysis/results/text.h"
#include "analysis/stability/steady.h"
#include "sweep/words/detail_text.h"
#include "sweep/words/reason_text.h"
#include "sweep/words/resistance_text.h"

namespace stickslip {

std::string low_limit_words(const LowLimit& low, const Joint& joint)
{
    const Units units = units_of(joint);
    const bool as_commanded = low.velocity == commanded_velocity(joint);
    return "is " + with_unit(low.allowed, low.quantity, units, digits_near_limit) + ", and steady sliding at " +
           (as_commanded ? "V_{0} = " : "") + with_unit(low.velocity, Quantity::velocity, units) + " takes " +
           with_unit(low.needed, low.quantity, units, digits_near_limit) + " (" +
           resistance_words(joint, low.friction) + "): there is no steady sliding";
}

std::string low_limit_text(const Joint& joint)
{
    const auto low = low_limit(joint, sliding_velocity(joint));
    if (!low) return "Undecided at the design point: " + reason_text(Reason::limit_too_low) + ".";
    return "No steady sliding: " + std::string(low->path) + " " + low_limit_words(*low, joint) + ".";
}

std::string no_motion_text(const Joint& joint, const Trajectory& motion)
{
    if (motion.reason == Reason::limit_too_low) return low_limit_text(joint);
    return "No motion: " + stop_text(motion) + ".";
}

std::string stop_text(const Trajectory& motion)
{
    return motion.why == Detail::none ? reason_text(motion.reason) : detail_text(motion.why);
}

}  // namespace stickslip
