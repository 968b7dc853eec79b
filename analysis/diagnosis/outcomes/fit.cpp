#include "analysis/diagnosis/outcomes/fit.h"

#include "analysis/diagnosis/outcomes/side.h"
#include "analysis/numerics/optimise.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/stability/verdict.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

constexpr double least_softness = 0.02, most_softness = 0.6;
constexpr int folds = 5;
constexpr double usual_rows = 40;

double log_probability(double p, bool stick_slip)
{
    return std::log(stick_slip ? p : 1 - p);
}

std::vector<double> distances(const Outcomes& o, const FrictionLaw& law, const std::vector<std::size_t>& rows)
{
    std::vector<double> d;
    for (std::size_t i : rows) {
        if (o.checkpoint) o.checkpoint();
        d.push_back(distance_to_stick_slip(with_law(o.joints[i], law)));
    }
    return d;
}

std::vector<std::size_t> all_rows(const Outcomes& o)
{
    std::vector<std::size_t> rows(o.size());
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = i;
    return rows;
}

/// Rows in the order of their settings, dealt out in turn: every fold spans the whole table.
std::vector<int> dealt(const Outcomes& o)
{
    auto order = all_rows(o);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const auto &x = o.table.rows[a], &y = o.table.rows[b];
        return x.stick_slip != y.stick_slip ? x.stick_slip < y.stick_slip : x.settings < y.settings;
    });
    std::vector<int> fold(o.size());
    for (std::size_t i = 0; i < order.size(); ++i) fold[order[i]] = static_cast<int>(i % folds);
    return fold;
}

/// −log posterior: rows, and a wide Gaussian around usual numbers that keeps undetermined ones in place.
double cost(const Outcomes& o, const RivalLaw& rival, const std::vector<std::size_t>& rows,
            const std::vector<double>& x)
{
    const auto d = distances(o, rival.make(o.scales, x.data()), rows);
    const double softness = std::exp(x.back());
    double sum = 0;
    for (std::size_t k = 0; k < rows.size(); ++k)
        sum -= log_probability(probability_at(d[k], softness), o.table.rows[rows[k]].stick_slip);
    for (std::size_t i = 0; i < rival.numbers.size(); ++i) {
        const double half = (rival.numbers[i].high - rival.numbers[i].low) / 2;
        const double away = (x[i] - rival.numbers[i].low) / half - 1;
        sum += 0.5 * away * away;
    }
    return sum;
}

Bounds bounds_of(const RivalLaw& rival)
{
    Bounds b;
    for (const auto& n : rival.numbers) b.low.push_back(n.low), b.high.push_back(n.high);
    b.low.push_back(std::log(least_softness)), b.high.push_back(std::log(most_softness));
    return b;
}

std::vector<double> descended(const Objective& objective, const Bounds& bounds, std::vector<double> x, int evaluations)
{
    x = local_minimum(objective, bounds, std::move(x), 0.1, evaluations);
    return local_minimum(objective, bounds, std::move(x), 0.02, evaluations / 2);
}

/// Standard errors of the SI values from the curvature of the cost; a flat direction gets what the prior leaves.
std::vector<double> standard_errors(const Outcomes& o, const RivalLaw& rival, const std::vector<double>& x)
{
    const auto rows = all_rows(o);
    const auto n = static_cast<Eigen::Index>(x.size());
    const auto at = [&](Eigen::Index i, double a, Eigen::Index j, double b) {
        auto y = x;
        y[static_cast<std::size_t>(i)] += a;
        y[static_cast<std::size_t>(j)] += b;
        return cost(o, rival, rows, y);
    };
    constexpr double h = 0.05;  // log units: wide enough to average over single rows
    Eigen::MatrixXd curvature(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j <= i; ++j)
            curvature(i, j) = curvature(j, i) =
                (at(i, h, j, h) - at(i, h, j, -h) - at(i, -h, j, h) + at(i, -h, j, -h)) / (4 * h * h);
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(curvature);
    Eigen::VectorXd variance = eigen.eigenvalues();
    constexpr double flattest = 0.04;  // a standard deviation of 5 in a logarithm: not determined
    for (auto& v : variance) v = 1 / std::max(v, flattest);
    const Eigen::MatrixXd covariance = eigen.eigenvectors() * variance.asDiagonal() * eigen.eigenvectors().transpose();
    const auto middle = rival.values(rival.make(o.scales, x.data()));
    Eigen::MatrixXd jacobian(static_cast<Eigen::Index>(middle.size()), n);
    for (Eigen::Index j = 0; j < n; ++j) {
        auto y = x;
        y[static_cast<std::size_t>(j)] += 1e-5;
        const auto moved = rival.values(rival.make(o.scales, y.data()));
        for (std::size_t i = 0; i < middle.size(); ++i)
            jacobian(static_cast<Eigen::Index>(i), j) = (moved[i] - middle[i]) / 1e-5;
    }
    const Eigen::VectorXd squares = (jacobian * covariance * jacobian.transpose()).diagonal();
    std::vector<double> errors;
    for (double s : squares) errors.push_back(std::sqrt(s));
    return errors;
}

