// What one lane of a law is doing whose motions may come back after several turns: each motion is watched turn by turn
// until it repeats or is back at steady sliding. Plain scalar code, called at events only.
#pragma once
#include <memory>

#include "analysis/simulation/lanes/lane_program.h"
#include "analysis/simulation/lanes/watched_job.h"

namespace stickslip::lanes {

class WatchedProgram {
  public:
    using View = StepView;
    WatchedProgram();  // like all members out of line: no kernel may emit a copy in its own instructions
    ~WatchedProgram();
    WatchedProgram(const WatchedProgram&) = delete;
    WatchedProgram& operator=(const WatchedProgram&) = delete;
    Action begin(const WatchedJob& job, const Settings& settings);
    Action handle(const StepView& step, EventFlags flags);
    Action give_up();

    Phase phase() const;
    double tolerance() const;
    double settled() const;
    void floors(double* floor) const;
    const WatchedAnswer& answer() const;

  private:
    struct Watched;  ///< the turns so far
    Action finish(Ending ending);
    Action follow(const double (&start)[most_unknowns]);
    Action decayed();
    Action goes_around(int turns, bool whole = true);
    Action out_of_patience(bool cut_short);
    Action end_of_turn(const StepView& step, double fraction);
    void begin_turn(double X);
    void note_turn(double period);
    bool decays_linearly();
    bool leap();
    double speed_of(double measure) const;

    const WatchedJob* job_ = nullptr;
    const Settings* settings_ = nullptr;
    WatchedAnswer answer_;
    Phase phase_ = Phase::cycle;
    double size_ = 1;  ///< of the start, at most 1
    int search_ = 0;   ///< which of the larger starts
    std::unique_ptr<Watched> watched_;
    SmallerCycles smaller_;
    int linear_turns_ = 0;  ///< in succession that grew as the linear theory has it
    int since_leap_ = 0, creeps_ = 0;
    bool on_turn_ = false;  ///< the section has been crossed: a turn is being measured
    double rested_since_ = 0;
};

}  // namespace stickslip::lanes
