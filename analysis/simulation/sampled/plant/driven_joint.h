// A joint between two changes of what its actuator gets: bodies, springs with backlash, friction, load, lag and motor.
// What depends on the place and on time is in it, so that it has no steady path of its own.
#pragma once
#include "analysis/joint/drive.h"
#include "analysis/results/detail.h"
#include "analysis/simulation/flows/flow.h"
#include "analysis/simulation/flows/past_speeds.h"
#include "analysis/stability/linear_joint.h"

#include <array>

namespace stickslip {

/// Positions, speeds and friction states of three bodies, the actuator's lag, time.
inline constexpr int max_driven_size = 3 * (2 + max_states) + 2;
using DrivenState = std::array<double, max_driven_size>;

/// Where the numbers of the loop are counted: maps have all bodies and the loop in joint coordinates (the README of
/// analysis), a record has the reading and the effort of a geared motor at the motor's own side.
enum class LoopSide { joint, motor };

/// M_i v̇_i = E_i − spring forces − N_i f_i(N_i v_i, θ_i) + load_i in joint coordinates. Positions are counted from a
/// frame that moves at a constant velocity F, so that small motions about steady sliding keep their digits:
/// y = (x_1 … x_n, s_1 … s_n, θ of body 1, …, lag, time), s_i = ln(v_i/w_i) for laws that need motion, else v_i. A body
/// whose law is set-valued at rest sticks while what is needed to hold it stays within its static friction.
class DrivenJoint {
  public:
    enum class Mode : std::uint8_t { forward, reverse, stuck };
    using Modes = std::array<Mode, max_bodies>;

    /// `frame` is F [joint side]; `speed` scales what has no other scale, and must not be 0.
    DrivenJoint(const Joint& joint, double frame, double speed, LoopSide side);

    /// What arrives at the actuator from now on.
    double arriving = 0;
    /// Of the link, in the frame: where the contact spring bears nothing. In steady sliding it goes along.
    double contact_origin = 0;
    Modes modes{};

    int bodies() const { return chain_.bodies; }
    int link() const { return chain_.bodies - 1; }
    int measured() const { return measured_; }
    int size() const { return size_; }
    double frame() const { return frame_; }
    /// Reading per joint displacement of the measured body, without the encoder's own scale.
    double reading_ratio() const { return reading_ratio_; }
    const DrivenState& scale() const { return scale_; }

    double velocity(const double* y, int i) const
    {
        const auto& b = body_[i];
        return b.logarithmic ? b.speed * std::exp(std::max(y[bodies() + i], least_logarithm)) : y[bodies() + i];
    }
    void set_velocity(double* y, int i, double v) const;
    double& lagged(double* y) const { return y[lag_index_]; }
    bool has_lag() const { return lag_index_ >= 0; }
    double& clock(double* y) const { return y[clock_index_]; }
    bool has_clock() const { return clock_index_ >= 0; }
    int clock_index() const { return clock_index_; }  ///< −1 without a clock
    double began = 0;                                 ///< on that clock: what comes with time counts from here
    bool logarithmic(int i) const { return body_[i].logarithmic; }
    int states(int i) const { return body_[i].states; }
    int first_state(int i) const { return body_[i].first_state; }
    bool can_rest(int i) const { return body_[i].rests; }
    bool anything_can_rest() const;
    /// A body under a logarithmic law has no speed but forwards. One that is pulled backwards crawls on, against a
    /// friction below zero, which no contact has.
    bool driven_backwards(const double* y) const;

    void rate(const double* y, double* out) const;
    /// Row by row.
    void jacobian(const double* y, double* J) const;

    /// Functions whose zeros end a step: a body comes to rest or breaks away, a backlash opens or closes.
    int switches() const { return switches_; }
    void switch_values(const double* y, double* values) const;
    /// The equations that hold after the zero of one of them.
    void pass(int which, double* y);
    /// A body that seemed to break away and does not.
    void hold(int i) { modes[i] = Mode::stuck; }
    /// And those that hold at y, whatever was before: call it where `arriving` or the state jumps.
    void enter(double* y);

