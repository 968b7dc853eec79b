#include "sweep/words/low_limit_text.h"

#include "analysis/results/text.h"
#include "analysis/stability/steady.h"
#include "sweep/words/detail_text.h"
#include "sweep/words/reason_text.h"

namespace stickslip {
namespace {

constexpr int digits = 6;  ///< a limit just below the friction reads otherwise like it

}  // namespace

std::string low_limit_words(const LowLimit& low, Units units)
{
    return "is " + with_unit(low.allowed, low.quantity, units, digits) +
           ", and steady sliding at V_{0} = " + with_unit(low.velocity, Quantity::velocity, units) + " takes " +
           with_unit(low.needed, low.quantity, units, digits) + " (" + resistance_words(low, units) +
           "): there is no steady sliding";
}

std::string resistance_words(const LowLimit& low, Units units)
{
    const auto effort = [&](double value) { return with_unit(value, Quantity::effort, units, digits); };
    std::string text = "friction " + effort(low.friction);
    if (low.warming > 0) text += " and up to " + effort(low.warming) + " more by drift";
    if (low.load != 0) text += ", constant load " + effort(low.load);
    if (low.gravity != 0) text += ", gravity up to " + effort(low.gravity);
    return text;
}

std::string low_limit_text(const Joint& joint)
{
    const auto low = low_limit(joint, commanded_velocity(joint));
    if (!low) return "Undecided at the design point: " + reason_text(Reason::limit_too_low) + ".";
    return "No steady sliding: " + std::string(low->path) + " " + low_limit_words(*low, units_of(joint)) + ".";
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
