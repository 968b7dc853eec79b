// What one lane is doing: search a cycle turn by turn, or see a disturbance decay. Plain scalar code, called at events
// only, compiled once for every processor, while the kernels that integrate are compiled for each.
#pragma once
#include "analysis/simulation/flows/near_rest.h"
#include "analysis/simulation/lanes/basin.h"
#include "analysis/simulation/lanes/job.h"
#include "analysis/simulation/lanes/secant.h"
#include "analysis/simulation/lanes/step_view.h"

namespace stickslip::lanes {

/// Why the kernel stops at a step.
struct EventFlags {
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
    double y[most_unknowns] = {};  ///< restart: from here, at time 0
    double h = 0;                  ///< restart: first step
};

enum class Phase : std::uint8_t {
    cycle,   ///< sliding is unstable: there is a cycle
    stated,  ///< sliding is stable, and where the stated disturbance ends is the question
    search   ///< sliding is stable, and whether a cycle coexists is the question
};

inline constexpr double settled_size = 1e-3;  ///< of X K, w, p/β, below which the linear theory holds
inline constexpr double peak_told = 1e-6;     ///< the same where the highest point of the way is wanted, too

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
    double tolerance() const;
    /// Size of X K, w, p below which a motion towards steady sliding is done.
    double settled() const;
    /// Size that errors are measured against, beside that of y itself.
    void floors(double* floor) const;
    const Answer& answer() const;

  private:
    Action finish(Ending ending);
    Action decayed();
    Action follow(const double (&start)[3]);
    Action begin_phase(Phase phase);
    /// A search is made coarsely where small disturbances decay fast, roughly elsewhere; what it finds is refined, in
    /// two stages, what is not clear is searched again with more care, and what secants do not tell, turn by turn.
    /// Cycles that hardly attract are refined once more, exactly.
    enum class Care : std::uint8_t { coarse, rough, nearing, refining, fine, patient, exact };
    Care first_care_of_search() const;
    bool clearly_decays() const;
    void refine(Care care);
    bool weakly_contracting() const;
    Action all_again(Care care);
    Action with_more_care();
    bool in_basin() const;
    SecantSearch::State next_turn(Point end, Point& start);
    bool map_of_line() const;
    double linear_growth() const;
    bool none_smaller(Point end);
    BasinSide::Told told_by_turns(Point end, Point& start);
    Action end_of_turn(const StepView& step, double fraction);
    void note_extremum(const StepView& step);
    double first_step(double w) const;
    Action start_at(double X, double w, double p) const;

    const Job* job_ = nullptr;
    const Settings* settings_ = nullptr;
    Answer answer_;
    Phase phase_ = Phase::cycle;
    double size_ = 1;  ///< of the start, at most 1
    SecantSearch secants_;
    SmallerCycles smaller_;
    BasinSide basin_;
    Care care_ = Care::fine;
    int refinements_ = 0;
    double weakest_decay_ = 0;  ///< largest |end|/|start| of a turn
    Point turn_start_;
    bool on_turn_ = false;  ///< the section has been crossed: a turn is being measured
    double rested_since_ = 0;
};

}  // namespace stickslip::lanes
