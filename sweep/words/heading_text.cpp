#include "sweep/words/heading_text.h"

#include "analysis/results/text.h"

namespace stickslip {

std::string page_title(const std::string& question, const std::string& joint)
{
    return joint.empty() ? question : question + ": " + joint;
}

std::string gains_text(const Joint& joint)
{
    const Units units = units_of(joint);
    return "k_{p} = " + with_unit(joint.control.k_p, Quantity::position_gain, units) +
           " · k_{v} = " + with_unit(joint.control.k_v, Quantity::velocity_gain, units);
}

}  // namespace stickslip
