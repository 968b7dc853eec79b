// The nonlinear truth about a joint in its real loop: sampled, late, filtered, limited.
#pragma once
#include "analysis/results/disturbance.h"
#include "analysis/results/nonlinear_verdict.h"
#include "analysis/simulation/sampled/cycles/loop_follow.h"

namespace stickslip {

struct LoopQuestion {
    Disturbance disturbance;
    double rtol = 1e-8;
    int turn_limit = 3000;
    bool region = true;      ///< also look for stick-slip that a larger disturbance reaches
    std::uint64_t seed = 1;  ///< of the noise
    double effort = 1;       ///< how much a verdict may compute, per the usual; lanes count ticks only
};

struct LoopVerdict {
    LoopEnd stated;  ///< after the stated disturbance
    LoopEnd cycle;   ///< it, or the one that a larger disturbance reaches
    NonlinearRegion region = NonlinearRegion::undecided;
    bool noise_suffices = false;   ///< what disturbs the loop all the time leads into the cycle of a bistable joint
    double size = missing;         ///< of the disturbance, SI
    double growth_rate = missing;  ///< 1/s, of a small disturbance, measured
    std::complex<double> multiplier{missing, missing};  ///< of largest magnitude from tick to tick, by simulation
    double tick = missing;                              ///< s
    double overshoot = missing;
    Reason reason = Reason::none;
    Detail detail = Detail::none, growth_missing = Detail::none;  ///< as in NonlinearVerdict
    LargerTried searched_from = LargerTried::none;
};

/// Whether a joint's file describes a loop other than the ideal one, which continuous equations of motion cover.
bool has_real_loop(const Joint& joint);

/// Whether only the ticks of its loop follow its motion: forces that change on the way have no flow of their own.
bool takes_ticks(const Joint& joint);

/// A change with position or time must repeat within this time for a motion to be followed until it does, s.
double longest_followed_change(const Joint& joint);

/// Period in which the joint swings on the spring of its gain, s.
double swing_of_gain(const Joint& joint);

/// What tells the growth of small disturbances: their motion, or the theory of the linear loop, which is exact there.
enum class GrowthBy : std::uint8_t { motion, theory };

/// The motions that a verdict takes, one after another, for whoever moves the loop.
class LoopInquiry {
  public:
    LoopInquiry(const Joint& joint, const LoopQuestion& question, GrowthBy by = GrowthBy::motion);
    LoopInquiry(const LoopInquiry&) = delete;
    LoopInquiry& operator=(const LoopInquiry&) = delete;

    /// Whether a motion is to be followed: that of loop(), from where it is.
    bool open() const { return follower_.has_value(); }
    SampledLoop& loop() { return *loop_; }
    double origin() const { return origin_; }  ///< position of the link in steady sliding
    LoopFollower& follower() { return *follower_; }
    /// Its next tick needs no more than an outline: where it goes to is wanted, not how.
    bool coarse() const { return follower_->on_its_way() && (phase_ != Phase::stated || follower_->has_peak()); }
    /// How it ended; the next one may be open then.
    void ended(const LoopEnd& end);
    const LoopVerdict& verdict() const { return verdict_; }

  private:
    enum class Phase : std::uint8_t { jitter, stated, from_rest, pulled };
    bool find_mode(const Joint& asked, double frame, GrowthBy by);
    void begin();
    void begin_stated();
    void learn_jitter(const LoopEnd& end);
    double noise() const;
    void judge_stated();
    bool winds_up_slowly() const;
    bool begin_search(Phase phase);
    void judge_search(const LoopEnd& large);
    void follow(Phase phase);

    Joint joint_;        ///< with the gains that act
    double deflection_;  ///< of steady sliding; none where an integral takes it
    LoopQuestion question_;
    LoopFollowOptions follow_;
    LoopMode mode_;
    LoopVerdict verdict_;
    std::optional<SampledLoop> loop_;
    std::optional<LoopFollower> follower_;
    std::vector<double> steady_;
    double origin_ = 0;
    Phase phase_ = Phase::stated;
    bool neutral_ = false;  ///< small disturbances neither grow nor decay: only one that was stated is followed
};

LoopVerdict loop_verdict(const Joint& joint, const LoopQuestion& question);

}  // namespace stickslip
