#include "analysis/simulation/lanes/watched_batch.h"

#include <algorithm>
#include <tuple>

#include "analysis/simulation/attractor/growth.h"
#include "analysis/simulation/attractor/large_starts.h"
#include "analysis/simulation/lanes/grouping.h"
#include "analysis/simulation/lanes/two_mass_joint.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/spectrum.h"
#include "analysis/stability/steady.h"

namespace stickslip::lanes {
namespace {

WatchedScaled in_units(const Joint& joint, double length, double force)
{
    const auto sliding = steady_sliding(joint);
    const double V0 = sliding.slides_at;
    WatchedScaled s;
    s.length = length, s.velocity = V0, s.force = force, s.deflection = displaced(joint, sliding);
    s.groups.K = rounded(joint.control.k_p * length / force);
    s.groups.M = rounded(joint.mechanism.inertia * V0 * V0 / (length * force));
    return s;
}

std::optional<WatchedScaled> two_states(const Joint& joint)
{
    const auto* slip = std::get_if<RateAndState>(&joint.friction.law);
    const auto* ageing = std::get_if<Ageing>(&joint.friction.law);
    const RateStateParameters* law = slip;
    if (ageing) law = ageing;
    if (!law || law->B.size != 2 || !(law->B[0] > 0 && law->B[1] > 0)) return {};
    const double A = joint.friction.normal_load * law->A;
    WatchedScaled s = in_units(joint, law->L[0], A);
    s.groups.law = slip ? WatchedLaw::two_slip_states : WatchedLaw::two_ageing_states;
    s.groups.c = rounded(joint.control.k_v * s.velocity / A);
    s.groups.own[0] = rounded(law->B[0] / law->A), s.groups.own[1] = rounded(law->B[1] / law->A);
    s.groups.own[2] = rounded(law->L[0] / law->L[1]);
    return s;
}

std::optional<WatchedScaled> bristles(const Joint& joint)
{
    const auto* law = std::get_if<LuGre>(&joint.friction.law);
    if (!law) return {};
    const double V0 = steady_sliding(joint).slides_at, load = joint.friction.normal_load;
    const double level = law->level(V0).value, speeds = V0 / law->stribeck_velocity;
    WatchedScaled s = in_units(joint, level / law->sigma0, load * level);
    s.groups.law = WatchedLaw::lugre;
    s.groups.c = rounded((joint.control.k_v + load * law->sigma2) * V0 / (load * level));
    s.groups.own[0] = rounded(law->sigma1 * V0 / level);
    s.groups.own[1] = rounded((level - law->coulomb) / level);
    s.groups.own[2] = rounded(speeds * speeds);
    return s;
}

/// A joint of these groups whose units are those of its law.
Joint joint_of(const WatchedGroups& g)
{
    Joint joint;
    joint.mechanism.inertia = g.M;
    joint.control.k_p = g.K, joint.control.k_v = g.c, joint.control.V0 = 1;
    RateStateParameters states;
    states.f0 = 0, states.A = 1, states.V_star = 1;
    if (g.law == WatchedLaw::lugre) {
        LuGre law;
        law.sigma0 = 1, law.sigma1 = g.own[0], law.sigma2 = 0;
        law.coulomb = 1 - g.own[1], law.breakaway = law.coulomb + g.own[1] * std::exp(g.own[2]);
        law.stribeck_velocity = 1 / std::sqrt(g.own[2]);
        joint.friction.law = law;
        return joint;
    }
    states.B.push_back(g.own[0]), states.B.push_back(g.own[1]);
    states.L.push_back(1), states.L.push_back(1 / g.own[2]);
    if (g.law == WatchedLaw::two_slip_states) {
        RateAndState law;
        static_cast<RateStateParameters&>(law) = states;
        joint.friction.law = law;
    } else {
        Ageing law;
        static_cast<RateStateParameters&>(law) = states;
        joint.friction.law = law;
    }
    return joint;
}

/// The equations of motion in the units of the law, and which of their components each unknown is.
struct ScaledMass {
    Joint joint;
    SlidingFlow flow;
    explicit ScaledMass(const WatchedGroups& g) : joint(joint_of(g)), flow(sliding_flow(joint).flow) {}
    double abscissa() const { return spectral_abscissa(linear_mass(joint, 1)); }
    static int place(int unknown) { return unknown; }
};
struct ScaledPair {
    Joint joint;
    ChainFlow flow;
    std::array<int, most_unknowns> places;
    explicit ScaledPair(const WatchedGroups& g)
        : joint(two_mass_joint(g)), flow(chain_flow(joint).flow), places(places_in_chain(g))
    {
    }
    double abscissa() const { return spectral_abscissa(linear_joint(joint, 1)); }
    int place(int unknown) const { return places[static_cast<std::size_t>(unknown)]; }
};

template <class Scaled>
void take(const Scaled& scaled, const FlowVector& values, double* unknowns)
{
    for (int k = 0; k < scaled.flow.size(); ++k) unknowns[k] = values[scaled.place(k)];
}

template <class Scaled>
void set_starts(const Scaled& scaled, bool search, WatchedJob& job)
{
    const auto& flow = scaled.flow;
    const auto mode = slow_mode(flow);
    const FlowVector small =
        disturbed(flow, mode, DisturbanceKind::position, default_size(flow, mode, DisturbanceKind::position));
    take(scaled, flow.scale(), job.scale);
    job.rate = scaled.abscissa();
    job.frequency = std::abs(mode.s.imag());
    take(scaled, (job.rate > 0 ? lifted(flow, mode, small) : small) - mode.steady, job.start);
    if (!search) return;
    for (const auto& start : large_starts(flow, mode).y)
        if (start.allFinite()) take(scaled, start - mode.steady, job.larger[job.searches++]);
}

/// False where there is no such state.
template <class Scaled>
bool set_stated(const Scaled& scaled, DisturbanceKind kind, double size, WatchedJob& job)
{
    const auto mode = slow_mode(scaled.flow);
    const FlowVector y = disturbed(scaled.flow, mode, kind, size);
    take(scaled, y - mode.steady, job.start);
    return y.allFinite();
}

constexpr double largest_group = 1e9, largest_rho = 500;

std::optional<WatchedScaled> one_mass(const Joint& joint)
{
    if (!single(joint) || !plain(joint.friction, joint.load) || !(joint.friction.normal_load > 0)) return {};
    return std::holds_alternative<LuGre>(joint.friction.law) ? bristles(joint) : two_states(joint);
}

}  // namespace

std::optional<WatchedScaled> watched_scaled(const Joint& joint)
{
    const auto sliding = steady_sliding(joint);
    const bool forwards = sliding.reason == Reason::none && sliding.slides_at > 0;
    if (!forwards || !(joint.control.k_p > 0 && joint.control.k_v >= 0)) return {};
    const auto s = joint.mechanism.model == Model::single_mass ? one_mass(joint) : two_masses(joint);
    if (!s) return {};
    const auto& g = s->groups;
    bool in_range = g.K > 0 && g.K < largest_group && g.M > 1 / largest_group && g.M < largest_group;
    in_range = in_range && g.c < largest_group;
    for (const double own : g.own) in_range = in_range && own >= 0 && own < largest_group;
    if (g.law == WatchedLaw::lugre) in_range = in_range && g.own[2] > 0 && g.own[2] < largest_rho && g.own[1] < 1;
    if (!g.two_masses()) return in_range ? s : std::nullopt;
    const auto& pair = g.pair;
    for (const double positive : {pair.stiffness, pair.motor_inertia, pair.share, pair.faster})
        in_range = in_range && positive > 1 / largest_group && positive < largest_group;
    for (const double other : {pair.damping, pair.link, pair.motor})
        in_range = in_range && other >= 0 && other < largest_group;
    return in_range ? s : std::nullopt;
}

auto numbers_of(const PairGroups& g)
{
    return std::tie(g.stiffness, g.damping, g.motor_inertia, g.measured_link, g.link, g.motor, g.share, g.faster);
}

bool less(const WatchedGroups& a, const WatchedGroups& b)
{
    if (a.law != b.law) return a.law < b.law;
    if (a.M != b.M) return a.M < b.M;
    if (a.c != b.c) return a.c < b.c;
    if (a.K != b.K) return a.K < b.K;
    if (a.pair != b.pair) return numbers_of(a.pair) < numbers_of(b.pair);
    return std::lexicographical_compare(std::begin(a.own), std::end(a.own), std::begin(b.own), std::end(b.own));
}

WatchedJob job(const WatchedGroups& g, bool search)
{
    WatchedJob job{};
    job.groups = g;
    g.two_masses() ? set_starts(ScaledPair(g), search, job) : set_starts(ScaledMass(g), search, job);
    return job;
}

bool state(const Disturbance& d, const Joint& joint, const WatchedScaled& scale, WatchedJob& job)
{
    const auto& g = job.groups;
    const std::size_t link = g.two_masses() ? 1 : 0;
    double size = d.size;
    switch (d.kind) {
        case DisturbanceKind::position:
        case DisturbanceKind::offset:
            size /= scale.length;
            break;
        case DisturbanceKind::velocity:
            size /= scale.velocity;
            break;
        case DisturbanceKind::impulse:
            size *= job.groups.M / (chain_of(joint).body[link].inertia * scale.velocity);
            break;
        case DisturbanceKind::state:
            size /= scale.force;
            break;
        case DisturbanceKind::start:
            break;
    }
    job.stated = true;
    const bool finite =
        g.two_masses() ? set_stated(ScaledPair(g), d.kind, size, job) : set_stated(ScaledMass(g), d.kind, size, job);
    for (double& value : job.start) value = rounded(value);
    return finite && std::any_of(std::begin(job.start), std::end(job.start), [](double x) { return x != 0; });
}

bool write(const WatchedAnswer& a, const WatchedScaled& s, const WatchedJob& job, PointResult& point)
{
    point.growth_rate = job.rate * s.velocity / s.length;
    if (a.ending == Ending::left_over) return false;
    const double per_deflection = s.length / std::abs(s.deflection);
    const auto speed = [&](double w) { return s.velocity * (job.groups.logarithmic() ? std::exp(w) : 1 + w); };
    point.path = DecisionPath::lanes;
    const bool goes_on = a.reached || a.ending == Ending::undecided;
    point.overshoot = std::max({0.0, goes_on ? a.x_max : 0.0, a.peak}) * per_deflection;  // a lifted one has no peak
    point.outcome = a.ending == Ending::undecided ? Outcome::undecided : a.reached ? a.cycle : Outcome::stable_sliding;
    if (a.ending == Ending::undecided && point.reason == Reason::none) point.reason = Reason::not_converged;
    if (a.ending == Ending::bistable) point.region = Region::bistable;
    if (a.ending == Ending::decays || a.ending == Ending::undecided) return true;
    point.amplitude = 0.5 * (a.x_max - a.x_min) * s.length;
    point.velocity_min = speed(a.w_min);
    point.velocity_max = speed(a.w_max);
    point.period = a.cycle == Outcome::irregular ? missing : a.period * s.length / s.velocity;
    point.stick_fraction = a.rest_time / a.period;
    return true;
}

}  // namespace stickslip::lanes
