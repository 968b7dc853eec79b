// The motion of a driven joint from one jump of what arrives to the next, through sticking and sliding.
#pragma once
#include "analysis/base/work_limits.h"
#include "analysis/simulation/sampled/plant/rosenbrock_step.h"

#include <functional>

namespace stickslip {

/// A step as an observer sees it: from `t` to `t + step.h` under the equations that `joint` holds.
struct DrivenStep {
    double t;
    const RosenbrockStep& step;
    const DrivenJoint& joint;
};

struct MotionOptions {
    double rtol = 1e-8;
    /// Equal steps no longer than this in place of error control: the motion is then a smooth function of its start,
    /// as differences of neighbouring motions need. 0: error control.
    double fixed_step = 0;
};

class DrivenMotion {
  public:
    DrivenMotion(const DrivenJoint& driven, const MotionOptions& options) : joint(driven), options_(options) {}

    DrivenJoint joint;  ///< with what arrives and the modes that hold
    DrivenState y{};

    void set_fixed_step(double step) { options_.fixed_step = step; }
    /// After y or what arrives has changed.
    void enter() { joint.enter(y.data()); }
    /// From t on for a duration; false where steps shrink to nothing or bodies stop and go for ever.
    template <class Observer>
    bool advance(double t, double duration, Observer&& observe);
    bool advance(double t, double duration)
    {
        return advance(t, duration, [](const DrivenStep&) {});
    }

    long steps = 0;  ///< in all

  private:
    bool step_to(double left);
    bool keep_launches(double left);
    int first_switch(double& fraction) const;
    void land_on(int which, double fraction);

    MotionOptions options_;
    RosenbrockStep step_;
    double wish_ = 0;        ///< length that error control would take next
    double first_wish_ = 0;  ///< the same of a first step: a command jumps with every tick
    std::array<double, 2 * max_bodies> before_{};
    int passed_ = -1;  ///< the backlash whose flank the last step ended on: its switch is zero but for rounding
};

template <class Observer>
bool DrivenMotion::advance(double t, double duration, Observer&& observe)
{
    constexpr int most_idle = 50;       // switches without time moving on
    constexpr double resolved = 1e-14;  // of the duration
    double done = 0;
    step_.forget();
    step_.implicit_only = options_.fixed_step > 0;
    int idle = 0;
    long taken = 0;
    if (first_wish_ > 0) wish_ = std::min(wish_, first_wish_);
    while (done < duration) {
        if (joint.switches() > 0) joint.switch_values(y.data(), before_.data());
        const double left = joint.has_delayed_friction()
                                ? std::min(duration - done, joint.step_limit(y.data()) - joint.clock(y.data()))
                                : duration - done;
        if (!step_to(left)) return false;
        if (taken == 0) first_wish_ = wish_;
        if (joint.switches() > 0 && !keep_launches(left)) return false;
        double fraction = 1;
        const int which = joint.switches() > 0 ? first_switch(fraction) : -1;
        if (which >= 0) land_on(which, fraction);
        observe(DrivenStep{t + done, step_, joint});
        if (joint.has_delayed_friction())
            joint.remember(y.data(), step_.y1.data(), [this](double f, double* at) { step_.dense(f, at); });
        y = step_.y1;
        if (which >= 0 || (joint.has_delayed_friction() && step_.h >= left))
            step_.forget();
        else
            step_.carry();
        const bool last = which < 0 && step_.h >= duration - done;
        passed_ = which >= joint.bodies() ? which : -1;
        done = last ? duration : done + step_.h;
        if (step_.h > resolved * duration) idle = 0;
        if (++taken > work::steps_of_tick || (which >= 0 && ++idle > most_idle)) return false;
        if (which >= 0) {
            if (which < joint.bodies() && joint.modes[which] != DrivenJoint::Mode::stuck) y[joint.bodies() + which] = 0;
            joint.pass(which, y.data());
        }
    }
    return true;
}

}  // namespace stickslip
