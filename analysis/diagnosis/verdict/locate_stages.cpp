#include "analysis/diagnosis/verdict/locate_stages.h"

#include "analysis/diagnosis/audit/audit.h"
#include "analysis/diagnosis/verdict/shares.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

constexpr double omega = 50;  // numerical: rad/s, at which the residual force is read

/// What a controller had filtered before the first row was not logged; it forgets.
double forgets_at(const Control& control, const Ticks& t)
{
    constexpr double memories = 15;  // numerical: e⁻¹⁵ of it is left
    if (t.at_rest || t.size() == 0) return -infinity;
    return t.time[0] + memories * (control.velocity_estimate.tau + t.step[0]);
}

}  // namespace

double share_of_controller(const std::vector<Share>& signals)
{
    const auto found = std::ranges::find(signals, "effort", &Share::name);
    return found == signals.end() ? 0 : found->share;
}

namespace {

/// Of the documented filter, whichever one made the logged velocities.
std::vector<double> documented_command(const Plant& plant, const Ticks& ticks)
{
    if (!ticks.own_velocity) return command_of(plant, ticks);
    Ticks unbelieved = ticks;
    unbelieved.own_velocity = false;
    return command_of(plant, unbelieved);
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
        for (auto& s : shares) s.unit = unit_of(Quantity::effort, Units(c.joint.mechanism.motion));
        const bool audited = t.source == CommandSource::logged && t.has_reference && !t.unseen_between();
        const auto wanted = audited ? documented_command(plant, t) : std::vector<double>();
        const double per_command = plant.effort_per_command();
        Innovation innovation;
        predict(plant, t, known_command(plant, t), omega, innovation);
        const double to_force = plant.driven_inertia() * omega * omega;
        const double motion_floor =
            std::pow(to_force * reading_floor(c, omega), 2) * noise_amplification(omega, c.row_step);
        const double effort_square = std::pow(effort_floor(c, omega), 2);
        const double step = audited ? command_step(t) : 0, command_floor = std::pow(per_command * step, 2) / 12;
        Block block(3, 0);
        double started = t.size() ? t.time[0] : 0;
        const double forgotten = forgets_at(plant.control, t);
        std::size_t row = 0;
        for (std::size_t k = 0; k < t.size(); ++k) {
            if (!t.logged[k]) continue;
            const double of_controller = row < c.controller_error.size() ? c.controller_error[row++] : not_set;
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
            if (audited && t.enabled[k] && t.time[k] > forgotten)
                count(0, per_command * (t.command[k] - wanted[k]), command_floor);
            if (c.effort_sigma > 0) count(1, innovation.effort[k], effort_square);
            count(1, of_controller, c.drive_sigma * c.drive_sigma);
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

}  // namespace stickslip::gap
