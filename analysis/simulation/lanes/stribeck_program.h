// What one lane of a Stribeck joint is doing: measure the growth of a small disturbance, then search a cycle turn by
// turn, through phases of sticking that have a closed form. Plain scalar code, called at events only.
#pragma once
#include "analysis/simulation/lanes/lane_program.h"
#include "analysis/simulation/lanes/stribeck_job.h"
#include "analysis/simulation/solvers/dormand_prince.h"

namespace stickslip::lanes {

/// One accepted step of one lane, as the kernel hands it over.
struct StribeckView {
    double t, h;          ///< start and length, in the time since the last restart
    double y0[2], y1[2];  ///< X, u at both ends
    double k[dormand_prince::stages][2];
};

class StribeckProgram {
  public:
    using View = StribeckView;
    StribeckProgram();  // like all members out of line: no kernel may emit a copy in its own instructions
    Action begin(const StribeckJob& job, const Settings& settings);
    Action handle(const StribeckView& step, EventFlags flags);
    Action give_up();

    Phase phase() const;
    double tolerance() const;
    double settled() const;
    void floors(double* floor) const;
    const StribeckAnswer& answer() const;

  private:
    Action finish(Ending ending);
    Action restart(double X, double u, double h) const;
    Action from_rest();
    Action decayed();
    Action follow(double X, double u);
    Action end_of_turn(double X, double h);
    Action arrive_at_rest(double X);

    const StribeckJob* job_ = nullptr;
    const Settings* settings_ = nullptr;
    StribeckAnswer answer_;
    Phase phase_ = Phase::cycle;
    double size_ = 1;  ///< of the start, at most 1
    SecantSearch secants_;
    double turn_start_ = 0;                       ///< X on the section
    bool on_turn_ = false;                        ///< the section has been crossed: a turn is being measured
    bool sticks_ = false, stuck_before_ = false;  ///< in this turn, in the last
    double elapsed_ = 0;                          ///< in this turn, up to the last restart
    double rested_since_ = 0;
};

}  // namespace stickslip::lanes
