#include "analysis/diagnosis/audit/noisy_rows.h"

#include "analysis/diagnosis/audit/reading_noise.h"
#include "analysis/diagnosis/plant/simulator.h"
#include "analysis/diagnosis/policy/audit.h"

#include <cmath>

namespace stickslip::gap {
namespace {

/// Whether the controller gives the commands of the rows but for what it makes of noise.
bool noise_apart(const Case& c, const Ticks& ticks)
{
    const auto own = command_of(flatten(c.joint), ticks);
    double sum = 0, rows = 0;
    for (std::size_t k = 0; k < ticks.size(); ++k)
        if (is_set(ticks.command[k])) sum += std::pow(ticks.command[k] - own[k], 2), rows += 1;
    return rows > 0 && std::sqrt(sum / rows) < policy::noise_of_commands * noise_of_command(c.joint.control, c.sigma);
}

}  // namespace

void mark_noisy_rows(std::vector<Case>& cases)
{
    for (auto& c : cases) {
        if (!c.ticks.unseen_between() || !c.ticks.has_reference || c.ticks.source != CommandSource::logged ||
            c.joint.control.kind != ControlKind::position || !is_set(c.joint.control.period))
            continue;
        Ticks without = c.ticks;
        without.noisy_rows = true;
        c.ticks.noisy_rows = noise_apart(c, without);
    }
}

}  // namespace stickslip::gap
