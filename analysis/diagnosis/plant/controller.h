// The sampled controller of a record (docs/theory.md, real loops): that of the simulation, in the frame of the room.
#pragma once
#include "analysis/diagnosis/plant/plant.h"
#include "analysis/simulation/sampled/closed_loop/loop_controller.h"

#include <optional>

namespace stickslip::gap {

/// The reading per displacement of the link, for gravity that is fed forward.
inline double reading_per_link(const Joint& joint)
{
    const bool geared = joint.mechanism.model != Model::single_mass && joint.control.feedback == Feedback::motor;
    return geared ? joint.mechanism.transmission.ratio : 1;
}

/// Nothing but k_p e + k_v ė: no integral, cascade, dead zone or push of its own.
inline bool is_plain(const Control& c)
{
    const auto& f = c.feed_forward;
    return c.structure == Structure::pid && c.k_i == 0 && c.dead_zone == 0 && c.dither.amplitude == 0 &&
           f.coulomb == 0 && f.acceleration == 0 && f.velocity == 1 && !f.gravity;
}

class Controller {
  public:
    /// `load` and `gear` matter to gravity that is fed forward alone.
    explicit Controller(const Control& control, const Load& load = {}, double gear = 1) : gear_(gear)
    {
        joint_.control = control;
        joint_.load = load;
        // records are sampled even where the description is not
        if (!is_set(control.period)) joint_.control.period = 1e-3;
        restart();
    }
    explicit Controller(const Joint& joint) : Controller(joint.control, joint.load, reading_per_link(joint)) {}
    explicit Controller(const Plant& plant)
        : Controller(plant.control, plant.load, plant.two_mass && !plant.feedback_link ? plant.ratio : 1)
    {
    }

    /// Forgets what it has read, but for the integral that it held.
    void restart(double integral = 0)
    {
        loop_.emplace(joint_, 0, gear_);
        loop_->state.integral = integral;
    }
    /// As if it had read this motion of one velocity for ever, the last reading a step ago.
    void restart_moving(double position, double velocity, double step, double integral)
    {
        restart(integral);
        loop_->arrive(position, velocity, step);
    }
    /// A new reading, one step after the last. `exact` is used where the estimate is the exact velocity.
    void read(double position, double step, double exact)
    {
        step_ = step;
        loop_->read(position, step, exact);
    }
    /// Takes a logged estimate in place of the controller's own.
    void believe(double velocity) { loop_->state.velocity = velocity; }
    double velocity() const { return loop_->state.velocity; }
    double integral() const { return loop_->integral(); }
    bool integrates() const { return loop_->integrates(); }
    double integral_gain() const { return loop_->integral_gain(); }
    /// Once a tick, at this time of the record. `added`: what the record says was added to the controller's own, a
    /// feed-forward.
    double command(double reference, double reference_rate, double added, double time)
    {
        loop_->set_time(time);
        return loop_->command(reference, reference_rate, step_, added);
    }
    /// The last command before its limit.
    double wanted() const { return loop_->wanted(); }

  private:
    Joint joint_;
    double gear_, step_ = 1e-3;
    std::optional<LoopController> loop_;
};

}  // namespace stickslip::gap
