// The linear answer for one joint: steady sliding, velocity-only verdict, state-variable verdict, and the row of a
// sweep.
#pragma once
#include <complex>
#include <vector>

#include "analysis/base/crossing.h"
#include "analysis/joint/joint.h"
#include "analysis/loop/loop_use.h"
#include "analysis/results/point.h"

namespace stickslip {

/// Steady sliding at the commanded velocity, as the controller reads it.
struct SteadySliding {
    double velocity = missing;     ///< V_0, commanded [m/s | rad/s]
    double slides_at = missing;    ///< V, V_0 per `sensor.position_scale`: where the joint really slides [m/s | rad/s]
    double friction = missing;     ///< f_ss(V) [N | N·m]
    double deflection = missing;   ///< δ_ss, position error as read [m | rad]; f_ss(V_0)/k_p of the ideal loop
    Reason reason = Reason::none;  ///< why there is none
};

/// Friction replaced by its steady-state curve, (20)-(21): m s² + (k_v + f_ss'(V_0)) s + k_p = 0, so that one mass is
/// stable for k_p > 0 and k_v > −f_ss'(V_0).
struct VelocityOnlyVerdict {
    bool stable = false;       ///< every root left of the imaginary axis
    bool neutral = false;      ///< a root on the imaginary axis, none right of it: disturbances neither decay nor grow
    double k_v_min = missing;  ///< max(0, −f_ss'(V_0)): least gain, to be exceeded [N·s/m | N·m·s/rad]
    std::vector<Interval> stable_k_v;  ///< at the joint's k_p: (k_v_min, ∞) for one mass, windows for several
    double slope = missing;            ///< f_ss'(V_0) [N·s/m | N·m·s/rad]
};

/// Friction with memory, (27)-(37): m s² + (k_v + f_v − G(s)) s + k_p = 0, G the Laplace transform of the kernel g(t)
/// with which friction answers past changes of velocity.
struct StateVariableVerdict {
    bool stable = false;                            ///< every root left of the imaginary axis
    bool neutral = false;                           ///< as above
    double spectral_abscissa = missing;             ///< 0 where only rounding is left of it
    std::vector<std::complex<double>> eigenvalues;  ///< 1/s, rightmost first
    std::vector<std::complex<double>> multipliers;  ///< of a sampled loop, from sample to sample: z = e^{sT}
    bool all_eigenvalues = true;                    ///< with delays or a table only some of the rightmost are known
    double f_v = missing;                    ///< direct effect ∂f/∂V at constant state, (14) [N·s/m | N·m·s/rad]
    double kernel_integral = missing;        ///< ∫g dt from 0 to ∞ [N·s/m | N·m·s/rad]: f_ss' = f_v − ∫g
    std::vector<Crossing> crossings;         ///< of the imaginary axis, over k_p
    std::vector<Interval> stable_intervals;  ///< in k_p, decided by the spectrum
    double k_cr = missing;                   ///< the single critical gain [N/m | N·m/rad], NaN where there is none
    double searched_from = 0;                ///< k_p from which crossings are complete: above 0 where k_p moves sliding
    double searched_to = infinity;           ///< and up to which; finite there, and where delays go on
    double gain_margin_db = missing;         ///< least change of the loop gain, either way, that makes it unstable
    double phase_margin_deg =
        missing;                     ///< at |L| = 1, broken at the command: to the nearest instability by phase alone
    std::vector<Interval> doubtful;  ///< bands of ω in which a touch of the axis could not be excluded
};

/// Both verdicts on one joint, and what they are about.
struct LinearVerdict {
    SteadySliding steady;                 ///< what the verdicts are about
    LoopUse loop;                         ///< which loop the verdicts are about
    VelocityOnlyVerdict velocity_only;    ///< without memory
    StateVariableVerdict state_variable;  ///< with memory
};

/// Everything the linear theory says about one joint. A joint without steady sliding gives NaN and the reason; nothing
/// is thrown.
LinearVerdict linear_verdict(const Joint& joint);

/// Which loop that verdict is of, without the verdict: of the joint's loop, but for an integral that a limit stops.
LoopUse verdict_loop(const Joint& joint);

/// max Re s [1/s] with memory alone, without the search for critical gains, which costs much where memory is a delay or
/// a table. NaN where there is no verdict.
double growth_rate(const Joint& joint);
/// The same with friction replaced by its steady-state curve.
double velocity_only_growth_rate(const Joint& joint);

/// The same verdicts as one row of a sweep; without allocation for a single mass with at most one state. Safe to call
/// from many threads.
PointResult linear_point(const Joint& joint);

}  // namespace stickslip
