#include "analysis/simulation/dense/sheet.h"

#include "analysis/base/field.h"
#include "analysis/simulation/flows/near_rest.h"

#include <algorithm>
#include <cmath>

namespace stickslip::dense {
namespace {

bool positive(double value)
{
    return value > 0 && std::isfinite(value);
}

/// e-folds per amplitude: of a square root, half of those of the growth.
double lead(Form form, const PointResult& row)
{
    return form == Form::square_root ? 0.5 * std::log(row.spectral_abscissa) : 0;
}

double peak_of(const Place& place)
{
    return is_set(place.peak) ? place.peak : 1;
}

/// e-folds of the least velocity below what counts as rest: the share at rest begins as the square root of it.
double depth(const PointResult& row, const Place& place)
{
    return near_rest_logarithm - std::log(row.velocity_min / place.velocity);
}

}  // namespace

Kind kind_of(const PointResult& row)
{
    Kind kind;
    kind.grows = row.state_variable_stable == 0;
    kind.outcome = row.outcome;
    kind.bistable = row.region == Region::bistable;
    kind.measured = is_set(row.growth_rate);
    kind.overshoots = row.overshoot > 0;
    const bool decided = row.state_variable_stable <= 1 && row.reason == Reason::none && is_set(row.overshoot) &&
                         (!kind.measured || row.growth_rate / row.spectral_abscissa > 0);
    const bool plain = row.outcome == Outcome::stable_sliding || row.outcome == Outcome::limit_cycle ||
                       row.outcome == Outcome::stick_slip;
    kind.regular = decided && plain;
    if (!kind.regular || !kind.cycles()) return kind;
    kind.rests = row.stick_fraction > 0;
    kind.stops = row.velocity_min == 0;
    kind.regular = positive(row.amplitude) && positive(row.period) && positive(row.velocity_max) &&
                   is_set(row.stick_fraction) && (kind.stops || positive(row.velocity_min));
    return kind;
}

std::uint8_t verdict_of(const PointResult& row)
{
    return static_cast<std::uint8_t>(2 * static_cast<int>(row.outcome) + (row.region == Region::bistable));
}

std::size_t Sheet::quantities() const
{
    return kind_.measured + kind_.overshoots + (kind_.cycles() ? 3 + !kind_.stops + kind_.rests : 0);
}

bool Sheet::follows_growth(const Place& place) const
{
    return form_ == Form::square_root || (kind_.outcome == Outcome::stable_sliding && !is_set(place.peak));
}

void Sheet::take(const PointResult& row, const Place& place, std::span<double> quantity) const
{
    auto next = quantity.begin();
    if (kind_.measured) *next++ = row.growth_rate / place.growth;
    const double size = lead(form_, row);
    const bool own_cycle = kind_.outcome != Outcome::stable_sliding;
    if (kind_.overshoots && own_cycle)  // the middle of the cycle moves with the square of its amplitude
        *next++ = (row.overshoot * place.deflection / row.amplitude - 1) * std::exp(-size);
    else if (kind_.overshoots)
        *next++ = std::log(row.overshoot / peak_of(place));
    if (!kind_.cycles()) return;
    *next++ = std::log(row.amplitude) - size;
    *next++ = std::log(row.period);
    if (kind_.stops) {
        *next++ = std::log(row.velocity_max / place.velocity);
    } else {
        const double up = std::log(row.velocity_max / place.velocity),
                     down = std::log(row.velocity_min / place.velocity);
        *next++ = std::log(up - down) - size;
        *next++ = up + down;
    }
    if (kind_.rests) *next++ = row.stick_fraction / (kind_.stops ? 1 : std::sqrt(depth(row, place)));
}

void Sheet::give(std::span<const double> quantity, const Place& place, PointResult& row) const
{
    auto next = quantity.begin();
    row.path = DecisionPath::interpolation;
    row.outcome = kind_.outcome;
    if (kind_.bistable) row.region = Region::bistable;
    if (kind_.measured) row.growth_rate = *next++ * place.growth;
    const double size = lead(form_, row);
    const double peak = kind_.overshoots ? *next++ : 0;
    const bool own_cycle = kind_.outcome != Outcome::stable_sliding;
    row.overshoot = kind_.overshoots && !own_cycle ? std::exp(peak) * peak_of(place) : 0;
    if (!kind_.cycles()) return;
    row.amplitude = std::exp(*next++ + size);
    if (kind_.overshoots && own_cycle) row.overshoot = (1 + peak * std::exp(size)) * row.amplitude / place.deflection;
    row.period = std::exp(*next++);
    if (kind_.stops) {
        row.velocity_max = place.velocity * std::exp(*next++);
        row.velocity_min = 0;
    } else {
        const double range = std::exp(*next++ + size), sum = *next++;
        row.velocity_max = place.velocity * std::exp(0.5 * (sum + range));
        row.velocity_min = place.velocity * std::exp(0.5 * (sum - range));
    }
    row.stick_fraction = kind_.rests ? *next++ * (kind_.stops ? 1 : std::sqrt(depth(row, place))) : 0;
}

double difference(const PointResult& a, const PointResult& b, const Place& place)
{
    double largest = 0;
    const auto add = [&](double found) { largest = found <= 1e300 ? std::max(largest, found) : 1e300; };
    const auto ratio = [&](double x, double y) {
        if (x != y && !(std::isnan(x) && std::isnan(y))) add(std::abs(x / y - 1));
    };
    ratio(a.growth_rate, b.growth_rate);
    ratio(a.overshoot, b.overshoot);
    ratio(a.amplitude, b.amplitude);
    ratio(a.period, b.period);
    ratio(a.velocity_max, b.velocity_max);
    if (a.velocity_min != b.velocity_min && !(std::isnan(a.velocity_min) && std::isnan(b.velocity_min)))
        add(std::abs(std::log(a.velocity_min / b.velocity_min)) /
            std::max(1.0, std::abs(std::log(b.velocity_min / place.velocity))));
    if (!std::isnan(a.stick_fraction) || !std::isnan(b.stick_fraction))
        add(std::abs(a.stick_fraction - b.stick_fraction));
    return largest;
}

bool surely(const Kind& kind, const PointResult& row, const Place& place, double margin)
{
    if (!kind.cycles() || kind.stops) return true;
    const double below = depth(row, place);
    return kind.rests ? below > margin && row.stick_fraction > 0 : below < -margin;
}

}  // namespace stickslip::dense
