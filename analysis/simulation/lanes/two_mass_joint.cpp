#include "analysis/simulation/lanes/two_mass_joint.h"

#include "analysis/simulation/flows/flow.h"
#include "analysis/simulation/lanes/grouping.h"
#include "analysis/simulation/lanes/one_of_two_masses.h"
#include "analysis/stability/linear_joint.h"
#include "analysis/stability/steady.h"

namespace stickslip::lanes {
static_assert(slowest_logarithm == least_logarithm);

namespace {

/// A mass as its friction has it, in joint coordinates.
struct Mass {
    OneState memory;
    double A = 0, L = 0, B = 0;  ///< of its law
    double viscous = 0;          ///< without one
    double inertia = 0;
};

std::optional<Mass> mass_of(const Body& body, const Load& load)
{
    const Friction& f = *body.friction;
    if (!plain(f, load) || !(f.normal_load > 0)) return {};
    Mass mass;
    mass.inertia = body.inertia;
    mass.memory = one_state(f);
    if (const auto* law = mass.memory.law) {
        const double per_force = body.ratio * f.normal_load;
        mass.A = per_force * law->A, mass.B = per_force * law->B[0], mass.L = law->L[0] / body.ratio;
        return mass.A > 0 && mass.B > 0 ? std::optional(mass) : std::nullopt;
    }
    const auto* static_law = std::get_if<CoulombViscous>(&f.law);
    if (!static_law || static_law->coulomb != 0) return {};
    mass.viscous = body.ratio * body.ratio * f.normal_load * static_law->viscous;
    return mass;
}

/// Two masses under position feedback alone, the spring between them linear.
bool simple_pair(const Joint& joint)
{
    const auto& m = joint.mechanism;
    const auto& c = joint.control;
    return m.model == Model::two_mass && m.transmission.backlash == 0 && !m.hardens() &&
           c.kind == ControlKind::position && c.contact_stiffness == 0 && c.force_gain == 0 && !joint.normal.moves() &&
           joint.neighbour.size == 0;
}

WatchedLaw law_of(const Mass& link, const Mass& motor)
{
    const bool ageing = (link.memory.law ? link : motor).memory.kind == StateLaw::ageing;
    if (!motor.memory.law) return ageing ? WatchedLaw::ageing_on_link : WatchedLaw::slip_on_link;
    if (!link.memory.law) return ageing ? WatchedLaw::ageing_on_motor : WatchedLaw::slip_on_motor;
    return ageing ? WatchedLaw::ageing_on_both : WatchedLaw::slip_on_both;
}

/// β, or the viscous friction per `unit`.
double own_group(const Mass& mass, double unit)
{
    return rounded(mass.memory.law ? mass.B / mass.A : mass.viscous / unit);
}

FrictionLaw friction_of(const WatchedGroups& g, bool remembers, double own, double share, double faster)
{
    if (!remembers) return CoulombViscous{0, own};
    RateStateParameters law;
    law.f0 = 0, law.A = share, law.V_star = 1;
    law.B.push_back(own * share), law.L.push_back(1 / faster);
    if (g.ageing()) return Ageing{law};
    return RateAndState{law};
}

}  // namespace

std::optional<WatchedScaled> two_masses(const Joint& joint)
{
    if (!simple_pair(joint)) return {};
    const Chain chain = chain_of(joint);
    const auto motor = mass_of(chain.body[0], joint.load), link = mass_of(chain.body[1], joint.load);
    if (!motor || !link || !(motor->memory.law || link->memory.law)) return {};
    const bool both = motor->memory.law && link->memory.law;
    if (both && motor->memory.kind != link->memory.kind) return {};
    const auto sliding = steady_sliding(joint);
    const Mass& first = link->memory.law ? *link : *motor;
    const double V0 = sliding.slides_at, per_inertia = V0 * V0 / (first.L * first.A);
    WatchedScaled s{};
    s.length = first.L, s.velocity = V0, s.force = first.A, s.deflection = sliding.deflection;
    auto& g = s.groups;
    g.law = law_of(*link, *motor);
    g.K = rounded(joint.control.k_p * first.L / first.A);
    g.c = rounded(joint.control.k_v * V0 / first.A);
    g.M = rounded(link->inertia * per_inertia);
    auto& pair = g.pair;
    pair.stiffness = rounded(chain.stiffness[0] * first.L / first.A);
    pair.damping = rounded(chain.damping[0] * V0 / first.A);
    pair.motor_inertia = rounded(motor->inertia * per_inertia);
    pair.measured_link = joint.control.feedback == Feedback::link ? 1 : 0;
    pair.link = own_group(*link, first.A / V0), pair.motor = own_group(*motor, first.A / V0);
    pair.share = both ? rounded(motor->A / first.A) : 1;
    pair.faster = both ? rounded(first.L / motor->L) : 1;
    return s;
}

Joint two_mass_joint(const WatchedGroups& g)
{
    Joint joint;
    const auto& pair = g.pair;
    auto& m = joint.mechanism;
    m.model = Model::two_mass;
    m.motor_inertia = pair.motor_inertia, m.link_inertia = g.M;
    m.transmission.stiffness = pair.stiffness, m.transmission.damping = pair.damping;
    joint.control.k_p = g.K, joint.control.k_v = g.c, joint.control.V0 = 1;
    joint.control.feedback = pair.measured_link == 1 ? Feedback::link : Feedback::motor;
    joint.frictions.link.law = friction_of(g, g.remembers_on_link(), pair.link, 1, 1);
    joint.frictions.motor.law = friction_of(g, g.remembers_on_motor(), pair.motor, pair.share, pair.faster);
    return joint;
}

std::array<int, most_unknowns> places_in_chain(const WatchedGroups& g)
{
    std::array<int, most_unknowns> places{};
    constexpr int motor = 0, link = 1, masses = 2;
    const int state_of_motor = 2 * masses, state_of_link = state_of_motor + g.remembers_on_motor();
    int next = 0;
    places[next++] = link, places[next++] = masses + link;
    if (g.remembers_on_link()) places[next++] = state_of_link;
    places[next++] = motor, places[next++] = masses + motor;
    if (g.remembers_on_motor()) places[next++] = state_of_motor;
    return places;
}

}  // namespace stickslip::lanes
