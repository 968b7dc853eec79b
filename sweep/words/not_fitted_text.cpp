#include "sweep/words/not_fitted_text.h"

#include <fmt/format.h>

namespace stickslip {
namespace {

std::string instead(const NotFitted& n)
{
    switch (n.why) {
        case NotFitted::Why::several_states:
            return " with more than one state: expected one value of B and of L";
        case NotFitted::Why::elements:
            return fmt::format(
                ": its elements slip one after the other, records are fitted with one bristle. The same level, slope "
                "and stiffness at rest: law = \"coulomb-viscous\", coulomb = {:.6g}, viscous = {:.6g}, bristle = {{ "
                "stiffness = {:.6g} }}",
                n.level, n.viscous, n.stiffness);
        case NotFitted::Why::pure_delay:
            return fmt::format(
                ": its delay is a pure one, records are fitted with a lag of first order. The law of friction.curve in "
                "place of \"time-lag\", with memory = {{ lag = {0:.6g}, lag_viscous = true }}, differs little where "
                "{0:.6g} s is short compared with the motion",
                n.lag);
        case NotFitted::Why::other_law:
            break;
    }
    return ": expected coulomb-viscous, stribeck, kinetic-static, rate-and-state, ageing or rate-and-state-regularised "
           "with one state, lugre, or dahl with exponent = 1";
}

}  // namespace

std::string not_fitted_text(const NotFitted& n)
{
    return n.what() + instead(n);
}

}  // namespace stickslip
