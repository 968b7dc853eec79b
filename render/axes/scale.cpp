#include "render/axes/scale.h"

#include "analysis/results/text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace stickslip::drawing {
namespace {

constexpr double tiny = 1e-9;  // in positions: keeps a tick that rounding put just outside

std::string power_of_ten(int exponent)
{
    return "10^{" + (exponent < 0 ? "−" + std::to_string(-exponent) : std::to_string(exponent)) + "}";
}

Ticks linear_ticks(const Scale& scale, int room, double divisor);

/// A stretch too short for powers, or for the 1, 2 and 5 between them, is labelled in even steps.
Ticks log_ticks(const Scale& scale, int room, double divisor)
{
    constexpr double short_stretch = 3;                                 // from the lower end to the upper, as a factor
    constexpr double log10_least_plain = -3.1, log10_most_plain = 4.1;  // numbers without a power of ten
    if (scale.high < short_stretch * scale.low) return linear_ticks(scale, room, divisor);
    Ticks result;
    const double a = std::log10(scale.low / divisor), b = std::log10(scale.high / divisor);
    const int first = static_cast<int>(std::floor(a + tiny)), last = static_cast<int>(std::ceil(b - tiny));
    const int powers = static_cast<int>(std::floor(b + tiny)) - static_cast<int>(std::ceil(a - tiny)) + 1;
    const int every = std::max(1, (powers + room - 1) / room);
    const bool few = powers < 3 && b - a < 2.2;
    const bool plain = few && a > log10_least_plain && b < log10_most_plain;
    const auto text = [&](int digit, int exponent, double printed) {
        if (plain) return plain_number(printed);
        return (digit == 1 ? "" : std::to_string(digit) + "×") + power_of_ten(exponent);
    };
    for (int exponent = first; exponent <= last; ++exponent)
        for (int digit = 1; digit <= 9; ++digit) {
            const double printed = digit * std::pow(10, exponent), value = printed * divisor;
            if (scale.at(value) < -tiny || scale.at(value) > 1 + tiny) continue;
            const bool labelled = digit == 1 ? exponent % every == 0 : few && (digit == 2 || digit == 5);
            if (!labelled)
                result.minor.push_back(value);
            else
                result.major.push_back({value, text(digit, exponent, printed)});
        }
    return result;
}

/// 1, 2 or 5 times a power of ten, the smallest that is not less than `least`.
double round_step(double least)
{
    const double power = std::pow(10, std::floor(std::log10(least)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * power >= least * (1 - tiny)) return digit * power;
    return 10 * power;
}

/// Labels that steps of `step` set between the ends.
long labels_at(double step, double low, double high)
{
    return static_cast<long>(std::floor(high / step + tiny)) - static_cast<long>(std::ceil(low / step - tiny)) + 1;
}

/// One label is no scale: then finer steps, as many as `room` still holds.
double label_step(double low, double high, int room)
{
    constexpr double finer = 0.4;  // takes 1, 2 and 5 each to the next smaller one
    double step = round_step((high - low) / room);
    while (labels_at(step, low, high) < 2 && labels_at(round_step(finer * step), low, high) <= room + 1)
        step = round_step(finer * step);
    return step;
}

Ticks linear_ticks(const Scale& scale, int room, double divisor)
{
    Ticks result;
    const double low = scale.low / divisor, high = scale.high / divisor;
    const double step = label_step(low, high, std::max(1, room));
    const int parts = std::lround(step / std::pow(10, std::floor(std::log10(step) + tiny))) == 2 ? 4 : 5;
    const auto first = static_cast<long>(std::ceil(low / step * parts - tiny * parts));
    const auto last = static_cast<long>(std::floor(high / step * parts + tiny * parts));
    const double steps_to_largest = std::max(std::abs(low), std::abs(high)) / step;
    const int digits = std::clamp(static_cast<int>(std::ceil(std::log10(steps_to_largest + 1))) + 1, 1, 12);
    for (long k = first; k <= last; ++k) {
        const double printed = static_cast<double>(k) * step / parts;
        if (k % parts == 0)
            result.major.push_back({printed * divisor, plain_number(printed, digits)});
        else
            result.minor.push_back(printed * divisor);
    }
    return result;
}

}  // namespace

double Scale::at(double value) const
{
    return log ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

double Scale::value(double position) const
{
    return log ? low * std::pow(high / low, position) : low + position * (high - low);
}

Scale spanning(const std::vector<double>& values, bool log)
{
    Scale scale{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), log};
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        scale.low = std::min(scale.low, value);
        scale.high = std::max(scale.high, value);
    }
    if (scale.low > scale.high) throw std::invalid_argument("an axis needs at least one finite value, none was given");
    if (log && scale.low <= 0)
        throw std::invalid_argument("a log axis needs values above 0, got " + std::to_string(scale.low));
    if (scale.low == scale.high) {
        const double room = log ? 0 : scale.low == 0 ? 1 : std::abs(scale.low) / 2;
        scale.low = log ? scale.low / 2 : scale.low - room;
        scale.high = log ? scale.high * 2 : scale.high + room;
    }
    return scale;
}

Ticks ticks(const Scale& scale, int room, double divisor)
{
    return scale.log ? log_ticks(scale, room, divisor) : linear_ticks(scale, room, divisor);
}

AxisLabel axis_label(const std::string& name, const std::string& symbol, Quantity quantity, Units units,
                     const Scale& scale)
{
    AxisLabel label{name};
    if (!symbol.empty() && symbol != name) label.text += (name.empty() ? "" : " ") + symbol;
    const double largest = scale.log ? 1 : std::max(std::abs(scale.low), std::abs(scale.high));
    const ScaledUnit unit = scaled_unit(largest, quantity, units);
    label.divisor = unit.size;
    if (unit.text != "1") label.text += " [" + unit.text + "]";
    return label;
}

AxisLabel axis_label(const AxisName& axis, const Scale& scale)
{
    if (scale.log || axis.unit.empty()) return {axis.text()};
    const ScaledUnit scaled = scaled_unit(std::max(std::abs(scale.low), std::abs(scale.high)), axis.unit);
    return {AxisName{axis.name, scaled.text}.text(), scaled.size};
}

}  // namespace stickslip::drawing
