#include "analysis/diagnosis/verdict/locate.h"
#include "analysis/diagnosis/verdict/shares.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace stickslip::gap {
namespace {

constexpr double omega = 50;  // rad/s, at which the motion is predicted

enum Regime : std::size_t {
    stuck,
    low_speed,
    sliding,
    reversal,
    positive,
    negative,
    high_acceleration,
    saturated,
    low_positions,
    middle_positions,
    high_positions,
    light_load,
    heavy_load,
    early,
    late,
    cold,
    warm,
    regimes
};
constexpr std::array<const char*, regimes> names{"stuck",
                                                 "low speed",
                                                 "sliding",
                                                 "reversal",
                                                 "positive direction",
                                                 "negative direction",
                                                 "high acceleration",
                                                 "saturated",
                                                 "low positions",
                                                 "middle positions",
                                                 "high positions",
                                                 "light load",
                                                 "heavy load",
                                                 "early",
                                                 "late",
                                                 "cold",
                                                 "warm"};
constexpr std::size_t exclusive = 3;  // stuck, low speed and sliding are the whole

constexpr std::array<double, 2> corners{1, 5};  // Hz
constexpr std::array<const char*, corners.size() + 1> bands{"below 1 Hz", "1 to 5 Hz", "above 5 Hz"};

struct Range {
    double low = infinity, high = -infinity;
    void take(double x)
    {
        if (std::isfinite(x)) low = std::min(low, x), high = std::max(high, x);
    }
    /// 0, 1 or 2: the third in which x lies.
    int third(double x) const { return x < low + (high - low) / 3 ? 0 : x > high - (high - low) / 3 ? 2 : 1; }
};

/// |x| below which this part of the values lies.
double part_of(const std::vector<double>& values, double part)
{
    std::vector<double> sizes;
    for (double x : values)
        if (std::isfinite(x)) sizes.push_back(std::abs(x));
    if (sizes.empty()) return 1;
    std::sort(sizes.begin(), sizes.end());
    return sizes[static_cast<std::size_t>(part * static_cast<double>(sizes.size() - 1))];
}

/// Splits a signal into what lies below, between and above the corners: differences of first-order low-passes.
class Bands {
  public:
    explicit Bands(double step)
    {
        for (std::size_t i = 0; i < corners.size(); ++i) keep_[i] = std::exp(-2 * std::numbers::pi * corners[i] * step);
    }
    std::array<double, corners.size() + 1> operator()(double x)
    {
        std::array<double, corners.size() + 1> parts{};
        double below = 0;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            low_[i] = keep_[i] * low_[i] + (1 - keep_[i]) * x;
            parts[i] = low_[i] - below;
            below = low_[i];
        }
        parts[corners.size()] = x - below;
        return parts;
    }

  private:
    std::array<double, corners.size()> keep_{}, low_{};
};

/// What white reading noise of unit variance leaves in each band of a true joint's innovation.
std::array<double, bands.size()> floors_of_bands(double step)
{
    std::array<double, bands.size()> sums{};
    Bands split(step);
    const auto response = innovation_response(omega, step);
    const std::size_t longest = response.size() + static_cast<std::size_t>(2 / corners[0] / step);
    for (std::size_t k = 0; k < longest; ++k) {
        const auto parts = split(k < response.size() ? response[k] : 0);
        for (std::size_t b = 0; b < bands.size(); ++b) sums[b] += parts[b] * parts[b];
    }
    return sums;
}

}  // namespace

