// In one file: one table: the regimes, how rows belong to them, and their shares.
#include "analysis/diagnosis/policy/audit.h"
#include "analysis/diagnosis/policy/page_and_plan.h"
#include "analysis/diagnosis/verdict/locate_stages.h"
#include "analysis/diagnosis/verdict/shares.h"
#include "analysis/numerics/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace stickslip::gap {
namespace {

constexpr double omega = 50;  // numerical: rad/s, at which the motion is predicted

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

const std::array<double, 2> corners{policy::end_of_low_band, policy::end_of_middle_band};  // Hz
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
    return sizes.empty() ? 1 : percentile(std::move(sizes), part);
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

/// Ranges over all records of a diagnosis, in thirds of which a reading lies.
struct Surroundings {
    Range travel, heat;
    bool heated = false;
};

Surroundings surroundings_of(const std::vector<Case>& cases)
{
    Surroundings s;
    for (const auto& c : cases) {
        for (double q : c.ticks.position) s.travel.take(q);
        for (double x : c.temperature) s.heat.take(x);
    }
    s.heated = s.heat.high - s.heat.low > policy::felt_warming;
    return s;
}

/// One record as its joint predicts it, and what counts there as fast, hard, heavy and at the limit.
struct Predicted {
    Predicted(const Case& record, const Surroundings& surroundings) : c(record), around(surroundings)
    {
        const Plant plant = flatten(c.joint);
        const Ticks& t = c.ticks;
        command = known_command(plant, t);
        predict(plant, t, command, omega, innovation);
        fast = part_of(innovation.velocity, 0.95);
        accelerations.assign(t.size(), 0);
        for (std::size_t k = 5; k + 5 < t.size(); ++k)
            accelerations[k] = std::abs(innovation.velocity[k + 5] - innovation.velocity[k - 5]);
        hard = part_of(accelerations, 0.9);
        heaviest = part_of(carried(), 0.95);
        double largest = 0;
        for (double u : command) largest = std::max(largest, std::abs(u));
        limit = std::min({plant.control.effort_limit, plant.actuator.limit / std::abs(plant.actuator.effort_gain),
                          1.0001 * largest});
        duration.take(t.time.front()), duration.take(t.time.back());
    }

    const std::vector<double>& carried() const
    {
        return c.ticks.has_effort ? c.ticks.effort : innovation.predicted_effort;
    }
    bool moves(std::size_t k) const { return std::abs(innovation.velocity[k]) > policy::standing * fast; }
    /// The regimes of tick k, which comes so long after the last reversal [s].
    std::array<bool, regimes> regimes_at(std::size_t k, double since_reversal) const
    {
        const Ticks& t = c.ticks;
        const double v = innovation.velocity[k], speed = std::abs(v);
        std::array<bool, regimes> in{};
        in[speed < policy::standing * fast ? stuck : speed < policy::slow * fast ? low_speed : sliding] = true;
        in[reversal] = since_reversal < policy::after_reversal;
        in[positive] = moves(k) && v > 0, in[negative] = moves(k) && v < 0;
        in[high_acceleration] = accelerations[k] > hard;
        in[saturated] = std::abs(command[k]) >= policy::below_limit * limit;
        in[low_positions + static_cast<std::size_t>(around.travel.third(t.position[k]))] = true;
        in[light_load] = std::abs(carried()[k]) < heaviest / 3;
        in[heavy_load] = std::abs(carried()[k]) > 2 * heaviest / 3;
        const int third = duration.third(t.time[k]);
        in[early] = third == 0, in[late] = third == 2;
        if (around.heated && k < c.temperature.size() && std::isfinite(c.temperature[k])) {
            const int level = around.heat.third(c.temperature[k]);
            in[cold] = level == 0, in[warm] = level == 2;
        }
        return in;
    }

    const Case& c;
    const Surroundings& around;
    Innovation innovation;
    std::vector<double> command, accelerations;
    double fast = 0, hard = 0, heaviest = 0, limit = infinity;
    Range duration;
};

/// Squares of prediction errors, in blocks of time and over all: of each regime, and of each band.
struct Sums {
    std::vector<Block> blocks;
    std::vector<double> squares, counts;

    explicit Sums(std::size_t parts) : squares(parts, 0), counts(parts, 0) {}
};

void add_record(const Predicted& p, Sums& of_regimes, Sums& of_bands)
{
    const Case& c = p.c;
    const Ticks& t = c.ticks;
    const double reading = std::pow(reading_floor(c, omega), 2),
                 floor = reading * noise_amplification(omega, c.row_step);
    const auto floors = floors_of_bands(c.row_step);
    Bands split(c.row_step);
    Block block(regimes, 0), band_block(bands.size(), 0);
    const auto close_blocks = [&] {
        of_regimes.blocks.push_back(block), of_bands.blocks.push_back(band_block);
        block.assign(regimes, 0), band_block.assign(bands.size(), 0);
    };
    double started = t.size() ? t.time[0] : 0, reversed = -infinity, sign = 0;
    for (std::size_t k = 0; k < t.size(); ++k) {
        const double v = p.innovation.velocity[k];
        if (p.moves(k) && v * sign < 0) reversed = t.time[k];
        if (p.moves(k)) sign = v;
        if (!t.logged[k]) continue;
        if (t.time[k] - started > block_seconds) {
            close_blocks();
            started = t.time[k];
        }
        const auto in = p.regimes_at(k, t.time[k] - reversed);
        const double error = p.innovation.position[k], excess = error * error / floor - 1;
        for (std::size_t i = 0; i < regimes; ++i)
            if (in[i]) block[i] += excess, of_regimes.squares[i] += excess + 1, of_regimes.counts[i] += 1;
        const auto parts = split(error);
        for (std::size_t b = 0; b < bands.size(); ++b) {
            const double square = parts[b] * parts[b], noise = reading * floors[b];
            band_block[b] += (square - noise) / floor;
            of_bands.squares[b] += square / noise, of_bands.counts[b] += 1;
        }
    }
    close_blocks();
}

std::vector<Share> shares_of(const Sums& sums, const char* const* called, std::size_t apart)
{
    std::vector<Share> shares(sums.squares.size());
    add_shares(shares, sums.blocks, apart);
    for (std::size_t i = 0; i < shares.size(); ++i) {
        shares[i].name = called[i], shares[i].unit = "floors";
        shares[i].rms = sums.counts[i] > 0 ? std::sqrt(sums.squares[i] / sums.counts[i]) : 0;
        shares[i].floor = 1;
    }
    return shares;
}

}  // namespace

std::vector<Share> locate_regimes(const std::vector<Case>& cases)
{
    const Surroundings around = surroundings_of(cases);
    Sums of_regimes(regimes), of_bands(bands.size());
    for (const auto& c : cases) add_record(Predicted(c, around), of_regimes, of_bands);
    auto shares = shares_of(of_regimes, names.data(), exclusive);
    if (!around.heated) shares.resize(cold);
    const auto by_band = shares_of(of_bands, bands.data(), bands.size());
    shares.insert(shares.end(), by_band.begin(), by_band.end());
    return shares;
}

}  // namespace stickslip::gap
