#include "sweep/words/heading_text.h"

#include "analysis/results/text.h"

namespace stickslip {

std::string page_title(const std::string& question, const std::string& joint)
{
    return joint.empty() ? question : question + ": " + joint;
}

std::string gains_text(const Joint& joint)
{
    const auto motion = joint.mechanism.motion;
    return "k_{p} = " + with_unit(joint.control.k_p, Quantity::stiffness, motion) +
           " · k_{v} = " + with_unit(joint.control.k_v, Quantity::damping, motion);
}

}  // namespace stickslip
