#include "sweep/words/interval_text.h"

#include <cmath>

namespace stickslip {
namespace {

constexpr int set_digits = 4;  ///< of the ends of a set of gains

}  // namespace

std::vector<Interval> that_read_apart(std::vector<Interval> list, Quantity quantity, Units units)
{
    std::erase_if(list, [&](const Interval& i) { return reads_alike(i.low, i.high, quantity, units, set_digits); });
    return list;
}

std::string intervals_text(const std::vector<Interval>& list, Quantity quantity, Units units)
{
    constexpr std::size_t most = 4;
    const auto words = [&](const Interval& i) -> std::string {
        const bool from_zero = i.low == 0, open = std::isinf(i.high);
        return from_zero && open ? "all values"
               : open            ? "above " + with_unit(i.low, quantity, units, set_digits)
               : from_zero       ? "below " + with_unit(i.high, quantity, units, set_digits)
                                 : range_text(i.low, i.high, quantity, units, from_to, set_digits);
    };
    std::string text;
    for (std::size_t i = 0; i < list.size() && i < most; ++i) text += (i ? ", " : "") + words(list[i]);
    if (list.size() > most) text += " and " + std::to_string(list.size() - most) + " more";
    return list.empty() ? "none" : text;
}

std::string required_text(const std::vector<Interval>& stable, Units units)
{
    if (stable.empty()) return "no k_{v} is enough";
    const auto& [low, high] = stable.front();
    const auto words = [&](double k_v) { return with_unit(k_v, Quantity::velocity_gain, units); };
    std::string text = low == 0 && high == infinity ? "any k_{v} is enough"
                       : high == infinity           ? "k_{v} > " + words(low)
                       : low == 0                   ? "k_{v} < " + words(high)
                                                    : words(low) + " < k_{v} < " + words(high);
    if (stable.size() > 1) text += ", or in " + counted(stable.size() - 1, "further window");
    return text;
}

}  // namespace stickslip
