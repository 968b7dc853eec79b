// Two ways to use CVODE for the outcome of a point, as measures of speed: the plain one that a user would write first,
// and one with every trick short of batching. Neither is the product's reference solver.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/analysis/simulation/lanes/cvode_groups.h"

namespace stickslip::benchmark {

struct SlipJoint {
    double V0, k_v, k_p;
};
inline constexpr double A = 1, B = 1.5, L = 1e-5, inertia = 1, f0 = 60, V_star = 1e-6;
inline constexpr double kick = 0.01, watched_turns = 50, large_swing = 0.3;

inline lanes::Groups groups_of(const SlipJoint& j)
{
    return {j.k_p * L / A, inertia * j.V0 * j.V0 / (L * A), B / A, j.k_v * j.V0 / A};
}
/// A turn of the undamped slow oscillation, in units of L/V_0.
inline double natural_turn(const lanes::Groups& g)
{
    return 2 * std::numbers::pi * std::sqrt((g.M + g.c + 1) / g.K);
}

enum class Judged { decays, oscillates, failed, unsure };

/// Plain: x, ln V, θ in SI units, one solver a point, Jacobian by differences, fifty turns, then look at the amplitude.
inline Judged plain_cvode(const SlipJoint& joint, double rtol)
{
    struct Problem {
        SlipJoint j;
        double f_ss;
    } problem{joint, f0 + (A - B) * std::log(joint.V0 / V_star)};
    const auto rate = [](double, N_Vector y, N_Vector out, void* user) {
        const auto& p = *static_cast<Problem*>(user);
        const double *s = NV_DATA_S(y), V = std::exp(s[1]), log = s[1] - std::log(V_star);
        double* d = NV_DATA_S(out);
        d[0] = V - p.j.V0;
        d[1] = -(p.j.k_v * d[0] + p.j.k_p * s[0] + f0 + A * log + s[2] - p.f_ss) / (inertia * V);
        d[2] = -(V / L) * (s[2] + B * log);
        return 0;
    };
    CvodeSolver solver(rate);
    double* s = NV_DATA_S(solver.y);
    s[0] = 0;
    s[1] = std::log((1 + kick) * joint.V0);
    s[2] = -B * std::log(joint.V0 / V_star) - A * std::log(1 + kick) - joint.k_v * kick * joint.V0;
    double* tolerance = NV_DATA_S(solver.tolerance);
    tolerance[0] = rtol * L, tolerance[1] = tolerance[2] = rtol;
    CVodeReInit(solver.cvode, 0, solver.y);
    CVodeSVtolerances(solver.cvode, rtol, solver.tolerance);
    CVodeSetUserData(solver.cvode, &problem);
    const double end = watched_turns * natural_turn(groups_of(joint)) * L / joint.V0;
    double t = 0, swing = 0;
    while (t < end) {
        if (CVode(solver.cvode, end, solver.y, &t, CV_ONE_STEP) < 0) return Judged::failed;
        if (t > 0.6 * end) swing = std::max(swing, std::abs(s[1] - std::log(joint.V0)));
    }
    return swing > large_swing ? Judged::oscillates : Judged::decays;
}

/// Tuned: dimensionless groups, one solver for all, exact Jacobian, root-finding on V = V_0, and an early end: when the
/// slow mode has shrunk by three, or two successive turns agree in their extrema.
class TunedCvode {
  public:
    explicit TunedCvode(double rtol) : solver_(&groups_rate)
    {
        CVodeSStolerances(solver_.cvode, rtol, rtol);
        CVodeSetJacFn(solver_.cvode, &groups_jacobian);
        CVodeRootInit(solver_.cvode, 1, [](double, N_Vector y, double* g, void*) {
            g[0] = NV_DATA_S(y)[1];
            return 0;
        });
        int down = -1;
        CVodeSetRootDirection(solver_.cvode, &down);
    }

    Judged judge(const lanes::Job& job)
    {
        g_ = job.groups;
        const SmallDisturbance mode(g_);
        double* s = NV_DATA_S(solver_.y);
        s[0] = 0, s[1] = std::log1p(kick), s[2] = -(s[1] + g_.c * kick);
        CVodeReInit(solver_.cvode, 0, solver_.y);
        CVodeSetUserData(solver_.cvode, &g_);
        const double start = mode.size(s), end = watched_turns * natural_turn(g_);
        double t = 0, high = 0, low = 0, last_high = 0, last_low = 0, peak = 0;
        while (t < end) {
            const int flag = CVode(solver_.cvode, end, solver_.y, &t, CV_ONE_STEP);
            if (flag < 0) return Judged::failed;
            high = std::max(high, s[1]), low = std::min(low, s[1]);
            if (mode.size(s) < start / 3) return Judged::decays;
            if (flag != CV_ROOT_RETURN) continue;
            const bool same = std::abs(high - last_high) < 1e-3 * high && std::abs(low - last_low) < 1e-3 * -low;
            if (high > large_swing && same) return Judged::oscillates;
            peak = high;
            last_high = high, last_low = low, high = low = 0;
        }
        return peak > large_swing ? Judged::oscillates : mode.size(s) < start ? Judged::decays : Judged::unsure;
    }

  private:
    CvodeSolver solver_;
    lanes::Groups g_{};
};

}  // namespace stickslip::benchmark
