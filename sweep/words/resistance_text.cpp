#include "sweep/words/resistance_text.h"

#include "analysis/results/text.h"
#include "analysis/stability/warming.h"

#include <cmath>

namespace stickslip {

std::string resistance_words(const Joint& joint, double friction)
{
    const Units units = units_of(joint);
    const auto effort = [&](double value) { return with_unit(value, Quantity::effort, units, digits_near_limit); };
    std::string text = "friction " + effort(friction);
    const double warmed = warming(joint), gravity = std::abs(joint.load.gravity_amplitude);
    if (warmed > 0) text += " and up to " + effort(warmed) + " more by drift";
    if (joint.load.constant != 0) text += ", constant load " + effort(joint.load.constant);
    if (gravity != 0) text += ", gravity up to " + effort(gravity) + ", where it pulls most in a whole turn";
    return text;
}

}  // namespace stickslip
