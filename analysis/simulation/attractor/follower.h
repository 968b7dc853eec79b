// The bookkeeping of one motion that is followed to its end.
#pragma once
#include <deque>
#include <memory>
#include <optional>

#include "analysis/simulation/attractor/attractor.h"
#include "analysis/simulation/flows/creep.h"

namespace stickslip {

/// What follow() knows of a motion so far.
class Follower {
  public:
    Follower(const Flow& flow, bool steady_attracts, const FollowOptions& options);
    Attractor run(const FlowVector& y);

  private:
    /// When shooting is tried again: each miss doubles the wait, up to the longest, all in turns.
    struct Aim {
        int longest_wait = 0, next = 0, wait = 1;
        bool taken_at(int turn);
    };
    /// The last two turns against each other.
    struct Comparison {
        double size = 0, gap = 0;         ///< the amplitude, and the distance between their points on the section
        double growth = 0;                ///< ln of the amplitude ratio
        bool equal = false;               ///< no gap
        bool rest = false, slow = false;  ///< both stick; both come near rest
    };
    static constexpr double alike = 0.05;  ///< gap of two turns, per amplitude, from which shooting is tried

    double distance(const FlowVector& a, const FlowVector& b) const
    {
        return (a - b).cwiseQuotient(scale_).cwiseAbs().maxCoeff();
    }
    Attractor ended(Attractor::Kind kind, Reason reason = Reason::none);
    Attractor from_turn(const Turn& turn);
    std::optional<Attractor> end_at(const Turn& turn);
    Comparison compared() const;
    std::optional<Attractor> hastened(const Comparison& turns);
    bool closes(const Comparison& turns) const;
    bool shoot(const FlowVector& guess);
    bool may_rest() const;
    bool settled(const FlowVector& y) const;
    bool makes_turn(const Cycle& cycle) const;
    void refine();
    void start_anew(const FlowVector& y);
    bool jump(double growth);
    double amplitude() const { return distance(points_.back(), steady_); }
    bool repeats();
    bool shoot_repeat(int watched_turns);
    bool comes_back();
    void take_repeat(int turns);
    bool wild(bool cut_short) const;
    void spend(const Turn& turn);
    bool smooth(const Turn& turn) const { return turn.sticks == 0 && !turn.reversed; }

    const Flow& flow_;
    const FollowOptions& options_;
    bool steady_attracts_;
    FlowVector scale_, steady_;
    std::unique_ptr<SlidingMotion> motion_;
    bool fine_ = false;
    Attractor result_;
    std::deque<FlowVector> points_;  ///< on the section, newest last
    std::deque<Turn> turns_;
    double turn_limit_ = 0, least_turn_ = 0;  ///< s
    double abscissa_ = 0;                     ///< 1/s
    double slowest_ = 0;                      ///< 1/s, of the modes that are not neutral
    bool frozen_ = false;                     ///< some states do not move at and about steady sliding
    int linear_turns_ = 0;                    ///< in succession that decayed at the linear rate
    double last_growth_ = missing;            ///< ln of the amplitude ratio of the last two turns
    Creep creep_;
    Aim one_turn_, several_turns_;
    int steps_ = 0;        ///< of the solver
    int idle_turns_ = 0;   ///< in succession that were shorter
    int quiet_turns_ = 0;  ///< turns since the amplitude was last scaled
};

}  // namespace stickslip
