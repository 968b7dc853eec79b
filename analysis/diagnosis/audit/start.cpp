#include "analysis/diagnosis/audit/start.h"

#include "analysis/diagnosis/records/start_velocity.h"

namespace stickslip::gap {
namespace {

/// Mean square of what the first rows are off the prediction, in units of a reading's.
double missed_at_start(const Case& c)
{
    constexpr std::size_t rows = 10;
    constexpr double omega = 20;  // rad/s: hardly corrects within these rows
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
    // mean square; of that of rest: an unmodelled force that sets a joint in motion leaves a sixth
    constexpr double clearly = 25, much_better = 0.05;
    const double at_rest = missed_at_start(c);
    if (!(at_rest > clearly)) return;
    Case moving = c;
    start_moving(moving.ticks);
    if (!(missed_at_start(moving) < much_better * at_rest)) return;
    c.ticks = std::move(moving.ticks);
    notes.push_back({Note::Code::starts_moving, c.ticks.name});
}

}  // namespace stickslip::gap
