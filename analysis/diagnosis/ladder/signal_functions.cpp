#include "analysis/diagnosis/ladder/signal_functions.h"

#include "analysis/diagnosis/fit/seeds.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

constexpr double omega = levels[ladder_level];  // numerical: rad/s
constexpr std::size_t hats_of_position = 12, hats_of_direction = 6, hats_of_velocity = 14, hats_of_time = 8;
constexpr std::size_t waves = 2;
constexpr double creeping = 0.02;  // numerical: of the usual speed: next to standing still
constexpr std::array<double, 4> play_widths{0.003, 0.01, 0.03, 0.1};   // numerical: of the travel
constexpr std::array<double, 4> relaxations{0.005, 0.02, 0.08, 0.32};  // numerical: s
constexpr std::array<double, 2> lags{0.01, 0.05};                      // numerical: s
constexpr double smoothed = 0.015;                                     // numerical: s, on each side

/// A hat function over `count` equally spaced places of [0, 1].
double hat(double x, std::size_t i, std::size_t count)
{
    const double at = std::clamp(x, 0.0, 1.0) * static_cast<double>(count - 1);
    return std::max(0.0, 1 - std::abs(at - static_cast<double>(i)));
}

std::vector<double> low_passed(const std::vector<double>& x, double step, double time)
{
    std::vector<double> y(x.size());
    const double part = 1 - std::exp(-step / time);
    double state = x.empty() ? 0 : x[0];
    for (std::size_t k = 0; k < x.size(); ++k) y[k] = state += part * (x[k] - state);
    return y;
}

/// Where a follower is that the position drags behind it by a play operator of this width.
std::vector<double> followed(const std::vector<double>& q, double width)
{
    std::vector<double> y(q.size());
    double at = q.empty() ? 0 : q[0];
    for (std::size_t k = 0; k < q.size(); ++k) y[k] = at = std::clamp(at, q[k] - 0.5 * width, q[k] + 0.5 * width);
    return y;
}

/// Slope of a line through the neighbourhood.
std::vector<double> slope(const std::vector<double>& x, double step)
{
    const auto n = static_cast<std::ptrdiff_t>(x.size());
    const auto side = std::max<std::ptrdiff_t>(1, std::lround(smoothed / step));
    std::vector<double> y(x.size(), 0);
    double weight = 0;
    for (std::ptrdiff_t j = -side; j <= side; ++j) weight += static_cast<double>(j * j);
    for (std::ptrdiff_t k = side; k + side < n; ++k) {
        double sum = 0;
        for (std::ptrdiff_t j = -side; j <= side; ++j)
            sum += static_cast<double>(j) * x[static_cast<std::size_t>(k + j)];
        y[static_cast<std::size_t>(k)] = sum / weight / step;
    }
    return y;
}

/// The error of an observer that does not know of a force on a free unit mass: see predict().
void as_error(const std::vector<double>& force, double step, Eigen::Ref<Eigen::VectorXd> error)
{
    const double T = std::min(step, 0.5 / omega), g = 1.6 * omega * T, k = omega * omega * T;
    double q = 0, v = 0;
    for (std::size_t n = 0; n < force.size(); ++n) {
        const double e = q;
        error[static_cast<Eigen::Index>(n)] = e;
        q -= g * e, v -= k * e;
        v += step * force[n];
        q += step * v;
    }
}

}  // namespace

FunctionsOfSignals::FunctionsOfSignals(const std::vector<Case>& cases, const Scales& scales, const Candidate& candidate,
                                       const std::vector<double>& si)
    : low_(infinity),
      high_(-infinity),
      speed_(scales.velocity),
      effort_(scales.effort),
      duration_(scales.duration),
      records_(cases.size())
{
    for (const auto& c : cases)
        for (std::size_t k = 0; k < c.ticks.size(); ++k)
            if (c.ticks.logged[k])
                low_ = std::min(low_, c.ticks.position[k]), high_ = std::max(high_, c.ticks.position[k]);
    high_ = std::max(high_, low_ + 1e-12);
    const FitProblem problem{cases, candidate, scales, omega};
    in_time_ = grid_peaks(problem, si, FrequencyGrid::time, waves);
    in_position_ = grid_peaks(problem, si, FrequencyGrid::position, waves);
    forces(signals(cases[0], candidate, si), [&](std::string_view kind, const auto&) { motion_.push_back(kind); });
    drive_.assign(static_cast<std::size_t>(of_drive(signals(cases[0], candidate, si)).cols()), "effort");
}

Signals FunctionsOfSignals::signals(const Case& c, const Candidate& candidate, const std::vector<double>& si) const
{
    Signals s;
    s.record = c.number, s.step = c.row_step;
    Innovation innovation;
    Plant plant = edited_plant(c.joint, candidate, si, c.number);
    predict(plant, c.ticks, known_command(plant, c.ticks), omega, innovation);
    const double per_floor = 1 / (reading_floor(c, omega) * std::sqrt(noise_amplification(omega, c.row_step)));
    const double per_effort = c.effort_sigma > 0 ? 1 / effort_floor(c, omega) : 0;
    const auto rows = static_cast<Eigen::Index>(c.ticks.rows());
    s.position = s.effort = Eigen::VectorXd::Zero(rows);
    Eigen::Index row = 0;
    for (std::size_t k = 0; k < c.ticks.size(); ++k) {
        if (!c.ticks.logged[k]) continue;
        const auto finite = [](double x) { return std::isfinite(x) ? x : 0; };
        s.time.push_back(c.ticks.time[k] - c.ticks.time.front());
        s.reading.push_back(c.ticks.position[k]);
        s.velocity.push_back(finite(innovation.velocity[k]));
        s.drive.push_back(finite(innovation.predicted_effort[k]));
        if (c.judged(k)) {
            s.position[row] = finite(innovation.position[k] * per_floor);
            s.effort[row] = finite(innovation.effort[k] * per_effort);
        }
        ++row;
    }
    s.acceleration = slope(s.velocity, s.step);
    return s;
}

