#include "analysis/simulation/flows/past_speeds.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// Share of the time between kinks by which the side of a kink is decided.
constexpr double beside = 1e-9;

/// What rounding leaves of a step is none: per lag, and per time, whose sums of thousands of steps it is.
constexpr double passed_of_lag = 1e-12, passed_of_time = 1e-13;

}  // namespace

void PastSpeeds::set_lag(int body, double lag)
{
    lag_[body] = lag;
    shortest_lag_ = std::min(shortest_lag_, lag);
    longest_lag_ = std::max(longest_lag_, lag);
}

void PastSpeeds::begin(double now, const Speeds& before)
{
    for (int i = 0; i < max_bodies; ++i) history_[i].start(before[i]);
    restart(now);
}

void PastSpeeds::restart(double now)
{
    for (auto& history : history_) history.start(history.velocity_before());
    kinks_.clear();
    piece_from_ = now;
    piece_to_ = infinity;
    note_kink(now);
}

void PastSpeeds::note_kink(double now, int lags)
{
    for (const double lag : lag_)
        for (int k = 1; lag > 0 && k <= lags; ++k) kinks_.insert(now + k * lag);
}

double PastSpeeds::step_limit(double now, const std::array<bool, max_bodies>& rests)
{
    const double passed = now + std::max(passed_of_lag * shortest_lag_, passed_of_time * std::abs(now));
    while (!kinks_.empty() && *kinks_.begin() <= passed) {
        piece_from_ = *kinks_.begin();
        kinks_.erase(kinks_.begin());
    }
    piece_to_ = kinks_.empty() ? infinity : *kinks_.begin();
    double reach = infinity;
    for (int i = 0; i < max_bodies; ++i)
        if (lag_[i] > 0 && !rests[i]) reach = std::min(reach, lag_[i]);
    return std::min(now + reach, piece_to_);
}

void PastSpeeds::append(int i, const SpeedHistory::Step& step)
{
    history_[i].append(step, step.from - kept_lags * lag_[i]);  // both ends of the step still ask for their past
}

SpeedHistory::Speed PastSpeeds::then(int i, double now) const
{
    const double margin = beside * std::min(piece_to_ - piece_from_, lag_[i]);
    const double pick = std::clamp(now, piece_from_ + margin, piece_to_ - margin);
    return history_[i].at(now - lag_[i], pick - lag_[i]);
}

void PastSpeeds::scale(double by)
{
    for (auto& history : history_) history.scale(by);
}

namespace {

/// Friction of the other direction under an asymmetry: 2 of this − f.
double both_ways(const Friction& friction, double V)
{
    return friction.normal_load * (friction.asymmetry.coulomb + friction.asymmetry.viscous * V);
}

}  // namespace

double delayed_force(const Friction& friction, double V, bool backwards)
{
    const double forward = steady_force(friction, V);
    return backwards ? 2 * both_ways(friction, V) - forward : forward;
}

double delayed_slope(const Friction& friction, double V, bool backwards)
{
    const double level = steady_slope(std::get<TimeLag>(friction.law).curve.law, V);
    const double forward = friction.normal_load * (level + friction.asymmetry.viscous);
    return backwards ? 2 * friction.normal_load * friction.asymmetry.viscous - forward : forward;
}

}  // namespace stickslip
