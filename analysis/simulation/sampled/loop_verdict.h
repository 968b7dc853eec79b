// The nonlinear truth about a joint in its real loop: sampled, late, filtered, limited.
#pragma once
#include "analysis/simulation/flows/disturbance.h"
#include "analysis/simulation/sampled/loop_follow.h"

namespace stickslip {

struct LoopQuestion {
    Disturbance disturbance;
    double rtol = 1e-8;
    int turn_limit = 3000;
    bool region = true;      ///< also look for stick-slip that a larger disturbance reaches
    std::uint64_t seed = 1;  ///< of the noise
};

enum class LoopRegion : std::uint8_t { undecided, stable, bistable, stick_slip };

struct LoopVerdict {
    LoopEnd stated;                ///< after the stated disturbance
    LoopEnd cycle;                 ///< it, or the one that a larger disturbance reaches
    LoopRegion region = LoopRegion::undecided;
    double size = missing;         ///< of the disturbance, SI
    double growth_rate = missing;  ///< 1/s, of a small disturbance, measured
    std::complex<double> multiplier{missing, missing};  ///< of largest magnitude from tick to tick, by simulation
    double tick = missing;                              ///< s
    double overshoot = missing;
    Reason reason = Reason::none;
    std::string_view explanation, growth_missing, searched_from;
};

/// Whether a joint's file describes a loop other than the ideal one, which continuous equations of motion cover.
bool has_real_loop(const Joint& joint);

LoopVerdict loop_verdict(const Joint& joint, const LoopQuestion& question);

}  // namespace stickslip
