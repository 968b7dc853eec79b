#include "analysis/diagnosis/heldout/drive_force.h"

#include "analysis/diagnosis/fit/problem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace stickslip::gap {
namespace {

constexpr std::size_t level = 1;        // where models were fitted
constexpr double observer = levels[0];  // numerical: rad/s
constexpr int iterations = 4;
constexpr double settling = 5;  // numerical: periods of the corner that are removed at both ends of a record

/// One section of second order, forwards in place.
void filter(std::vector<double>& x, double corner, double rate, double quality)
{
    const double w = 2 * std::numbers::pi * corner / rate, alpha = std::sin(w) / (2 * quality), c = std::cos(w);
    const double b = (1 - c) / 2 / (1 + alpha), a1 = -2 * c / (1 + alpha), a2 = (1 - alpha) / (1 + alpha);
    double x1 = x.front(), x2 = x1, y1 = x1, y2 = x1;
    for (double& value : x) {
        const double y = b * (value + 2 * x1 + x2) - a1 * y1 - a2 * y2;
        x2 = x1, x1 = value;
        y2 = y1, y1 = y;
        value = y;
    }
}

void low_pass(std::vector<double>& x, double corner, double rate)
{
    // sections of a Butterworth filter of fourth order
    for (int way = 0; way < 2; ++way) {
        for (const double quality : {0.54119610, 1.3065630}) filter(x, corner, rate, quality);
        std::reverse(x.begin(), x.end());
    }
}

/// Mean squares of the missing force in every fold, refitted without it.
std::vector<double> squares_of(const std::vector<Case>& cases, const std::vector<Fold>& folds, const Scales& scales,
                               const Attribution& a, double corner)
{
    std::vector<double> squares;
    for (const auto& fold : folds) {
        const Case& c = cases[fold.record];
        const auto x = descend({without(cases, fold), a.candidate, scales, observer}, a.x[level], iterations).x;
        const auto force =
            missing_force(c, edited(c.joint, a.candidate, in_si(a.candidate, x, scales), c.number), corner);
        double sum = 0, n = 0;
        std::size_t row = 0;
        for (std::size_t k = 0; k < c.ticks.size(); ++k) {
            if (!c.ticks.logged[k]) continue;
            const double f = force[row++], t = c.ticks.time[k];
            if (std::isfinite(f) && t >= fold.from && t < fold.to) sum += f * f, n += 1;
        }
        squares.push_back(sum / std::max(n, 1.0));
    }
    return squares;
}

double rms(const std::vector<double>& squares)
{
    double sum = 0;
    for (double s : squares) sum += s;
    return std::sqrt(sum / static_cast<double>(squares.size()));
}

}  // namespace

std::vector<double> missing_force(const Case& c, const Joint& joint, double corner)
{
    const Plant plant = flatten(joint);
    const double inertia = plant.driven_inertia();
    const double T = c.row_step, held = std::min(T, 0.5 / observer);
    const double g = 1.6 * observer * held, k = observer * observer * held;
    Innovation innovation;
    predict(plant, c.ticks, known_command(plant, c.ticks), observer, innovation);
    std::vector<double> e;
    for (std::size_t i = 0; i < c.ticks.size(); ++i)
        if (c.ticks.logged[i]) e.push_back(innovation.position[i]);
    std::vector<double> force(e.size(), 0);
    for (std::size_t n = 1; n + 1 < e.size(); ++n)
        force[n] = inertia * ((e[n + 1] - (2 - g) * e[n] + (1 - g) * e[n - 1]) / (T * T) + k * e[n] / T);
    low_pass(force, corner, 1 / T);
    const auto ends = std::min(force.size() / 2, static_cast<std::size_t>(settling / corner / T) + 1);
    for (std::size_t n = 0; n < ends; ++n) force[n] = force[force.size() - 1 - n] = not_set;
    return force;
}

double drive_force_corner(const std::vector<Case>& cases)
{
    constexpr double highest = 100;  // numerical: Hz
    double corner = highest;
    for (const auto& c : cases) corner = c.ticks.regular ? std::min(corner, 0.1 / c.row_step) : 0;
    return corner;
}

std::vector<DriveForce> hold_out_drive_force(const Fit& fit, const std::vector<const Attribution*>& models)
{
    const Scales& scales = fit.scales;
    const double corner = drive_force_corner(fit.cases);
    std::vector<Case> cases = fit.cases;
    const auto folds = folds_of(cases);
    const auto si = in_si(models[0]->candidate, models[0]->x[level], scales);
    const auto now = evaluate(cases, models[0]->candidate, si, observer);
    for (std::size_t i = 0; i < cases.size();
         ++i) {  // what the first model leaves is the noise: no record drowns others
        const double left = std::sqrt(std::max(now.records[i].position, 1e-12));
        cases[i].sigma *= left, cases[i].drive_sigma *= left;
        if (cases[i].effort_sigma > 0) cases[i].effort_sigma *= std::sqrt(std::max(now.records[i].effort, 1e-12));
    }
    std::vector<std::vector<double>> squares(models.size());
    fit.parallel(squares.size(),
                 [&](std::size_t i) { squares[i] = squares_of(cases, folds, scales, *models[i], corner); });
    std::vector<DriveForce> result;
    for (const auto& own : squares) {
        DriveForce force{rms(own), 1 - rms(own) / rms(squares[0]), {1, -infinity}};
        for (std::size_t f = 0; f < own.size(); ++f) {
            const double gain = 1 - std::sqrt(own[f] / squares[0][f]);
            force.spread.low = std::min(force.spread.low, gain), force.spread.high = std::max(force.spread.high, gain);
        }
        result.push_back(force);
    }
    return result;
}

}  // namespace stickslip::gap
