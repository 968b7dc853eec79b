// The motion of a joint through sliding, sticking and reversal, turn by turn around the section V = V_0.
#pragma once
#include "analysis/simulation/flows/near_rest.h"
#include "analysis/simulation/solvers/stepper.h"

#include <functional>

namespace stickslip {

class DelayedFlow;

/// One revolution, from one downward crossing of V = V_0 to the next.
struct Turn {
    enum class End { crossing, settled, time, failure, held };  ///< held: sticks for ever
    End end = End::crossing;
    double t0 = 0, t1 = 0;
    FlowVector start, state;  ///< at both ends
    double velocity_min = 0, velocity_max = 0;
    double position_min = 0, position_max = 0;
    double rest_time = 0;               ///< at rest or below near_rest · V_0
    double release_position = missing;  ///< where true sticking last ended
    int sticks = 0;                     ///< phases of true sticking, of any body
    int steps = 0;                      ///< of the solver
    bool reversed = false;
    double period() const { return t1 - t0; }
};

/// An instant of the motion, as an observer sees it at every step.
struct Instant {
    double t;
    const FlowVector& y;
    double velocity;
    bool stuck;
    const Flow& flow;  ///< with the branches that hold
};

/// Follows one flow. Laws that are set-valued at rest stick there while the force needed to hold the mass stays within
/// the static friction; sticking has a closed form (the spring winds up at V_0) and ends with forward or reverse
/// sliding. Delayed friction is followed by the one-step method whichever is requested: it ends its steps at
/// kinks.
class SlidingMotion {
  public:
    SlidingMotion(const Flow& flow, Solver solver, double rtol);

    void start(const FlowVector& y, double t = 0);
    /// Flow::surround from the instant that the motion has reached.
    void surround(double force, double normal_load);
    /// Until the next downward crossing of V = V_0, until `settled` says true at a step, or until the time is over.
    Turn turn(double t_end, const std::function<bool(const FlowVector&)>& settled = {});
    /// Straight to a time, whatever is crossed on the way; false if the solver fails or takes more steps than that.
    bool advance(double t_end, int most_steps);

    double time() const { return t_; }
    const FlowVector& state() const { return y_; }
    const Flow& flow() const { return *flow_; }  ///< with the branches that hold, and the past of a delayed one
    bool used_fallback() const { return used_fallback_; }
    void observe(std::function<void(const Instant&)> observer) { observer_ = std::move(observer); }

  private:
    enum EventIndex { section = 0, slow = 1, rest = 2 };
    bool fall_back();
    bool step_failed();
    void restart();
    void begin_slide(Branch branch);
    void arrive_at_rest();
    bool pass_switch(int which);
    /// An event that a solver cannot see, which looks at the ends of its steps: a speed, or what is left to a
    /// break-away, that meets zero and comes back within one step.
    struct Touch {
        int event;
        double time;  ///< the solver's
    };
    std::optional<Touch> touched(double from, const FlowVector& before) const;
    FlowVector after_rest(double time) const;
    double rest_duration() const;
    bool stick(double t_end);
    Turn run(double t_end, const std::function<bool(const FlowVector&)>& settled);
    std::optional<Turn::End> slide(double t_end, const std::function<bool(const FlowVector&)>& settled, Turn& turn);
    Turn begun_turn();
    Turn finished(Turn turn, Turn::End end) const;
    void measure_step(double from, double to, const FlowVector& before, const StepReport& report, Turn& turn);
    void notify();

    /// The flow as what it may be beside a flow; null where it is not.
    struct Roles {
        SlidingFlow* sticking = nullptr;     ///< branches are switched
        SwitchingFlow* switching = nullptr;  ///< several bodies may rest
        DelayedFlow* delayed = nullptr;      ///< friction is delayed
        explicit Roles(Flow& flow);
    };
    struct SolverClock {
        double zero = 0;  ///< the instant that the solver counts from
        int steps = 0;    ///< since it was started
    };
    /// Rests and near rests, of the present turn but for the last two.
    struct Resting {
        bool stuck = false;
        bool became_slow = false;  ///< the last step ended where V fell below near_rest
        double time = 0, released_at = missing;
        int sticks = 0, rests = 0;
        int bounces = 0;  ///< rests since the mass last moved faster than near_rest
        double release_excess = SlidingFlow::least_excess;
    };
    struct Effort {
        int steps_left = 0;     ///< of the present turn or advance
        int patience_left = 0;  ///< with CVODE
        int restarts = 0;
        int idle_switches = 0;  ///< since time last moved on
    };

    std::unique_ptr<Flow> flow_;
    Roles as_;
    Events events_;
    Solver solver_;
    double rtol_;
    std::unique_ptr<Stepper> stepper_;
    bool used_fallback_ = false;
    double t_ = 0;
    FlowVector y_;
    FlowVector rate_;  ///< at the end of the last step
    bool rate_known_ = false;
    SolverClock clock_;
    Resting rest_;
    Effort effort_;
    std::function<void(const Instant&)> observer_;
};

}  // namespace stickslip
