#include "analysis/diagnosis/outcomes/law_fit.h"

#include "analysis/diagnosis/outcomes/law_cost.h"

#include "analysis/diagnosis/outcomes/rivals.h"
#include "analysis/diagnosis/policy/outcomes_and_rigs.h"
#include "analysis/numerics/optimise.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/stability/verdict.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

/// Where nothing damps, the end of a motion is a matter of its start. The table's motions start from rest: a trace of
/// damping leaves them as they are, and lets the question have an answer.
NonlinearVerdict motion_of(Joint joint)
{
    constexpr double trace = 1e-4;  // numerical: of √(k_p m): a six-thousandth of the swing is lost in half a turn
    if (growth_rate(joint) == 0) joint.control.k_v += trace * std::sqrt(joint.control.k_p * joint.mechanism.inertia);
    NonlinearOptions options;
    options.disturbance = {DisturbanceKind::start, 1e-4};
    options.region = false;
    options.rtol = 1e-6;
    options.turn_limit = 100;  // rows this close to their boundary say nothing
    return nonlinear_verdict(joint, options);
}

bool slides(Outcome outcome)
{
    return outcome == Outcome::stable_sliding;
}

bool sticks(Outcome outcome)
{
    return outcome == Outcome::stick_slip || outcome == Outcome::limit_cycle || outcome == Outcome::reversal ||
           outcome == Outcome::period_n || outcome == Outcome::irregular;
}

/// Log-likelihood of one measured amplitude, less that of a perfect one.
double amplitude_score(double predicted, double measured)
{
    if (!(predicted > 0)) return -policy::worst_amplitude;
    return -std::min<double>(policy::worst_amplitude,
                             std::abs(std::log(predicted / measured)) / policy::amplitude_spread);
}

/// Rows with a measured amplitude: every second of the first few is fitted to, the rest judge.
struct AmplitudeRows {
    std::vector<std::size_t> fitted, held;
};

AmplitudeRows amplitude_rows(const Outcomes& o)
{
    AmplitudeRows rows;
    std::size_t k = 0;
    for (std::size_t i = 0; i < o.size(); ++i)
        if (o.table.rows[i].stick_slip && o.table.rows[i].amplitude > 0)
            (k++ % 2 == 0 ? rows.fitted : rows.held).push_back(i);
    constexpr std::size_t most_fitted = 4;
    while (rows.fitted.size() > most_fitted) rows.held.push_back(rows.fitted.back()), rows.fitted.pop_back();
    return rows;
}

}  // namespace

double guessed_amplitudes(const Outcomes& o)
{
    const auto rows = amplitude_rows(o).held;
    double middle = 0, score = 0;
    for (std::size_t i : rows) middle += std::log(o.table.rows[i].amplitude) / static_cast<double>(rows.size());
    for (std::size_t i : rows) score += amplitude_score(std::exp(middle), o.table.rows[i].amplitude);
    return score;
}

void confirm_by_motion(const Outcomes& o, LawFit& fit)
{
    fit.followed = true;
    const AmplitudeRows measured = amplitude_rows(o);
    const auto &fitted = measured.fitted, &held = measured.held;
    const bool stretch = fit.rival && fit.rival->scale >= 0 && !fitted.empty();
    if (stretch) {
        const auto place = static_cast<std::size_t>(fit.rival->scale);
        const auto& number = fit.rival->numbers[place];
        const auto rows = all_rows(o);
        const auto at = [&](double s) {
            auto x = fit.x;
            x[place] = s;
            const FrictionLaw law = fit.rival->make(o.scales, x.data());
            double sum = cost(o, *fit.rival, rows, x);
            for (std::size_t i : fitted)
                sum -= amplitude_score(motion_of(with_law(o.joints[i], law)).amplitude, o.table.rows[i].amplitude);
            return sum;
        };
        const Bounds box{{number.low}, {number.high}};
        const Objective objective = [&](const std::vector<double>& s) { return at(s[0]); };
        constexpr int look = 14, refine = 16;
        double best = fit.x[place], least = at(best);
        for (int k = 0; k <= look; ++k) {
            const double s = number.low + (number.high - number.low) * k / look;
            const double value = at(s);
            if (value < least) best = s, least = value;
        }
        fit.x[place] = local_minimum(objective, box, {best}, 0.03, refine)[0];
        fit.law = fit.rival->make(o.scales, fit.x.data());
        fit.values = fit.rival->values(fit.law);
        fit.standard_error = standard_errors(o, *fit.rival, fit.x);
        // the number was a free one of the boundary: what the boundary says of the held-out rows moves with it
        const auto before = fit.distance;
        fit.distance = distances(o, fit.law, rows);
        for (std::size_t i = 0; i < o.size(); ++i)
            if ((before[i] > 0) != (fit.distance[i] > 0))
                fit.probability[i] = probability_at(fit.distance[i], fit.softness);
    }
    judge(o, fit);
    const bool memory = fit.rival ? fit.rival->memory : stickslip::states(fit.law) > 0;
    for (std::size_t i = 0; i < o.size(); ++i) {
        const bool asked = o.table.rows[i].amplitude > 0 && o.table.rows[i].stick_slip;
        if (!asked && !(memory && std::abs(fit.distance[i]) < policy::near_stick_slip)) continue;
        if (o.checkpoint) o.checkpoint();
        const Joint joint = fit.rival ? with_law(o.joints[i], fit.law) : o.joints[i];
        const auto verdict = motion_of(joint);
        if (asked) fit.amplitude[i] = verdict.amplitude;
        const bool linear_slides = fit.distance[i] <= 0;
        const bool otherwise =
            (slides(verdict.outcome) && !linear_slides) || (sticks(verdict.outcome) && linear_slides);
        if (!memory || !otherwise) continue;
        ++fit.beyond_linear;
        // a motion that was followed outweighs the linear side of a row
        const bool sided = (fit.probability[i] > policy::likelier_than_not) == !linear_slides;
        if (sided) fit.probability[i] = 1 - fit.probability[i];
    }
    judge(o, fit);
    for (std::size_t i : held) fit.amplitude_held_out += amplitude_score(fit.amplitude[i], o.table.rows[i].amplitude);
}

}  // namespace stickslip::gap
