// The controller of a loop, tick by tick, as the joint describes it. It counts positions in the frame of the motion, so
// that a joint that slides steadily is at rest in it.
#pragma once
#include "analysis/joint/steady_output.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace stickslip {

class LoopController {
  public:
    /// `frame` is the frame's velocity as the encoder reads it. Without a period the loop is continuous, and ticks are
    /// steps of its integration: the velocity is the true one behind the filter, by the trapezoidal rule, and the
    /// output is that of the middle of the step, extrapolated, so that both are right to second order.
    /// `gear` is the reading per displacement of the link, for gravity that is fed forward.
    LoopController(const Joint& joint, double frame, double gear);

    /// All that it remembers from tick to tick.
    struct State {
        std::vector<double> window;  ///< the last readings, oldest first
        double velocity = 0, reading = 0;
        /// Of the error, of the velocity error in a cascade; counted from what steady sliding holds, beside which small
        /// changes would drown.
        double integral = 0;
        double before = 0, output = 0, error = 0;  ///< continuous loop: velocity, output, error of the tick before
        bool fresh = true;                         ///< has read nothing yet
    };
    State state;

    /// As after reading for ever, in steady sliding at this velocity with the reference at 0 in the frame, what gives
    /// this output; returns that reading. NaN where the controller cannot give it for ever.
    double begin(double output, double velocity, double step);
    /// As after reading nothing but this for ever, the integral such that the output is this, in a frame at rest with
    /// the reference at 0. Of a loop that integrates.
    void begin_holding(double reading, double output, double step);
    /// As after reading a motion of this velocity for ever, which is at `reading` a step later.
    void arrive(double reading, double velocity, double step);
    /// A new reading, `step` after the last. `exact` is the true velocity, used where the estimate is exact.
    void read(double reading, double step, double exact);
    /// What the controller makes of a reference in the frame; `rate` is its velocity, not counted in the frame, `added`
    /// a feed-forward beside its own.
    double command(double reference, double rate, double step, double added);
    /// Has read all that it has read this much further on.
    void shift(double by)
    {
        state.reading += by;
        for (double& reading : state.window) reading += by;
    }
    /// When the next command is computed; of a continuous loop the middle of the step.
    void set_time(double t) { time_ = t; }
    /// The path of the frame, for what feeds the reference's own place forward.
    void set_path(double path) { path_ = path; }

    bool continuous() const { return !is_set(control_.period); }
    /// The true velocity, beside the encoder's readings.
    bool reads_velocity() const { return continuous() || control_.velocity_estimate.form == EstimateForm::exact; }
    double integral() const { return held_ + state.integral; }
    double integral_gain() const { return gain_of_integral_; }
    /// What the integral gives of the output, and by how much a second changes that in such a rest.
    double integrated() const { return gain_of_integral_ * integral(); }
    double winding() const { return gain_of_integral_ * state.error; }
    bool integrates() const { return gain_of_integral_ != 0; }
    /// The last command before its limit.
    double wanted() const { return wanted_; }
    /// The last command as a log has it: of a continuous loop that of the moment, not of the middle of the step.
    double logged() const { return logged_; }

  private:
    void fill_window(double velocity, double step);
    void hold(double integral);
    double ahead(double reference, double rate, double step);
    double outside_dead_zone(double error) const;
    double rate_error(double rate) const;
    void integrate(double input, double error, double step);

    const Control control_;
    const Load load_;
    const Gains gains_;
    double gain_of_integral_, frame_, gear_;
    double held_ = 0;
    bool holds_ = false;
    double path_ = 0, time_ = 0, last_rate_ = not_set;
    bool saturated_high_ = false, saturated_low_ = false;
    double wanted_ = 0, logged_ = 0, cut_ = 0;  ///< output of the last tick before its limit; what was lost there
};

}  // namespace stickslip