std::vector<Share> locate_regimes(const std::vector<Case>& cases)
{
    std::vector<double> squares(regimes, 0), counts(regimes, 0), band_squares(bands.size(), 0),
        band_counts(bands.size(), 0);
    std::vector<Block> blocks, band_blocks;
    Range travel, heat;
    for (const auto& c : cases) {
        for (double q : c.ticks.position) travel.take(q);
        for (double x : c.temperature) heat.take(x);
    }
    constexpr double felt = 1;  // °C: less tells nothing of temperature
    const bool heated = heat.high - heat.low > felt;
    for (const auto& c : cases) {
        const Plant plant = flatten(c.joint);
        const Ticks& t = c.ticks;
        const auto command = known_command(plant, t);
        Innovation innovation;
        predict(plant, t, command, omega, innovation);
        const double fast = part_of(innovation.velocity, 0.95);
        std::vector<double> accelerations(t.size(), 0);
        for (std::size_t k = 5; k + 5 < t.size(); ++k)
            accelerations[k] = std::abs(innovation.velocity[k + 5] - innovation.velocity[k - 5]);
        const double hard = part_of(accelerations, 0.9);
        const auto& carried = t.has_effort ? t.effort : innovation.predicted_effort;
        const double heaviest = part_of(carried, 0.95);
        double largest = 0;
        for (double u : command) largest = std::max(largest, std::abs(u));
        const double limit = std::min({plant.control.effort_limit,
                                       plant.actuator.limit / std::abs(plant.actuator.effort_gain), 1.0001 * largest});
        const double floor = c.sigma * c.sigma * noise_amplification(omega, c.row_step);
        const auto floors = floors_of_bands(c.row_step);
        Bands split(c.row_step);
        Block block(regimes, 0), band_block(bands.size(), 0);
        Range duration;
        duration.take(t.time.front()), duration.take(t.time.back());
        double started = t.size() ? t.time[0] : 0, reversed = -infinity, sign = 0;
        for (std::size_t k = 0; k < t.size(); ++k) {
            const double v = innovation.velocity[k], speed = std::abs(v);
            const bool moves = speed > 0.005 * fast;
            if (moves && v * sign < 0) reversed = t.time[k];
            if (moves) sign = v;
            if (!t.logged[k]) continue;
            if (t.time[k] - started > block_seconds) {
                blocks.push_back(block), band_blocks.push_back(band_block);
                block.assign(regimes, 0), band_block.assign(bands.size(), 0);
                started = t.time[k];
            }
            constexpr double after_reversal = 0.1;  // s
            std::array<bool, regimes> in{};
            in[speed < 0.005 * fast ? stuck : speed < 0.2 * fast ? low_speed : sliding] = true;
            in[reversal] = t.time[k] - reversed < after_reversal;
            in[positive] = moves && v > 0, in[negative] = moves && v < 0;
            in[high_acceleration] = accelerations[k] > hard;
            in[saturated] = std::abs(command[k]) >= 0.999 * limit;
            in[low_positions + static_cast<std::size_t>(travel.third(t.position[k]))] = true;
            in[light_load] = std::abs(carried[k]) < heaviest / 3;
            in[heavy_load] = std::abs(carried[k]) > 2 * heaviest / 3;
            const int third = duration.third(t.time[k]);
            in[early] = third == 0, in[late] = third == 2;
            if (heated && k < c.temperature.size() && std::isfinite(c.temperature[k])) {
                const int level = heat.third(c.temperature[k]);
                in[cold] = level == 0, in[warm] = level == 2;
            }
            const double excess = innovation.position[k] * innovation.position[k] / floor - 1;
            for (std::size_t i = 0; i < regimes; ++i)
                if (in[i]) block[i] += excess, squares[i] += excess + 1, counts[i] += 1;
            const auto parts = split(innovation.position[k]);
            for (std::size_t b = 0; b < bands.size(); ++b) {
                const double square = parts[b] * parts[b], noise = c.sigma * c.sigma * floors[b];
                band_block[b] += (square - noise) / floor;
                band_squares[b] += square / noise, band_counts[b] += 1;
            }
        }
        blocks.push_back(block), band_blocks.push_back(band_block);
    }
    std::vector<Share> shares(regimes), of_bands(bands.size());
    add_shares(shares, blocks, exclusive);
    add_shares(of_bands, band_blocks, bands.size());
    const auto describe = [](Share& s, const char* name, double square, double count) {
        s.name = name, s.unit = "floors";
        s.rms = count > 0 ? std::sqrt(square / count) : 0;
        s.floor = 1;
    };
    for (std::size_t i = 0; i < regimes; ++i) describe(shares[i], names[i], squares[i], counts[i]);
    for (std::size_t b = 0; b < bands.size(); ++b) describe(of_bands[b], bands[b], band_squares[b], band_counts[b]);
    if (!heated) shares.resize(cold);
    shares.insert(shares.end(), of_bands.begin(), of_bands.end());
    return shares;
}

}  // namespace stickslip::gap
