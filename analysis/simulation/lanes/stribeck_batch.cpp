#include "analysis/simulation/lanes/stribeck_batch.h"

#include "analysis/numerics/polynomial.h"
#include "analysis/simulation/lanes/grouping.h"
#include "analysis/stability/steady.h"

namespace stickslip::lanes {
namespace {

constexpr double stiffest = 100;  ///< damping, in units of √(k_p m), beyond which an explicit method creeps
constexpr double largest_rho = 500;
constexpr double kick = 0.1;  ///< size of X to which a growing disturbance is lifted

}  // namespace

std::optional<StribeckScaled> stribeck_scaled(const Joint& joint)
{
    const auto* law = std::get_if<Stribeck>(&joint.friction.law);
    if (!law || (law->c4 != 1 && law->c4 != 2) || !single(joint) || !plain(joint.friction, joint.load)) return {};
    const auto sliding = steady_sliding(joint);
    const auto& control = joint.control;
    const double m = joint.mechanism.inertia, V0 = sliding.slides_at;
    if (sliding.reason != Reason::none || !(V0 > 0 && control.k_p > 0 && control.k_v >= 0)) return {};
    const double T = std::sqrt(m / control.k_p), load = joint.friction.normal_load, force = T / (m * V0);
    const int power = law->c4 == 2 ? 2 : 1;
    const double rho = std::pow(V0 / law->c3, power);
    const double release = (sliding.friction - load * (law->c0 + law->c2)) * force + control.k_v * T / m;
    StribeckScaled s{{rounded((control.k_v + load * law->c1) * T / m), rounded(load * law->c2 * std::exp(-rho) * force),
                      rounded(rho), rounded(release + 2 * load * (law->c0 + law->c2) * force), power},
                     T,
                     V0,
                     sliding.deflection};
    const auto& g = s.groups;
    const double steepest = std::abs(g.zeta) + std::abs(g.alpha) * g.rho * std::exp(g.rho);
    const bool in_range = g.rho < largest_rho && std::isfinite(steepest) && g.zeta < stiffest && g.reverse < 1e12;
    if (!in_range || !(g.reverse > g.release())) return {};
    return s;
}

bool less(const StribeckGroups& a, const StribeckGroups& b)
{
    if (a.power != b.power) return a.power < b.power;
    if (a.zeta != b.zeta) return a.zeta < b.zeta;
    if (a.alpha != b.alpha) return a.alpha < b.alpha;
    if (a.rho != b.rho) return a.rho < b.rho;
    return a.reverse < b.reverse;
}

StribeckJob job(const StribeckGroups& g, bool search)
{
    StribeckJob job{};
    job.groups = g;
    const auto roots = quadratic_roots(g.damping(), 1);
    const auto s = roots[1].real() > roots[0].real() ? roots[1] : roots[0];
    job.rate = s.real();
    job.frequency = std::abs(s.imag());
    job.start[0] = kick, job.start[1] = 0;  // V = V_0 and falling, where a turn begins
    job.search = search;
    return job;
}

bool state(const Disturbance& d, const Joint& joint, const StribeckScaled& scale, StribeckJob& job)
{
    double X = 0, u = 0;
    switch (d.kind) {
        case DisturbanceKind::position:
        case DisturbanceKind::offset:
            X = d.size / (scale.velocity * scale.time);
            break;
        case DisturbanceKind::velocity:
            u = d.size / scale.velocity;
            break;
        case DisturbanceKind::impulse:
            u = d.size / (joint.mechanism.inertia * scale.velocity);
            break;
        case DisturbanceKind::state:  // the law has none
            return false;
        case DisturbanceKind::start:
            X = job.groups.release(), u = -1;
            break;
    }
    job.stated = true;
    job.start[0] = rounded(X), job.start[1] = rounded(u);
    const bool forwards = d.kind == DisturbanceKind::start || u > -1;
    return (X != 0 || u != 0) && forwards && std::isfinite(X) && std::isfinite(u);
}

bool write(const StribeckAnswer& a, const StribeckScaled& s, const StribeckJob& job, PointResult& point)
{
    point.growth_rate = job.rate / s.time;
    if (a.ending == Ending::left_over) return false;
    const double length = s.velocity * s.time, per_deflection = length / std::abs(s.deflection);
    const double small_peak = small_disturbance / std::hypot(job.rate, job.frequency);
    point.path = DecisionPath::lanes;
    point.overshoot = std::max(0.0, job.stated ? a.peak : small_peak) * per_deflection;
    point.outcome = !a.reached ? Outcome::stable_sliding : a.rest_time > 0 ? Outcome::stick_slip : Outcome::limit_cycle;
    if (a.ending == Ending::bistable) point.region = Region::bistable;
    if (a.ending == Ending::decays) return true;
    point.amplitude = 0.5 * (a.x_max - a.x_min) * length;
    point.velocity_min = s.velocity * (1 + a.u_min);
    point.velocity_max = s.velocity * (1 + a.u_max);
    point.period = a.period * s.time;
    point.stick_fraction = a.rest_time / a.period;
    if (a.reached) point.overshoot = std::max({0.0, a.x_max, a.peak}) * per_deflection;
    return true;
}

}  // namespace stickslip::lanes
