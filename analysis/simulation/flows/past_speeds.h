// What delayed friction needs of a motion: the speeds of its bodies over the last lag, and the instants at
// which they have a kink. Over less than a lag the friction is then a known function of time (method of steps).
#pragma once
#include "analysis/friction/friction.h"
#include "analysis/simulation/flows/speed_history.h"
#include "analysis/stability/linear_joint.h"

#include <array>
#include <set>

namespace stickslip {

class PastSpeeds {
  public:
    using Speeds = std::array<double, max_bodies>;

    void set_lag(int body, double lag);
    /// 0 of bodies whose friction is not delayed.
    double lag(int i) const { return lag_[i]; }
    double longest_lag() const { return longest_lag_; }
    bool is_delayed() const { return longest_lag_ > 0; }
    const SpeedHistory& history(int i) const { return history_[i]; }

    /// A lag after a kink the velocity's derivative has it, one order higher each further lag: then it lies beyond the
    /// order of the method.
    static constexpr int felt_lags = 4;

    /// Begins a motion after these speeds for ever.
    void begin(double now, const Speeds& before);
    /// The same after the speeds that it began with before.
    void restart(double now);
    /// The velocity of some body has a kink now, and its friction a lag later.
    void note_kink(double now, int lags = felt_lags);
    /// By when a step from now must end: the past that it needs must be known and smooth. Bodies at rest need none.
    double step_limit(double now, const std::array<bool, max_bodies>& rests);
    /// Takes a step of a delayed body into its past.
    void append(int i, const SpeedHistory::Step& step);
    /// The speed a lag ago.
    SpeedHistory::Speed then(int i, double now) const;
    /// All speeds so far become before + by (V − before).
    void scale(double by);

  private:
    static constexpr double kept_lags = 1.001;  ///< of the past: a little more, as a lag ago may mean just before then
    Speeds lag_{};
    double shortest_lag_ = infinity, longest_lag_ = 0;
    std::array<SpeedHistory, max_bodies> history_;
    std::set<double> kinks_;                       ///< instants to come at which the friction of a body has one
    double piece_from_ = 0, piece_to_ = infinity;  ///< between kinks: where the present step lies
};

/// What delayed friction resists, at the body's own side, where the body felt the speed V ≥ 0 a lag ago and moves
/// forwards or backwards now: its level is delayed, its direction is not.
double delayed_force(const Friction& friction, double V, bool backwards);
/// Its change per change of that V.
double delayed_slope(const Friction& friction, double V, bool backwards);

}  // namespace stickslip
