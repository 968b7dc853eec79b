#include "analysis/diagnosis/audit/align_log.h"

#include "analysis/diagnosis/audit/command_terms.h"
#include "analysis/diagnosis/audit/gain_regression.h"
#include "analysis/diagnosis/plant/controller.h"
#include "analysis/diagnosis/policy/audit.h"
#include "analysis/numerics/line_search.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace stickslip::gap {
namespace {

constexpr int most_ticks = 3;                           // numerical: of a shift; a later one is a delay of the joint
constexpr double least_scale = 0.8, most_scale = 1.25;  // numerical: as far as a scale of the encoder is looked for
constexpr double scale_step = 0.005;                    // numerical: of the first search

/// What is left of the command by the controller: with the gains that fit best where it has no terms but them.
double misfit_of(const std::vector<Case>& cases, double limit)
{
    const Control& control = cases[0].joint.control;
    if (is_plain(control)) return mean_misfit(gains_of(cases, control.velocity_estimate.tau, limit));
    return fit_terms(command_terms(cases, control.dead_zone, limit), {}).misfit;
}

/// The reference of so many ticks later; before the log it went on as it does at its start.
std::vector<double> later(const std::vector<double>& of, int ticks)
{
    std::vector<double> shifted(of.size());
    const auto last = static_cast<std::ptrdiff_t>(of.size()) - 1;
    const auto at = [&](std::ptrdiff_t k) { return of[static_cast<std::size_t>(k)]; };
    for (std::ptrdiff_t k = 0; k <= last; ++k) {
        const std::ptrdiff_t wanted = k + ticks, near = std::clamp<std::ptrdiff_t>(wanted, 1, last);
        const double step = at(near) - at(near - 1);
        shifted[static_cast<std::size_t>(k)] =
            wanted == near ? at(near) : at(near) + static_cast<double>(wanted - near) * step;
    }
    return shifted;
}

std::vector<Case> with_reference_later(std::vector<Case> cases, int ticks)
{
    for (auto& c : cases) {
        c.ticks.reference = later(c.ticks.reference, ticks);
        c.ticks.reference_rate = later(c.ticks.reference_rate, ticks);
        // what the last commands followed was never logged
        if (ticks > 0) c.ticks = first_ticks(c.ticks, c.ticks.size() - static_cast<std::size_t>(ticks));
    }
    return cases;
}

std::vector<Case> with_positions_over(std::vector<Case> cases, double scale)
{
    for (auto& c : cases) {
        for (double& y : c.ticks.position) y /= scale;
        for (double& v : c.ticks.velocity) v /= scale;
        c.ticks.initial_velocity /= scale, c.ticks.initial_acceleration /= scale;
    }
    return cases;
}

/// The shift that leaves little, or hardly anything of what all others leave.
bool align_reference(std::vector<Case>& cases, double limit, double as_logged, Audit& result)
{
    int best = 0;
    double least = as_logged, next = infinity;
    for (int ticks = -most_ticks; ticks <= most_ticks; ++ticks) {
        if (ticks == 0) continue;
        const double misfit = misfit_of(with_reference_later(cases, ticks), limit);
        if (misfit < least)
            next = least, least = misfit, best = ticks;
        else
            next = std::min(next, misfit);
    }
    const bool clearly = least <= policy::much_better * policy::much_better * next;
    if (best == 0 || least > policy::much_better * as_logged || (least > policy::understood && !clearly)) return false;
    cases = with_reference_later(std::move(cases), best);
    const double period = cases[0].ticks.step[0];
    result.notes.push_back({.code = best > 0 ? Note::Code::reference_late : Note::Code::reference_early,
                            .values = {std::abs(static_cast<double>(best)), std::abs(best) * period}});
    return true;
}

bool align_scale(std::vector<Case>& cases, double limit, double enough, Audit& result)
{
    const auto misfit = [&](double scale) { return misfit_of(with_positions_over(cases, scale), limit); };
    double best = 1, least = infinity;
    for (double scale = least_scale; scale <= most_scale; scale += scale_step)
        if (const double m = misfit(scale); m < least) least = m, best = scale;
    const double scale = least_between(best - scale_step, best + scale_step, misfit);
    if (std::abs(scale - 1) <= policy::flagged_gain || misfit(scale) > enough) return false;
    cases = with_positions_over(std::move(cases), scale);
    result.notes.push_back({.code = Note::Code::positions_scaled, .values = {scale}});
    return true;
}

}  // namespace

void align_log(std::vector<Case>& cases, double limit, Audit& result)
{
    const bool every_tick = std::ranges::all_of(cases, [](const Case& c) {
        return c.ticks.regular && !c.ticks.unseen_between() && c.ticks.size() > most_ticks + 1;
    });
    if (!every_tick) return;
    const double as_logged = misfit_of(cases, limit), enough = policy::much_better * as_logged;
    if (as_logged <= policy::understood) return;
    const double understood = std::min(enough, policy::understood);
    if (!align_reference(cases, limit, as_logged, result)) align_scale(cases, limit, understood, result);
}

}  // namespace stickslip::gap
