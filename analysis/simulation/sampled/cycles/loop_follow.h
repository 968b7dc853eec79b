// Where a motion in a sampled loop ends: steady sliding, a cycle, something longer, or a reason why it is not known.
#pragma once
#include "analysis/simulation/sampled/closed_loop/loop_mode.h"
#include "analysis/simulation/sampled/cycles/uneven_follow.h"

#include <optional>

namespace stickslip {

struct LoopFollowOptions {
    int turn_limit = 3000;
    bool steady_attracts = false;  ///< small disturbances decay
    bool stays = false;            ///< once at rest, no effort that the loop can give moves it
    double turn = missing;         ///< s, of the slow mode: about how long a turn is
    double held = 0;               ///< s, that a cycle may stand still
    double decay = missing;        ///< 1/s, of small disturbances; negative where they decay
    double winds = 0;              ///< 1/s, with which an integral finds its level while the joint cycles; 0: none
    bool uneven = false;           ///< encoder or noise: no motion repeats, turns are no measure
    double noise = 0;              ///< of such a motion: the smallest that the encoder or its noise makes
    double lead = 0;               ///< and ln of what it starts with, per that
    Jitter jitter;                 ///< and that about steady sliding, where known
};

/// A motion that creeps towards a cycle or away from one: growth per turn over ln amplitude, and where it vanishes.
class CreepSearch {
  public:
    /// The ln amplitude to look at next. `ahead`: how far from here growth, extrapolated, vanishes; a motion that
    /// shrinks is taken no further inwards. Beside a fold the stable cycle at which it would stop has an unstable one
    /// close inside, and growth bends so that its extrapolation falls short of both.
    double next(double at, double growth, double ahead);

  private:
    struct Side {
        double at = 0, growth = 0;
        bool known = false;
    };
    Side below_, above_;
};

/// Watches a loop tick by tick, whoever moves it, and says where its motion ends.
class LoopFollower {
  public:
    /// From where the loop is. `steady` is its state in steady sliding, empty where it has none.
    LoopFollower(SampledLoop& loop, const std::vector<double>& steady, double origin, const LoopFollowOptions& options);

    /// Called with all that the loop does within a tick.
    TurnWatch watch;
    /// After a tick; `moved` is false where it could not be followed. May put the loop into another state, on the way
    /// to a cycle far away.
    std::optional<LoopEnd> after_tick(bool moved);
    /// Where the work is spent.
    LoopEnd cut_short() const;
    /// The last turn changed so much of the motion that its own errors do not count.
    bool on_its_way() const;
    bool has_peak() const { return first_peak_ == first_peak_; }
    /// Extrema of every tick count, not of every turn.
    bool uneven() const { return options_.uneven; }

  private:
    LoopEnd ended(LoopEnd::Kind kind, Reason reason = Reason::none) const;
    std::optional<LoopEnd> after_even_tick();
    std::optional<LoopEnd> after_uneven_tick();
    bool decays_linearly() const;
    bool dies_away();
    bool repeats_evenly() const;
    double last_growth() const;
    bool waits_for_integral(const LoopTurn& turn) const;
    bool integral_on_its_way(const LoopTurn& turn) const;
    std::optional<LoopEnd> decide();
    void scale_motion(double by);
    LoopEnd measured(LoopEnd::Kind kind, std::size_t count) const;
    LoopEnd repeated(int turns) const;

    SampledLoop& loop_;
    const std::vector<double> steady_;
    const LoopFollowOptions options_;
    double V0_, last_crossing_;
    std::vector<LoopTurn> turns_;  ///< since the motion was last scaled
    std::vector<double> excess_;   ///< of the link's velocity, per V_0, a time constant of the decay apart
    CreepSearch creep_;
    long ticks_ = 0;
    int all_turns_ = 0, blocks_ = 0;
    double first_peak_ = missing, last_change_ = missing;
    std::size_t skip_ = 0;

    std::optional<UnevenFollow> uneven_;
};

}  // namespace stickslip
