// What one lane is doing: measure the growth of a small disturbance, then search a cycle turn by turn. Plain scalar
// code, called at events only, compiled once for every processor, while the kernels that integrate are compiled for
// each.
#pragma once
#include "analysis/simulation/flows/near_rest.h"
#include "analysis/simulation/lanes/job.h"
#include "analysis/simulation/lanes/secant.h"
#include "analysis/simulation/solvers/rodas5p_table.h"

namespace stickslip::lanes {

/// One accepted step of one lane, as the kernel hands it over.
struct StepView {
    double t, h;          ///< start and length, in the time of the present phase
    double y0[3], y1[3];  ///< X, w, p at both ends
    double U[rodas5p::stages][3];
    double w_before, h_before;  ///< the step before: w at its start, its length
};

/// Why the kernel stops at a step.
struct EventFlags {
    bool time = false;     ///< the phase's end time is reached
    bool section = false;  ///< V passed V_0
    bool turning = false;  ///< V has an extremum in this or the last step
    bool slow = false;     ///< V passed a hundredth of V_0
    bool rest = false;     ///< V fell to 0
    bool settled = false;  ///< back at steady sliding
};

/// What the kernel has to do next.
struct Action {
    enum class Kind { carry_on, restart, finished };
    Kind kind = Kind::carry_on;
    double y[3] = {0, 0, 0};  ///< restart: from here, at time 0
    double h = 0;             ///< restart: first step
};

enum class Phase : std::uint8_t { grow, cycle, search };

inline constexpr double settled_size = 1e-3;  ///< of X K, w, p/β, below which the linear theory holds

class Program {
  public:
    using View = StepView;
    Program();  // like all members out of line: no kernel may emit a copy in its own instructions
    /// Starts a job: where from, with what first step.
    Action begin(const Job& job, const Settings& settings);
    Action handle(const StepView& step, EventFlags flags);
    /// Gives the job up: too many steps, or a step that went to zero.
    Action give_up();

    Phase phase() const;
    double end_time() const;
    double tolerance() const;
    /// Size that errors are measured against, beside that of y itself.
    void floors(double* floor) const;
    const Answer& answer() const;

  private:
    Action finish(Ending ending);
    Action end_of_growth(const StepView& step);
    Action end_of_turn(const StepView& step, double fraction);
    void note_extremum(const StepView& step);
    double balanced_speed(double X, double p) const;
    double first_step(double w) const;
    double slow_size(const double y[3]) const;
    Action start_at(double X, double w, double p) const;

    const Job* job_ = nullptr;
    const Settings* settings_ = nullptr;
    Answer answer_;
    Phase phase_ = Phase::grow;
    double size0_ = 0;  ///< |l·y| at the start
    SecantSearch secants_;
    Point turn_start_;
    bool on_turn_ = false;  ///< the section has been crossed: a turn is being measured
    double rested_since_ = 0;
};

}  // namespace stickslip::lanes