void FunctionsOfSignals::forces(const Signals& s, const Take& take) const
{
    const std::size_t n = s.time.size();
    std::vector<double> moving(n), direction(n), x(n), w(n), u(n), force(n);
    for (std::size_t k = 0; k < n; ++k) {
        const double v = s.velocity[k] / speed_;
        direction[k] = v / std::hypot(v, creeping);
        moving[k] = direction[k] * direction[k];
        x[k] = (s.reading[k] - low_) / (high_ - low_);
        // finer where friction changes fast
        w[k] = 0.5 + 0.5 * std::copysign(std::sqrt(std::min(1.0, std::abs(v) / 1.5)), v);
        u[k] = s.drive[k] / effort_;
    }
    const auto each = [&](std::string_view kind, auto&& value) {
        for (std::size_t k = 0; k < n; ++k) force[k] = value(k);
        take(kind, force);
    };
    for (std::size_t i = 0; i < hats_of_position; ++i)
        each("position", [&](auto k) { return moving[k] * hat(x[k], i, hats_of_position); });
    for (const double number : in_position_) {
        each("position", [&](auto k) { return moving[k] * std::sin(number * s.reading[k]); });
        each("position", [&](auto k) { return moving[k] * std::cos(number * s.reading[k]); });
    }
    for (std::size_t i = 0; i < hats_of_direction; ++i)
        each("direction", [&](auto k) { return direction[k] * hat(x[k], i, hats_of_direction); });
    for (std::size_t i = 0; i < hats_of_velocity; ++i)
        each("velocity", [&](auto k) { return moving[k] * hat(w[k], i, hats_of_velocity); });
    for (const double play : play_widths) {
        const auto follower = followed(s.reading, 2 * play * (high_ - low_));
        each("history", [&](auto k) { return (s.reading[k] - follower[k]) / (play * (high_ - low_)); });
    }
    for (const double time : relaxations) {
        const auto slow = low_passed(direction, s.step, time), speed = low_passed(w, s.step, time);
        each("history", [&](auto k) { return slow[k]; });
        each("history", [&](auto k) { return moving[k] * (speed[k] - w[k]); });
    }
    each("acceleration", [&](auto k) { return s.acceleration[k]; });
    each("acceleration", [&](auto k) { return std::abs(s.acceleration[k]) * direction[k]; });
    for (std::size_t i = 0; i < hats_of_time; ++i)  // an inertia that changes
        each("acceleration", [&](auto k) { return s.acceleration[k] * hat(s.time[k] / duration_, i, hats_of_time); });
    each("effort", [&](auto k) { return moving[k] * u[k]; });
    each("effort", [&](auto k) { return std::abs(u[k]) * direction[k]; });
    each("effort", [&](auto k) { return moving[k] * u[k] * std::abs(u[k]); });
    for (const double lag : lags) {
        const auto late = low_passed(u, s.step, lag);
        each("effort", [&](auto k) { return moving[k] * (u[k] - late[k]); });
    }
    for (std::size_t i = 0; i < hats_of_time; ++i) {
        each("time", [&](auto k) { return moving[k] * hat(s.time[k] / duration_, i, hats_of_time); });
        each("time", [&](auto k) { return direction[k] * hat(s.time[k] / duration_, i, hats_of_time); });
    }
    for (const double frequency : in_time_)
        for (std::size_t r = 0; r < records_; ++r) {  // its phase is another one in every record
            each("time", [&](auto k) { return r == s.record ? moving[k] * std::sin(frequency * s.time[k]) : 0; });
            each("time", [&](auto k) { return r == s.record ? moving[k] * std::cos(frequency * s.time[k]) : 0; });
        }
}

Eigen::MatrixXd FunctionsOfSignals::of_motion(const Signals& s) const
{
    Eigen::MatrixXd columns(static_cast<Eigen::Index>(s.time.size()), static_cast<Eigen::Index>(motion_.size()));
    Eigen::Index i = 0;
    forces(s, [&](std::string_view, const std::vector<double>& force) { as_error(force, s.step, columns.col(i++)); });
    return columns;
}

Eigen::MatrixXd FunctionsOfSignals::of_drive(const Signals& s) const
{
    const auto rows = static_cast<Eigen::Index>(s.time.size());
    std::vector<std::vector<double>> columns(3 + lags.size(), std::vector<double>(s.time.size()));
    for (std::size_t i = 0; i < lags.size(); ++i) columns[3 + i] = low_passed(s.drive, s.step, lags[i]);
    for (std::size_t k = 0; k < s.time.size(); ++k) {
        columns[0][k] = s.drive[k];
        columns[1][k] = s.drive[k] * std::abs(s.drive[k]);
        columns[2][k] = s.velocity[k];
        for (std::size_t i = 0; i < lags.size(); ++i) columns[3 + i][k] = s.drive[k] - columns[3 + i][k];
    }
    Eigen::MatrixXd all(rows, static_cast<Eigen::Index>(columns.size()));
    for (std::size_t i = 0; i < columns.size(); ++i)
        all.col(static_cast<Eigen::Index>(i)) = Eigen::Map<const Eigen::VectorXd>(columns[i].data(), rows);
    return all;
}

}  // namespace stickslip::gap
