#include "sweep/words/integral_text.h"

#include "analysis/results/text.h"

namespace stickslip {
namespace {

std::string factor(double margin)
{
    return "a factor of " + plain_number(1 + margin, 3);
}

}  // namespace

std::string integral_text(const IntegralCost& cost, Units units)
{
    const std::string gain = "Your k_i of " + with_unit(cost.gain, Quantity::integral_gain, units);
    if (cost.with <= 0)
        return gain + " costs the whole margin: without it the position gain is " + factor(cost.without) +
               " from its boundary, with it sliding is unstable.";
    if (factor(cost.with) == factor(cost.without))
        return gain + " hardly changes the margin: " + factor(cost.with) + " from the position gain to its boundary.";
    const std::string margins =
        factor(cost.with) + " instead of " + factor(cost.without) + " from the position gain to its boundary.";
    if (cost.share() < 0) return gain + " widens the margin: " + margins;
    return gain + " costs " + percent(cost.share()) + " of the margin: " + margins;
}

}  // namespace stickslip
