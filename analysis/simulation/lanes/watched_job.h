// Questions to the lanes of laws whose motions may come back after several turns, and their answers: plain numbers in
// dimensionless groups.
#pragma once
#include "analysis/simulation/lanes/job.h"

namespace stickslip::lanes {

enum class WatchedLaw : std::uint8_t {
    two_slip_states,
    two_ageing_states,
    lugre,
    slip_on_link,  ///< two masses, like all that follow
    ageing_on_link,
    slip_on_motor,
    ageing_on_motor,
    slip_on_both,
    ageing_on_both
};

/// What two masses have beside the groups of one.
struct PairGroups {
    double stiffness, damping;  ///< of the transmission: k, d
    double motor_inertia;       ///< M_m
    double measured_link;       ///< 1: the loop measures the link, 0: the motor
    double link, motor;         ///< β_i of a rate-and-state law, F_i V_0/A of viscous friction
    double share, faster;       ///< of the motor's law beside the link's: A_m/A, L/L_m; otherwise 1
    bool operator==(const PairGroups&) const = default;
};

/// A joint in the units of its law.
/// Two states: X = x/L_1, w = ln(V/V_0), p = (θ_1 − θ_ss)/A, q likewise, time in L_1/V_0, and the equations of job.h,
///   M e^w w' = −(c (e^w − 1) + K X + w + p + q),   q' as p' but for β_2 and λ = L_1/L_2 times as fast.
/// LuGre, with g = g(V_0) and l = g/σ0: X = x/l, w = V/V_0 − 1, p = z/l − 1, forces per g, time in l/V_0,
///   M w' = −(c w + K X + p + s p'),   p' = (1 + w) − |1 + w| (1 + p)/G,   G = 1 + a (e^{−ρ w (2 + w)} − 1).
/// Two masses in joint coordinates, in the units of the link's law or else of the motor's: X_i, w_i and p_i of the mass
/// under a rate-and-state law, X_i and w_i = V_i/V_0 − 1 of one under viscous friction F_i, with X_i' = S_i,
///   M v_l w_l' = −(k (X_l − X_m) + d (S_l − S_m) + f_l),
///   M_m v_m w_m' = −(k (X_m − X_l) + d (S_m − S_l) + K X_j + c S_j + f_m),   j the measured mass,
/// where v_i = e^{w_i}, S_i = e^{w_i} − 1 and f_i = share_i w_i + p_i, or v_i = 1, S_i = w_i and f_i = F_i w_i. p_i' is
/// that of job.h but for share_i β_i in place of β and faster_i times as fast; share and faster of the link are 1.
/// About steady sliding all unknowns are 0.
struct WatchedGroups {
    WatchedLaw law;
    double K;       ///< k_p L_1/A, k_p/σ0 and the load it bears
    double M;       ///< m V_0²/(L_1 A), m V_0²/(l g); of the link
    double c;       ///< k_v V_0/A, (k_v + σ2) V_0/g
    double own[3];  ///< β_1, β_2, λ; s = σ1 V_0/g, a = (F_s − F_c) e^{−ρ}/g, ρ = (V_0/v_s)²; not of two masses
    PairGroups pair;  ///< of two masses
    bool operator==(const WatchedGroups&) const = default;

    bool two_masses() const { return law >= WatchedLaw::slip_on_link; }
    bool ageing() const
    {
        return law == WatchedLaw::two_ageing_states || law == WatchedLaw::ageing_on_link ||
               law == WatchedLaw::ageing_on_motor || law == WatchedLaw::ageing_on_both;
    }
    bool remembers_on_link() const { return two_masses() && !on_motor_alone(); }
    bool remembers_on_motor() const { return law >= WatchedLaw::slip_on_motor; }
    /// Whether w of the link, whose motion is watched, is a logarithm.
    bool logarithmic() const { return law != WatchedLaw::lugre && !on_motor_alone(); }
    int unknowns() const
    {
        if (two_masses()) return 4 + remembers_on_link() + remembers_on_motor();
        return law == WatchedLaw::lugre ? 3 : 4;
    }

  private:
    bool on_motor_alone() const { return law == WatchedLaw::slip_on_motor || law == WatchedLaw::ageing_on_motor; }
};

inline constexpr int most_searches = 4;

struct WatchedJob {
    WatchedGroups groups;
    double rate;       ///< real part of the slow eigenvalue
    double frequency;  ///< its imaginary part, not negative
    bool stated;       ///< `start` is a disturbance of stated size; otherwise a small one, lifted where it grows
    double start[most_unknowns];  ///< X, w, p, q; X, w and p of the link, then of the motor
    double scale[most_unknowns];  ///< changes of order one
    int searches;                 ///< larger starts that are followed, too, where the disturbance decays
    double larger[most_searches][most_unknowns];
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
