#include "analysis/joint/reduction.h"

#include <optional>
#include <stdexcept>
#include <type_traits>

namespace stickslip {
namespace {

constexpr const char* three_masses = "Fig. 5";

void require(bool fits, const char* wanted)
{
    if (!fits) throw std::invalid_argument(wanted);
}

/// Coulomb-viscous friction and nothing else, or nothing.
const CoulombViscous* simple(const Friction& f)
{
    return f.has_bristle() || f.has_memory() || f.has_lag() ? nullptr : std::get_if<CoulombViscous>(&f.law);
}

bool is_zero(const Friction& f)
{
    const auto* law = simple(f);
    return law && law->coulomb == 0 && law->viscous == 0 && f.asymmetry.coulomb == 0 && f.asymmetry.viscous == 0;
}

/// A law with a constant level and viscous friction beside it, where that is the same law with other numbers.
std::optional<FrictionLaw> with_level(const FrictionLaw& law, double level, double viscous)
{
    return std::visit(
        [&](auto l) -> std::optional<FrictionLaw> {
            using Law = decltype(l);
            if constexpr (std::is_same_v<Law, CoulombViscous>) {
                l.coulomb += level, l.viscous += viscous;
                return l;
            } else if constexpr (std::is_same_v<Law, Stribeck>) {
                l.c0 += level, l.c1 += viscous;
                return l;
            } else if constexpr (std::is_same_v<Law, KineticStatic>) {
                l.kinetic += level, l.breakaway += level;
                if (viscous == 0) return l;
            } else if constexpr (std::is_same_v<Law, RateAndState> || std::is_same_v<Law, Ageing>) {
                l.f0 += level;
                if (viscous == 0) return l;
            }
            return std::nullopt;
        },
        law);
}

/// One law for two bodies that move as one, where there is one; `turns` is the displacement of the first per that of
/// the second.
std::optional<Friction> single_law(const Friction& first, double turns, const Friction& second)
{
    if (is_zero(first)) return second;
    if (is_zero(second) && turns == 1) return first;
    // one of them is a level with viscous friction; a law of the first keeps its numbers only where both move alike
    const bool first_is_simple = simple(first) != nullptr;
    const auto* level = first_is_simple ? simple(first) : turns == 1 ? simple(second) : nullptr;
    const Friction& other = first_is_simple ? second : first;
    if (!level || other.has_bristle() || other.has_memory() || other.has_lag()) return std::nullopt;
    const double by = first_is_simple ? turns : 1;
    const double first_share = first.normal_load / other.normal_load;
    const double second_share = second.normal_load / other.normal_load;
    const double share = first_is_simple ? first_share : second_share;
    const auto law = with_level(other.law, share * by * level->coulomb, share * by * by * level->viscous);
    if (!law) return std::nullopt;
    Friction sum = second;
    sum.law = *law;
    sum.normal_load = other.normal_load;
    sum.asymmetry.coulomb = second_share * second.asymmetry.coulomb + first_share * turns * first.asymmetry.coulomb;
    sum.asymmetry.viscous =
        second_share * second.asymmetry.viscous + first_share * turns * turns * first.asymmetry.viscous;
    return sum;
}

/// Room for states and histories is that of one friction.
void require_room(Reduction& r)
{
    for (const bool on_link : {false, true}) {
        if (!on_link && r.joint.mechanism.model == Model::single_mass) continue;
        const Friction& own = on_link ? link_friction(r.joint) : r.joint.frictions.motor;
        int total = states(own), delayed = info(own.law).needs_history;
        for (const auto& j : r.joined)
            if (j.on_link == on_link) total += states(j.friction), delayed += info(j.friction.law).needs_history;
        require(total <= max_states, "the frictions that meet on one body have more states than one body may have");
        require(delayed <= 1, "two frictions that remember by delays or tables meet on one body");
    }
}

/// Makes the friction of one body act on another that moves with it.
void join(Reduction& r, const Friction& first, double turns, Friction& second, bool on_link)
{
    if (auto one = single_law(first, turns, second))
        second = std::move(*one);
    else
        r.joined.push_back({first, turns, on_link});
    require_room(r);
}

}  // namespace

Reduction lever_to_three_mass(const Joint& joint)
{
    require(joint.mechanism.model == Model::lever, "the reduction to three masses starts from the lever");
    Reduction r;
    r.joint = joint;
    r.name = "lever to three masses (Fig. 4 to 5)";
    r.model = three_masses;
    r.neglected = {"turning of the lever beyond small displacements"};
    auto& m = r.joint.mechanism;
    const double N = m.motor_transmission.ratio;
    m.model = Model::three_mass;
    m.transmission_inertia /= m.lever_arm * m.lever_arm;
    // a lever's first spring is at the motor's side; three masses have it at the joint side
    m.motor_transmission.stiffness *= N * N;
    m.motor_transmission.cubic_stiffness *= N * N * N * N;
    m.motor_transmission.damping *= N * N;
    return r;
}

Reduction three_mass_to_two_mass(const Joint& joint, Placement placement)
{
    require(joint.mechanism.model == Model::three_mass, "the reduction to two masses starts from three masses");
    const auto& from = joint.mechanism;
    require(from.transmission_link.ratio == 1, "the reduction to two masses needs the whole reduction at the motor");
    Reduction r;
    r.joint = joint;
    auto& m = r.joint.mechanism;
    m.model = Model::two_mass;
    r.joint.frictions.has_transmission = false;
    const double N = from.motor_transmission.ratio;
    if (placement == Placement::at_motor) {
        r.name = "three masses to two, transmission at the motor (Fig. 5 to 6)";
        r.model = "Fig. 6, transmission at the motor";
        r.neglected = {"the compliance between motor and transmission, k_{m-tr} against k_{tr-l}"};
        m.transmission = from.transmission_link;
        m.transmission.ratio = N;
        m.motor_inertia = from.motor_inertia + from.transmission_inertia / (N * N);
        join(r, joint.frictions.transmission, 1 / N, r.joint.frictions.motor, false);
    } else {
        r.name = "three masses to two, transmission at the joint (Fig. 5 to 6)";
        r.model = "Fig. 6, transmission at the joint";
        r.neglected = {"the compliance between transmission and link, k_{tr-l} against k_{m-tr}"};
        m.transmission = from.motor_transmission;
        m.link_inertia = from.link_inertia + from.transmission_inertia;
        join(r, joint.frictions.transmission, 1, r.joint.frictions.link, true);
    }
    return r;
}

Reduction two_mass_to_single_mass(const Joint& joint)
{
    require(joint.mechanism.model == Model::two_mass, "the reduction to one mass starts from two masses");
    Reduction r;
    r.joint = joint;
    r.joint.mechanism.model = Model::single_mass;
    r.joint.mechanism.inertia = joint.mechanism.link_inertia;
    r.joint.friction = joint.frictions.link;
    r.motor = Reduction::Motor::ideal;
    auto& c = r.joint.control;
    if (c.kind == ControlKind::position) {
        r.name = "ideal motor as a position source (Fig. 6 to 7a)";
        r.model = "Fig. 7a, ideal motor";
        r.neglected = {"the motor's inertia and friction",
                       "the compliance of the motor's own loop, k_{p} against k_{tr}"};
        if (joint.mechanism.transmission.cubic_stiffness > 0)
            r.neglected.emplace_back("the hardening of the transmission: k_{tr} is that of small deflections");
        // the transmission is the loop now, which neither ticks nor comes late
        Control spring;
        spring.k_p = joint.mechanism.transmission.stiffness;
        spring.k_v = joint.mechanism.transmission.damping;
        spring.V0 = c.V0;
        spring.contact_stiffness = c.contact_stiffness;
        c = spring;
        r.joint.actuator = {};
        r.joint.sensor = {};
    } else {
        r.name = "ideal motor as a force source (Fig. 6 to 7b)";
        r.model = "Fig. 7b, ideal motor";
        r.neglected = {"the motor's inertia and friction", "the compliance of the transmission, k_{c} against k_{tr}"};
    }
    return r;
}

Reduction rigid_transmission(const Joint& joint)
{
    require(joint.mechanism.model == Model::two_mass, "the reduction to one mass starts from two masses");
    Reduction r;
    r.joint = joint;
    r.name = "rigid transmission (Fig. 6 to one mass)";
    r.model = "one mass, all rigid";
    r.neglected = {"the compliance of the transmission, k_{tr} against k_{p}"};
    r.motor = Reduction::Motor::joins_link;
    const double N = joint.mechanism.transmission.ratio;
    r.joint.mechanism.model = Model::single_mass;
    r.joint.mechanism.inertia = joint.mechanism.link_inertia + N * N * joint.mechanism.motor_inertia;
    r.joint.friction = joint.frictions.link;
    join(r, joint.frictions.motor, N, r.joint.friction, true);
    return r;
}

Reduction in_sequence(Reduction first, const std::function<Reduction(const Joint&)>& second)
{
    Reduction r = second(first.joint);
    for (auto& j : first.joined) {
        if (!j.on_link && r.motor == Reduction::Motor::ideal) continue;
        if (!j.on_link && r.motor == Reduction::Motor::joins_link) {
            j.turns *= first.joint.mechanism.transmission.ratio;
            j.on_link = true;
        }
        r.joined.push_back(std::move(j));
    }
    require_room(r);
    r.name = first.name + ", then " + r.name;
    if (first.model != three_masses) r.model = first.model + ", then " + r.model;
    r.neglected.insert(r.neglected.begin(), first.neglected.begin(), first.neglected.end());
    return r;
}

}  // namespace stickslip
