#include "analysis/diagnosis/audit/continuous_loop.h"

#include "analysis/diagnosis/audit/audit_filter.h"
#include "analysis/diagnosis/audit/command_terms.h"
#include "analysis/diagnosis/policy/audit.h"
#include "analysis/joint/gains.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

/// What the command's misfit is with this form of the velocity and gains of any size.
double misfit_with(EstimateForm form, const Case& c)
{
    std::vector<Case> one{c};
    one[0].joint.control.velocity_estimate.form = form;
    const auto terms = command_terms(one, c.joint.control.dead_zone, c.joint.control.effort_limit);
    return fit_terms(terms, {k_p_term, k_v_term}).misfit;
}

/// Whether the logged velocity is what the controller feeds back, and no filter of the readings made it: a dead time
/// behind the command changes nothing of that.
bool feeds_back_measured_velocity(const Case& c)
{
    const Ticks& t = c.ticks;
    if (!t.has_velocity || !t.has_reference || gains_of(c.joint.control).k_v == 0) return false;
    const double measured = misfit_with(EstimateForm::exact, c);
    return measured < policy::understood &&
           measured < policy::much_less * misfit_with(EstimateForm::backward_difference, c) &&
           !velocities_follow_a_filter({&c});
}

/// Of predictions with held commands the errors are α times their difference to those with straight ones: α is 0 where
/// commands were held, 1 where they were not, unless something else that changes the motion alike is wrong, too.
bool moves_by_straight_commands(const Case& c)
{
    const Plant plant = flatten(c.joint);
    Ticks straight = c.ticks;
    straight.straight_command = true;
    const auto command = known_command(plant, c.ticks);
    Innovation held, other;
    predict(plant, c.ticks, command, levels[0], held);
    predict(plant, straight, command, levels[0], other);
    double ed = 0, dd = 0, ee = 0, rows = 0;
    for (std::size_t k = 0; k < c.ticks.size(); ++k) {
        const double e = held.position[k], d = e - other.position[k];
        if (std::isfinite(e) && std::isfinite(d)) ed += e * d, dd += d * d, ee += e * e, rows += 1;
    }
    if (!(dd > 0)) return false;
    const double alpha = ed / dd, error = std::sqrt(std::max(0.0, ee - alpha * ed) / rows / dd);
    return alpha - policy::straight_errors * error > policy::straight;
}

bool unfiltered(const Case& c)
{
    return c.joint.control.velocity_estimate.tau == 0 && c.ticks.has_velocity;
}

bool runs_without_clock(const Case& c)
{
    if (is_set(c.joint.control.period) || c.ticks.source != CommandSource::logged || c.ticks.unseen_between())
        return false;
    return (unfiltered(c) && feeds_back_measured_velocity(c)) || moves_by_straight_commands(c);
}

}  // namespace

void find_continuous_loop(std::vector<Case>& cases, std::vector<Note>& notes)
{
    if (!std::ranges::all_of(cases, runs_without_clock)) return;
    for (auto& c : cases) {
        c.ticks.straight_command = true;
        if (unfiltered(c)) c.joint.control.velocity_estimate.form = EstimateForm::exact;
        notes.push_back({Note::Code::straight_commands, c.ticks.name});
    }
}

}  // namespace stickslip::gap
