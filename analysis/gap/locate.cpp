#include "analysis/gap/locate.h"

#include "analysis/gap/audit.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

constexpr double omega = 50;         // rad/s, at which the residual force is read
constexpr double block_seconds = 1;  // resampled as a whole, since neighbours are correlated
constexpr int resamples = 200;

/// Sums of one block: excess square of each stage or regime.
using Block = std::vector<double>;

/// Bootstrap of shares over blocks with a fixed sequence.
void add_shares(std::vector<Share>& shares, const std::vector<Block>& blocks, std::size_t whole)
{
    if (blocks.empty()) return;
    const auto of = [&](const Block& sum, std::size_t i) {
        double total = 0;
        for (std::size_t j = 0; j < whole; ++j) total += std::max(0.0, sum[j]);
        return total > 0 ? std::clamp(sum[i] / total, 0.0, 1.0) : 0;
    };
    Block sum(blocks[0].size(), 0);
    for (const auto& b : blocks)
        for (std::size_t i = 0; i < b.size(); ++i) sum[i] += b[i];
    std::uint64_t state = 1;
    std::vector<std::vector<double>> drawn(shares.size());
    for (int r = 0; r < resamples; ++r) {
        Block again(sum.size(), 0);
        for (std::size_t n = 0; n < blocks.size(); ++n) {
            state = state * 6364136223846793005ull + 1442695040888963407ull;
            const auto& b = blocks[(state >> 33) % blocks.size()];
            for (std::size_t i = 0; i < b.size(); ++i) again[i] += b[i];
        }
        for (std::size_t i = 0; i < shares.size(); ++i) drawn[i].push_back(of(again, i));
    }
    for (std::size_t i = 0; i < shares.size(); ++i) {
        std::sort(drawn[i].begin(), drawn[i].end());
        shares[i].share = of(sum, i);
        shares[i].interval = {drawn[i][resamples / 40], drawn[i][resamples - 1 - resamples / 40]};
    }
}

}  // namespace

std::vector<Share> locate_signals(const std::vector<Case>& cases, const std::vector<Joint>& documented)
{
    std::vector<Block> blocks;
    std::vector<Share> shares(3);
    shares[0].name = "command";
    shares[1].name = "effort";
    shares[2].name = "motion";
    std::array<double, 3> squares{}, floors{}, counts{};
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Case& c = cases[i];
        const Plant plant = flatten(documented[i]);
        const Ticks& t = c.ticks;
        for (auto& s : shares) s.unit = unit_of(Quantity::effort, c.joint.mechanism.motion);
        const bool audited =
            t.source == CommandSource::logged && t.has_reference && (t.ticks_per_row == 1 || t.rebuilt);
        const auto wanted = audited ? command_of(plant, t) : std::vector<double>();
        const double per_command =
            plant.dc_motor() ? plant.actuator.k_t / plant.actuator.resistance *
                                   (plant.actuator.signal == DriveSignal::duty ? plant.actuator.supply_voltage : 1)
                             : plant.actuator.effort_gain;
        Innovation innovation;
        predict(plant, t, known_command(plant, t), omega, innovation);
        const double inertia = plant.motor_inertia + (plant.two_mass ? plant.link_inertia : 0);
        const double to_force = inertia * omega * omega;
        const double motion_floor = std::pow(to_force * c.sigma, 2) * noise_amplification(omega, c.row_step);
        const double effort_square = std::pow(effort_floor(c, omega), 2);
        const double step = audited ? command_step(t) : 0, command_floor = std::pow(per_command * step, 2) / 12;
        Block block(3, 0);
        double started = t.size() ? t.time[0] : 0;
        for (std::size_t k = 0; k < t.size(); ++k) {
            if (!t.logged[k]) continue;
            if (t.time[k] - started > block_seconds) {
                blocks.push_back(block);
                block.assign(3, 0);
                started = t.time[k];
            }
            const auto count = [&](std::size_t stage, double error, double floor) {
                if (!std::isfinite(error)) return;
                block[stage] += error * error - floor;
                squares[stage] += error * error;
                floors[stage] += floor;
                counts[stage] += 1;
            };
            if (audited && t.enabled[k]) count(0, per_command * (t.command[k] - wanted[k]), command_floor);
            if (c.effort_sigma > 0) count(1, innovation.effort[k], effort_square);
            count(2, to_force * innovation.position[k], motion_floor);
        }
        blocks.push_back(block);
    }
    add_shares(shares, blocks, 3);
    for (std::size_t s = 0; s < 3; ++s)
        if (counts[s] > 0) {
            shares[s].rms = std::sqrt(squares[s] / counts[s]);
            shares[s].floor = std::sqrt(floors[s] / counts[s]);
        }
    for (std::size_t s = 3; s-- > 0;)
        if (counts[s] == 0) shares.erase(shares.begin() + static_cast<std::ptrdiff_t>(s));
    return shares;
}