    // Delayed friction: its level is that of the speed a lag ago. The joint carries the past of one motion.
    bool has_delayed_friction() const { return past_.is_delayed(); }
    /// Begins a motion at y, after this velocity of all bodies for ever.
    void begin_past(const double* y, double velocity);
    /// The same where the clock has been set.
    void restart_past(const double* y)
    {
        if (has_delayed_friction()) past_.restart(now(y));
    }
    /// By when a step from y must end.
    double step_limit(const double* y);
    /// Takes a step into the past; `at(fraction, state)` is the state within it.
    template <class At>
    void remember(const double* from, const double* to, const At& at);
    /// All motion so far, about steady sliding, becomes this many times as large.
    void scale_past(double by) { past_.scale(by); }

    /// Effort on the mechanism now, at the motor's own side where the loop is counted there.
    double effort(const double* y) const;
    /// Friction on the link: of its law, or what holds it.
    double link_friction(const double* y) const;

    /// The state of sliding steadily at this velocity with the measured body at x = 0, and the command that keeps it
    /// so. `command` is NaN where the actuator cannot bring it up.
    struct Steady {
        DrivenState y;
        double command;
    };
    Steady steady(double velocity) const;
    /// At rest at the reading's origin plus x, the lag empty.
    DrivenState at_rest(double x) const;

  private:
    struct BodyData {
        Friction friction;
        double inertia, ratio, speed;
        bool logarithmic, rests, delayed;
        double edge;     ///< speed below which a body that can rest comes to rest, joint coordinates
        double release;  ///< speed to which it breaks away
        bool bent;       ///< its level changes with place, time or load
        int states, first_state;
    };
    struct Drive {
        double effort, by_velocity, by_lag;
    };
    struct Extra {
        double level, by_place, by_time;
    };
    struct Contact {
        FrictionResponse r;
        double by_level = 0;
        States rate_by_level{};
    };
    Drive drive(const double* y) const;
    double spring(const double* y, int i, double* by_stretch, double* by_rate) const;
    double load(const double* y, double* by_place, double* by_time) const;
    /// Of the spring between link and surroundings, against the displacement.
    double contact_force(const double* y) const;
    Extra extra(const double* y, int i) const;
    double gear_level(const double* y, double direction, double other) const;
    double gear_level_at_rest(const double* y, double direction) const;
    Contact contact(const double* y, int i, bool derivatives) const;
    FrictionResponse respond_as(const BodyData& b, const Friction& friction, Mode mode, const double* y, int i) const;
    double needed(const double* y, int i) const;
    double delayed_level(const double* y, int i, bool backwards) const;
    double delayed_change(const double* y, int i) const;
    void note_kink(const double* y, int lags);
    double limit(const double* y, int i, Branch branch) const;
    void settle(int i, double* y);
    void meet_flank(int i, double* y);
    double now(const double* y) const { return has_clock() ? y[clock_index_] : 0; }

    Chain chain_;
    Joint joint_;
    double frame_, effort_ratio_ = 1, reading_ratio_ = 1, backlash_[max_bodies] = {};
    std::array<BodyData, max_bodies> body_;
    int measured_ = 0, size_ = 0, lag_index_ = -1, clock_index_ = -1, switches_ = 0;
    DrivenState scale_{};
    PastSpeeds past_;
};

template <class At>
void DrivenJoint::remember(const double* from, const double* to, const At& at)
{
    const double t0 = now(from), t1 = now(to);
    if (!(t1 > t0)) return;
    std::array<DrivenState, 3> inside;
    for (int k = 0; k < 3; ++k) at(0.25 * (k + 1), inside[k].data());
    for (int i = 0; i < bodies(); ++i) {
        if (!body_[i].delayed) continue;
        SpeedHistory::Step step{t0, t1, {}};
        const double* y[] = {from, inside[0].data(), inside[1].data(), inside[2].data(), to};
        for (int k = 0; k < 5; ++k) step.velocity[k] = velocity(y[k], i);
        past_.append(i, step);
    }
}

/// The term that the simulation of a loop has no equations for; none where it has all.
Detail why_not_driven(const Joint& joint);

}  // namespace stickslip
