// The friction of a record, flattened for speed, against the laws of friction/: the same force and the same change of
// state, law by law and term by term.
#include "analysis/diagnosis/plant/joints.h"
#include "analysis/diagnosis/plant/plant.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

using One = lanes::Pack<1, 1>;

struct Flat {
    FrictionPack<One> pack;

    explicit Flat(const Friction& friction)
    {
        Joint joint;
        joint.mechanism.inertia = 1;
        joint.friction = friction;
        joint.control.k_p = 1;
        const Plant plant = flatten(joint);
        load_frictions(pack, 0, plant.motor);
        pack.has = terms_of(plant.motor);
    }
    /// The friction of a body without bristles at this velocity and state, as `friction_step` puts it together.
    double force(double V, const FrictionState<One>& s) const
    {
        const One direction = std::copysign(1.0, V), speed = std::abs(V);
        const Surroundings<One> nowhere{0.0, 0.0};
        return (direction * (resistance(pack, s, speed, direction, nowhere) + viscous(pack, direction) * speed))[0];
    }
};

Friction with(const FrictionLaw& law)
{
    Friction f;
    f.law = law;
    return f;
}

Stribeck stribeck(double exponent)
{
    Stribeck law;
    law.c0 = 2, law.c1 = 1.5, law.c2 = 0.9, law.c3 = 0.02, law.c4 = exponent;
    return law;
}

CoulombViscous coulomb_viscous()
{
    CoulombViscous law;
    law.coulomb = 2, law.viscous = 1.5;
    return law;
}

constexpr double speeds[] = {1e-4, 3e-3, 0.02, 0.4};

}  // namespace

TEST_CASE("the static friction of a record is that of the laws, law by law", "[gap][friction]")
{
    std::vector<Friction> frictions{with(coulomb_viscous())};
    for (const double exponent : {1.0, 2.0, 0.7}) frictions.push_back(with(stribeck(exponent)));
    frictions.push_back(with(stribeck(2)));
    frictions.back().asymmetry.coulomb = 0.3, frictions.back().asymmetry.viscous = -0.2;
    frictions.back().normal_load = 1.4;
    for (const auto& friction : frictions) {
        const Flat flat(friction);
        for (const double speed : speeds)
            for (const double V : {speed, -speed}) {
                INFO(info(friction.law).name << " at " << V);
                CHECK(flat.force(V, {}) == Approx(respond(friction, V, {}).force).epsilon(1e-12));
            }
    }
}

TEST_CASE("a lag of a record's friction is that of the laws: of the level, and of the whole force", "[gap][friction]")
{
    for (const bool whole : {false, true}) {
        Friction friction = with(stribeck(2));
        friction.memory.lag = 0.05, friction.memory.lag_viscous = whole;
        const Flat flat(friction);
        for (const double speed : speeds)
            for (const double V : {speed, -speed})
                for (const double factor : {0.5, 1.0, 3.0}) {
                    INFO(V << ", state times " << factor << (whole ? ", whole force" : ", level"));
                    States states = steady_state(friction, V);
                    states[0] *= factor;
                    FrictionState<One> s;
                    (whole ? s.force : s.speed) = states[0];
                    const auto law = respond(friction, V, states);
                    CHECK(flat.force(V, s) == Approx(law.force).epsilon(1e-12));
                    constexpr double h = 1e-6;
                    FrictionState<One> next = s;
                    remember(flat.pack, next, One(speed), One(h));
                    const double rate = ((whole ? next.force : next.speed)[0] - states[0]) / h;
                    CHECK(rate == Approx(law.rate[0]).epsilon(1e-4).margin(1e-6));
                }
    }
}

// The record holds |V| above V*/1000 inside its logarithms, so that the joint can stick: A ln(1 + V*/(1000 V)) apart.
TEST_CASE("the memory of a record's friction is that of the laws, slip and ageing", "[gap][friction]")
{
    constexpr double A = 0.08, B = 0.12, L = 1e-4, V_star = 1e-4;
    for (const MemoryForm form : {MemoryForm::slip, MemoryForm::ageing}) {
        Friction friction = with(coulomb_viscous());
        friction.memory.A = A, friction.memory.B = B, friction.memory.L = L, friction.memory.V_star = V_star;
        friction.memory.form = form;
        const Flat flat(friction);
        for (const double V : speeds)
            for (const double away : {-0.1, 0.0, 0.2}) {
                INFO("V = " << V << ", state off by " << away << (form == MemoryForm::slip ? ", slip" : ", ageing"));
                States states = steady_state(friction, V);
                states[0] += away;
                FrictionState<One> s;
                s.theta = states[0];
                const auto law = respond(friction, V, states);
                const double held = std::log1p(1e-3 * V_star / V);
                CHECK(flat.force(V, s) == Approx(law.force).margin(A * held + 1e-9));
                const double h = 1e-6 * L / V;
                const double rate = (remembered(flat.pack, s.theta, One(V), One(h))[0] - states[0]) / h;
                CHECK(rate == Approx(law.rate[0]).epsilon(1e-3).margin(V / L * B * (held + 1e-5)));
            }
    }
}

TEST_CASE("the rate-and-state law of a record is the law itself", "[gap][friction]")
{
    RateAndState law;
    law.f0 = 2, law.A = 0.08, law.V_star = 1e-4;
    law.B.push_back(0.12), law.L.push_back(1e-4);
    const Friction friction = with(law);
    const Flat flat(friction);
    for (const double V : speeds) {
        INFO("V = " << V);
        States states = steady_state(friction, V);
        states[0] += 0.05;
        FrictionState<One> s;
        s.theta = states[0];
        CHECK(flat.force(V, s) ==
              Approx(respond(friction, V, states).force).margin(0.08 * std::log1p(1e-7 / V) + 1e-9));
    }
}

TEST_CASE("the bristles of a record's friction bend as those of the laws", "[gap][friction]")
{
    Friction friction = with(stribeck(2));
    friction.bristle.stiffness = 2e3, friction.bristle.damping = 5;
    const Flat flat(friction);
    constexpr double h = 1e-9;
    for (const double speed : speeds)
        for (const double V : {speed, -speed})
            for (const double share : {-0.5, 0.3, 1.0}) {
                INFO("V = " << V << ", bent by " << share << " of its level");
                States states = steady_state(friction, V);
                states[0] *= share;
                const auto law = respond(friction, V, states);
                FrictionState<One> s;
                s.bristle = states[0];
                // against a force without inertia to move nothing changes the velocity: the bristle alone moves
                friction_step(flat.pack, s, One(V), One(0.0), One(0.0), One(h), Surroundings<One>{0.0, 0.0});
                CHECK((s.bristle[0] - states[0]) / h == Approx(law.rate[0]).epsilon(1e-3).margin(1e-6));
                // the force by which it slows a body down, per mobility
                FrictionState<One> again;
                again.bristle = states[0];
                constexpr double mobility = 1e-9;
                const double next =
                    friction_step(flat.pack, again, One(V), One(0.0), One(mobility), One(h), {0.0, 0.0})[0];
                CHECK((V - next) / mobility == Approx(law.force).epsilon(1e-4).margin(1e-6));
            }
}