std::vector<Share> locate_regimes(const std::vector<Case>& cases)
{
    static const char* const names[] = {
        "stuck",    "low speed", "sliding", "reversal", "positive direction", "negative direction", "high acceleration",
        "saturated"};
    constexpr std::size_t exclusive = 3, all = std::size(names);
    std::vector<Share> shares(all);
    for (std::size_t i = 0; i < all; ++i) shares[i].name = names[i], shares[i].unit = "floors";
    std::vector<double> squares(all, 0), counts(all, 0);
    std::vector<Block> blocks;
    for (const auto& c : cases) {
        const Plant plant = flatten(c.joint);
        const Ticks& t = c.ticks;
        const auto command = known_command(plant, t);
        Innovation innovation;
        predict(plant, t, command, omega, innovation);
        std::vector<double> speeds, accelerations(t.size(), 0);
        for (double v : innovation.velocity) speeds.push_back(std::abs(v));
        std::sort(speeds.begin(), speeds.end());
        const double fast = speeds.empty() ? 1 : speeds[speeds.size() * 19 / 20];
        for (std::size_t k = 5; k + 5 < t.size(); ++k)
            accelerations[k] = std::abs(innovation.velocity[k + 5] - innovation.velocity[k - 5]);
        std::vector<double> sorted = accelerations;
        std::sort(sorted.begin(), sorted.end());
        const double hard = sorted.empty() ? 1 : sorted[sorted.size() * 9 / 10];
        double largest = 0;
        for (double u : command) largest = std::max(largest, std::abs(u));
        const double limit = std::min({plant.control.effort_limit,
                                       plant.actuator.limit / std::abs(plant.actuator.effort_gain), 1.0001 * largest});
        const double floor = c.sigma * c.sigma * noise_amplification(omega, c.row_step);
        Block block(all, 0);
        double started = t.size() ? t.time[0] : 0, reversed = -infinity, sign = 0;
        for (std::size_t k = 0; k < t.size(); ++k) {
            const double v = innovation.velocity[k], speed = std::abs(v);
            if (speed > 0.005 * fast && v * sign < 0) reversed = t.time[k];
            if (speed > 0.005 * fast) sign = v;
            if (!t.logged[k]) continue;
            if (t.time[k] - started > block_seconds) {
                blocks.push_back(block);
                block.assign(all, 0);
                started = t.time[k];
            }
            constexpr double after_reversal = 0.1;  // s
            const bool in[all] = {speed < 0.005 * fast,
                                  speed >= 0.005 * fast && speed < 0.2 * fast,
                                  speed >= 0.2 * fast,
                                  t.time[k] - reversed<after_reversal, v> 0.005 * fast,
                                  v<-0.005 * fast, accelerations[k]>
                                      hard,
                                  std::abs(command[k]) >= 0.999 * limit};
            const double excess = innovation.position[k] * innovation.position[k] / floor - 1;
            for (std::size_t i = 0; i < all; ++i)
                if (in[i]) block[i] += excess, squares[i] += excess + 1, counts[i] += 1;
        }
        blocks.push_back(block);
    }
    add_shares(shares, blocks, exclusive);
    for (std::size_t i = 0; i < all; ++i) {
        shares[i].rms = counts[i] > 0 ? std::sqrt(squares[i] / counts[i]) : 0;
        shares[i].floor = 1;
    }
    return shares;
}

}  // namespace stickslip::gap