void judge(const Outcomes& o, LawFit& fit)
{
    fit.held_out = 0, fit.misjudged = 0;
    for (std::size_t i = 0; i < o.size(); ++i) {
        const bool stick_slip = o.table.rows[i].stick_slip;
        fit.held_out += log_probability(fit.probability[i], stick_slip);
        fit.misjudged += (fit.probability[i] > 0.5) != stick_slip;
    }
}

/// Where nothing damps, the end of a motion is a matter of its start. The table's motions start from rest: a trace of
/// damping leaves them as they are, and lets the question have an answer.
NonlinearVerdict motion_of(Joint joint)
{
    constexpr double trace = 1e-4;  // of √(k_p m): a six-thousandth of the swing is lost in half a turn
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

constexpr double amplitude_spread = 0.15;  // of ln amplitude: what a repeated measurement would differ by

/// Log-likelihood of one measured amplitude, less that of a perfect one.
double amplitude_score(double predicted, double measured)
{
    if (!(predicted > 0)) return -worst_amplitude;
    return -std::min(worst_amplitude, std::abs(std::log(predicted / measured)) / amplitude_spread);
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

double probability_at(double distance, double softness)
{
    if (std::isnan(distance)) return 0.5;
    return wrong_rows / 2 + (1 - wrong_rows) / (1 + std::exp(-std::clamp(distance / softness, -50.0, 50.0)));
}

Joint with_law(const Joint& joint, const FrictionLaw& law)
{
    Joint changed = joint;
    changed.friction = {};
    changed.friction.law = law;
    return changed;
}

LawFit fit_law(const Outcomes& o, const RivalLaw& rival)
{
    LawFit fit;
    fit.rival = &rival;
    const auto bounds = bounds_of(rival);
    const double share = rival.effort * std::clamp(usual_rows / static_cast<double>(o.size()), 0.1, 1.0);
    const auto work = [&](double evaluations) { return std::max(20, static_cast<int>(evaluations * share)); };
    const auto rows = all_rows(o);
    const Objective whole = [&](const std::vector<double>& x) { return cost(o, rival, rows, x); };
    fit.x = descended(whole, bounds, global_minimum(whole, bounds, work(2500)), work(1200));
    fit.law = rival.make(o.scales, fit.x.data());
    fit.softness = std::exp(fit.x.back());
    fit.values = rival.values(fit.law);
    fit.standard_error = standard_errors(o, rival, fit.x);
    fit.distance = distances(o, fit.law, rows);
    fit.probability.resize(o.size());
    const auto fold = dealt(o);
    for (int f = 0; f < folds; ++f) {
        std::vector<std::size_t> in, out;
        for (std::size_t i : rows) (fold[i] == f ? out : in).push_back(i);
        const Objective part = [&](const std::vector<double>& x) { return cost(o, rival, in, x); };
        const auto x = local_minimum(part, bounds, fit.x, 0.05, work(600));
        const auto d = distances(o, rival.make(o.scales, x.data()), out);
        for (std::size_t k = 0; k < out.size(); ++k) fit.probability[out[k]] = probability_at(d[k], std::exp(x.back()));
    }
    fit.amplitude.assign(o.size(), not_set);
    judge(o, fit);
    return fit;
}

LawFit judge_nominal_law(const Outcomes& o, const Joint& nominal)
{
    LawFit fit;
    fit.law = nominal.friction.law;
    for (const auto& joint : o.joints) fit.distance.push_back(distance_to_stick_slip(joint));
    const Objective by_softness = [&](const std::vector<double>& x) {
        double sum = 0;
        for (std::size_t i = 0; i < o.size(); ++i)
            sum -= log_probability(probability_at(fit.distance[i], std::exp(x[0])), o.table.rows[i].stick_slip);
        return sum;
    };
    const Bounds bounds{{std::log(least_softness)}, {std::log(most_softness)}};
    fit.softness = std::exp(global_minimum(by_softness, bounds, 100)[0]);
    for (double d : fit.distance) fit.probability.push_back(probability_at(d, fit.softness));
    fit.amplitude.assign(o.size(), not_set);
    judge(o, fit);
    return fit;
}

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
        constexpr double near = 0.5;  // further away small and large disturbances end alike
        if (!asked && !(memory && std::abs(fit.distance[i]) < near)) continue;
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
        const bool sided = (fit.probability[i] > 0.5) == !linear_slides;
        if (sided) fit.probability[i] = 1 - fit.probability[i];
    }
    judge(o, fit);
    for (std::size_t i : held) fit.amplitude_held_out += amplitude_score(fit.amplitude[i], o.table.rows[i].amplitude);
}

}  // namespace stickslip::gap
