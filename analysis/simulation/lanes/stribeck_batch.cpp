#include "analysis/simulation/lanes/stribeck_batch.h"

#include "analysis/numerics/polynomial.h"
#include "analysis/simulation/lanes/grouping.h"
#include "analysis/stability/steady.h"

namespace stickslip::lanes {
namespace {

constexpr double stiffest = 100;  ///< damping, in units of √(k_p m), beyond which an explicit method creeps
constexpr double largest_rho = 500;

}  // namespace

std::optional<StribeckScaled> stribeck_scaled(const Joint& joint)
{
    const auto* law = std::get_if<Stribeck>(&joint.friction.law);
    if (!law || (law->c4 != 1 && law->c4 != 2) || !single(joint) || !plain(joint.friction, joint.load)) return {};
    const auto sliding = steady_sliding(joint);
    const auto& control = joint.control;
    const double m = joint.mechanism.inertia, V0 = sliding.velocity;
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
    using Complex = std::complex<double>;
    StribeckJob job;
    job.groups = g;
    const auto roots = quadratic_roots(g.damping(), 1);
    const Complex s = roots[1].real() > roots[0].real() ? roots[1] : roots[0];
    const Complex left[2] = {-1.0 / s, 1};
    for (int i = 0; i < 2; ++i) job.left[i][0] = left[i].real(), job.left[i][1] = left[i].imag();
    job.rate = s.real();
    job.magnitude = std::abs(s);
    job.window = growth_window(s);
    job.fineness = growth_fineness(s, job.window);
    job.start[0] = probe * std::max(1.0, job.magnitude), job.start[1] = 0;  // so that |l·y| ≥ probe
    job.search = search;
    return job;
}

bool write(const StribeckAnswer& a, const StribeckScaled& s, const StribeckJob& job, bool searched, PointResult& point)
{
    point.growth_rate = a.growth / s.time;
    if (a.ending == Ending::left_over) return false;
    const double length = s.velocity * s.time;
    point.path = DecisionPath::lanes;
    point.overshoot = small_disturbance / job.magnitude * length / std::abs(s.deflection);
    const bool cycle = a.ending != Ending::decays;
    point.outcome = a.ending != Ending::cycle ? Outcome::stable_sliding
                    : a.rest_time > 0         ? Outcome::stick_slip
                                              : Outcome::limit_cycle;
    if (a.ending == Ending::bistable && searched) point.region = Region::bistable;
    if (!cycle) return true;
    point.amplitude = 0.5 * (a.x_max - a.x_min) * length;
    point.velocity_min = s.velocity * (1 + a.u_min);
    point.velocity_max = s.velocity * (1 + a.u_max);
    point.period = a.period * s.time;
    point.stick_fraction = a.rest_time / a.period;
    if (a.ending == Ending::cycle) point.overshoot = std::max(0.0, a.x_max) * length / std::abs(s.deflection);
    return true;
}

}  // namespace stickslip::lanes
