// What a joint does after a disturbance, with the numbers of the cycle that it ends in.
#pragma once
#include "analysis/results/detail.h"
#include "analysis/results/disturbance.h"
#include "analysis/results/point.h"

#include <complex>
#include <cstdint>
#include <vector>

namespace stickslip {

/// What small and larger disturbances together say: both decay, only small ones decay, or sliding is unstable.
enum class NonlinearRegion : std::uint8_t { undecided, stable, bistable, stick_slip };
/// How cycles are born at k_cr: supercritical small and stable, subcritical unstable, with a jump to stick-slip.
enum class Criticality : std::uint8_t { none, supercritical, subcritical, degenerate };

/// Mirrored by the nonlinear fields of PointResult. The cycle is the one that the disturbance ends in or, in the
/// bistable region, the one that a larger disturbance would reach.
struct NonlinearVerdict {
    Outcome outcome = Outcome::not_asked;                 ///< what the stated disturbance ends in
    NonlinearRegion region = NonlinearRegion::undecided;  ///< by small and larger disturbances together
    Disturbance disturbance;                              ///< with its size in SI
    double growth_rate = missing;                         ///< of a small disturbance of that kind, measured [1/s]
    double amplitude = missing;                           ///< of the cycle: half peak to peak in position [m | rad]
    /// By encoder, noise or what changes on the way: half peak to peak of sliding, or scatter of a cycle's amplitude.
    double jitter = missing;
    double velocity_min = missing, velocity_max = missing;  ///< of the link over the cycle [m/s | rad/s]
    double period = missing;                                ///< s
    double stick_fraction = missing;                        ///< share of the period at rest or below a hundredth of V_0
    double overshoot = missing;  ///< largest excess of position over the steady path after the disturbance, per δ_ss
    std::vector<std::complex<double>> multipliers;  ///< Floquet, where shooting found the cycle
    int repeats = 1;                                ///< turns after which a period-n motion repeats
    Criticality criticality = Criticality::none;    ///< of the crossing at k_cr
    double lyapunov = missing;               ///< first Lyapunov coefficient at k_cr: sign decides the criticality
    double fold_k_p = missing;               ///< gain above which no limit cycle is left [N/m | N·m/rad]
    DecisionPath path = DecisionPath::none;  ///< by which computation it was decided
    Reason reason = Reason::none;            ///< why it is undecided
    Detail detail = Detail::none;            ///< where more is known than the reason says
    Detail growth_missing = Detail::none;    ///< why there is no growth rate
    Detail fold_missing = Detail::none;      ///< why a fold was looked for and not found
    LargerTried searched_from = LargerTried::none;  ///< larger disturbances, where the stated one decays
    /// The encoder's steps, noise or forces that change on the way alone lead into the cycle, although smaller
    /// disturbances decay.
    bool noise_suffices = false;
    /// Places at which what changes slowly (a load, a wave of the friction, a drift) was held; the answer is that of
    /// the worst. 0: nothing was.
    int held_places = 0;
    bool places_alike = true;    ///< all of them have its outcome and region
    bool used_fallback = false;  ///< CVODE gave up on the way and Rodas5P finished

    /// Whether what does not slide on comes to rest for good, where limits keep its static friction from breaking.
    bool comes_to_rest() const
    {
        const bool after_larger = outcome == Outcome::stable_sliding && region == NonlinearRegion::bistable;
        return outcome == Outcome::held || (after_larger && stick_fraction == 1 && period != period);
    }
};

}  // namespace stickslip
