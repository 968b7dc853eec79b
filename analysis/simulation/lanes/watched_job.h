// Questions to the lanes of laws whose motions may come back after several turns, and their answers: plain numbers in
// dimensionless groups.
#pragma once
#include "analysis/simulation/lanes/job.h"

namespace stickslip::lanes {

enum class WatchedLaw : std::uint8_t { two_slip_states, two_ageing_states, lugre };

/// A single mass, in the units of its law.
/// Two states: X = x/L_1, w = ln(V/V_0), p = (θ_1 − θ_ss)/A, q likewise, time in L_1/V_0, and the equations of job.h,
///   M e^w w' = −(c (e^w − 1) + K X + w + p + q),   q' as p' but for β_2 and λ = L_1/L_2 times as fast.
/// LuGre, with g = g(V_0) and l = g/σ0: X = x/l, w = V/V_0 − 1, p = z/l − 1, forces per g, time in l/V_0,
///   M w' = −(c w + K X + p + s p'),   p' = (1 + w) − |1 + w| (1 + p)/G,   G = 1 + a (e^{−ρ w (2 + w)} − 1).
/// About steady sliding all unknowns are 0.
struct WatchedGroups {
    WatchedLaw law;
    double K;       ///< k_p L_1/A, k_p/σ0 and the load it bears
    double M;       ///< m V_0²/(L_1 A), m V_0²/(l g)
    double c;       ///< k_v V_0/A, (k_v + σ2) V_0/g
    double own[3];  ///< β_1, β_2, λ; s = σ1 V_0/g, a = (F_s − F_c) e^{−ρ}/g, ρ = (V_0/v_s)²
    bool operator==(const WatchedGroups&) const = default;

    int unknowns() const { return law == WatchedLaw::lugre ? 3 : 4; }
};

inline constexpr int most_searches = 4;

struct WatchedJob {
    WatchedGroups groups;
    double rate;       ///< real part of the slow eigenvalue
    double frequency;  ///< its imaginary part, not negative
    bool stated;       ///< `start` is a disturbance of stated size; otherwise a small one, lifted where it grows
    double start[4];   ///< X, w, p, q
    double scale[4];   ///< changes of order one
    int searches;      ///< larger starts that are followed, too, where the disturbance decays
    double larger[most_searches][4];
};

struct WatchedAnswer {
    Ending ending = Ending::left_over;
    Outcome cycle = Outcome::not_asked;  ///< what the motion is that comes back, like all that follows
    double w_min = 0, w_max = 0;
    double x_min = 0, x_max = 0;
    double period = 0;
    double rest_time = 0;  ///< with V below a hundredth of V_0
    double peak = missing;
    bool reached = false;
    int turns = 0;
    long steps = 0;
};

void run(const WatchedJob* jobs, WatchedAnswer* answers, std::size_t count, const Settings& settings,
         Instructions instructions);

}  // namespace stickslip::lanes
