#include "analysis/simulation/set_point/slip.h"

#include <Eigen/Dense>
#include <unsupported/Eigen/MatrixFunctions>

#include "analysis/numerics/polynomial.h"
#include "analysis/numerics/root.h"

namespace stickslip {
namespace {

/// A unit of time in which the coefficients of the cubic are of order one, so that the exponential loses nothing.
double time_unit(const PidMass& mass)
{
    return std::cbrt(mass.inertia / mass.k_i);
}

/// Up to where the slip is looked at, and by which steps: at first fine enough for the ripple that a fast pair of roots
/// leaves on a slow one, which dips deepest in its first turns.
struct Scan {
    double first, last, fine, fastest;
    double after(double t) const
    {
        constexpr double growth = 0.1, per_turn = 0.05;
        return t < fine ? t + std::min(growth * t, per_turn / fastest) : (1 + growth) * t;
    }
};
Scan scan_of(const PidMass& mass)
{
    constexpr double early = 1e-2, delayed = 1e4, turns = 20;
    const auto roots = cubic_roots(mass.damping / mass.inertia, mass.k_p / mass.inertia, mass.k_i / mass.inertia);
    double fastest = 0, slowest = infinity;
    for (const auto& s : roots) fastest = std::max(fastest, std::abs(s)), slowest = std::min(slowest, std::abs(s));
    return {early / fastest, delayed / slowest, turns / fastest, fastest};
}

constexpr double precision_of_slip = 1e-15;

/// The first zero of h, NaN if it never swings back.
double first_zero_of_response(const PidMass& mass)
{
    const auto scan = scan_of(mass);
    const auto h = [&](double t) { return slip_response(mass, t).h; };
    double before = scan.first, value = h(before);
    for (double t = scan.after(before); t < scan.last; t = scan.after(t)) {
        const double now = h(t);
        if (now <= 0) return bracketed_root(h, before, value, t, now, precision_of_slip).value;
        before = t, value = now;
    }
    return missing;
}

/// ḣ1 (2 − h2) + k_i h1², of which the first zero is the slip time.
double closing(const PidMass& mass, const SlipResponse& r)
{
    return r.rate * (2 - mass.k_i * r.integral) + mass.k_i * r.h * r.h;
}

/// It lies before the first zero of h1, just before for a loop that is hardly damped.
double slip_time(const PidMass& mass)
{
    const auto scan = scan_of(mass);
    const auto f = [&](double t) { return closing(mass, slip_response(mass, t)); };
    double before = scan.first, value = f(before);
    for (double t = scan.after(before); t < scan.last && value > 0; t = scan.after(t)) {
        const auto r = slip_response(mass, t);
        const double end = r.h > 0 ? t : first_zero_of_response(mass), now = r.h > 0 ? closing(mass, r) : f(end);
        if (now <= 0) return bracketed_root(f, before, value, end, now, precision_of_slip).value;
        if (r.h <= 0) break;
        before = t, value = now;
    }
    return missing;
}

}  // namespace

SlipResponse slip_response(const PidMass& mass, double t)
{
    // (H, h, ḣ, ḧ) in units of time_unit: an exponential needs no case for real, complex or repeated roots
    const double unit = time_unit(mass), m = mass.inertia;
    Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
    A(0, 1) = A(1, 2) = A(2, 3) = 1;
    A(3, 1) = -mass.k_i / m * unit * unit * unit;
    A(3, 2) = -mass.k_p / m * unit * unit;
    A(3, 3) = -mass.damping / m * unit;
    const Eigen::Vector4d y = (A * (t / unit)).exp().col(3) / m;
    return {y[1] * unit * unit, y[2] * unit, y[3], y[0] * unit * unit * unit};
}

HuntingCycle hunting_cycle(const PidMass& mass, const DryFriction& friction)
{
    HuntingCycle cycle;
    const double drop = friction.breakaway - friction.coulomb;
    if (!mass.stable() || !(drop > 0)) return cycle;
    const double T = slip_time(mass);
    if (!is_set(T)) return cycle;
    const auto r = slip_response(mass, T);
    const double ramped = mass.k_i * r.integral;  // h2(T)
    const double a = drop * r.h / (2 - ramped);
    const double push = friction.coulomb + mass.inertia * (drop * r.acceleration + a * mass.k_i * r.rate);
    cycle.found = true;
    cycle.amplitude = a;
    cycle.slip_time = T;
    cycle.stick_time = (push + friction.breakaway) / (mass.k_i * a);
    cycle.multiplier = ramped - 1;
    return cycle;
}

double settling_multiplier(const PidMass& mass)
{
    if (!mass.stable()) return missing;
    const double T = first_zero_of_response(mass);
    // roots that are all real: the mass creeps towards the set point without an end of the slip
    return is_set(T) ? mass.k_i * slip_response(mass, T).integral - 1 : 0;
}

}  // namespace stickslip
