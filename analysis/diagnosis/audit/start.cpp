#include "analysis/diagnosis/audit/start.h"

#include "analysis/diagnosis/audit/after_hole.h"
#include "analysis/diagnosis/plant/controller.h"
#include "analysis/diagnosis/policy/audit.h"
#include "analysis/diagnosis/records/start_velocity.h"
#include "analysis/numerics/statistics.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

/// Mean square of what the first rows are off the prediction, in units of a reading's.
double missed_at_start(const Case& c)
{
    constexpr std::size_t rows = 10;
    constexpr double omega = 20;  // numerical: rad/s, hardly corrects within these rows
    std::size_t ticks = 0, seen = 0;
    while (ticks < c.ticks.size() && seen < rows) seen += c.ticks.logged[ticks++];
    const Ticks first = first_ticks(c.ticks, ticks);
    const Plant plant = flatten(c.joint);
    Innovation innovation;
    predict(plant, first, known_command(plant, first), omega, innovation);
    double sum = 0;
    for (std::size_t k = 0; k < ticks; ++k)
        if (first.logged[k]) sum += innovation.position[k] * innovation.position[k];
    return sum / (static_cast<double>(rows) * c.sigma * c.sigma);
}

}  // namespace

void find_start(Case& c, std::vector<Note>& notes)
{
    const double at_rest = missed_at_start(c);
    if (!(at_rest > policy::missed_at_rest)) return;
    Case moving = c;
    start_moving(moving.ticks);
    if (!(missed_at_start(moving) < policy::left_by_motion * at_rest)) return;
    c.ticks = std::move(moving.ticks);
    notes.push_back({Note::Code::starts_moving, c.ticks.name});
}

void find_integral(Case& c)
{
    Ticks& t = c.ticks;
    Controller controller(c.joint);
    if (!controller.integrates() || !t.has_reference || t.source != CommandSource::logged) return;
    t.initial_integral = 0;  // what another controller than this one would have held
    if (t.at_rest)
        controller.restart();
    else
        controller.restart_moving(t.position[0], t.initial_velocity, t.step[0], 0);
    constexpr std::size_t rows = 20;
    std::vector<double> beyond;
    double largest = 0;
    AfterHole hole(t, c.joint.control);
    const double limit = policy::below_limit * c.joint.control.effort_limit;
    for (std::size_t k = 0; k < t.size() && beyond.size() < rows; ++k) {
        const double exact = is_set(t.velocity[k]) ? t.velocity[k] : 0;
        controller.read(t.position[k], k == 0 ? t.step[0] : t.step[k - 1], exact);
        if (t.velocity_believed() && is_set(t.velocity[k])) controller.believe(t.velocity[k]);
        controller.command(t.reference[k], t.reference_rate[k], t.added(k), t.time[k]);
        if (hole.holds(k) || !is_set(t.command[k]) || std::abs(t.command[k]) > limit || !t.enabled[k]) continue;
        beyond.push_back(t.command[k] - controller.wanted());
        largest = std::max(largest, std::abs(t.command[k]));
    }
    if (beyond.size() < rows) return;
    const double held = median(beyond);
    std::vector<double> apart;
    for (const double b : beyond) apart.push_back(std::abs(b - held));
    constexpr double digits = 1e-6;  // numerical: of the largest command
    if (median(apart) > policy::held_at_start * std::abs(held) || std::abs(held) < digits * largest) return;
    t.initial_integral = held / controller.integral_gain();
}

}  // namespace stickslip::gap
