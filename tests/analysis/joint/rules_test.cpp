// Rules between keys, asked of every point: they agree with what refuses a file.
#include "analysis/joint/rules.h"
#include "analysis/joint/parameters.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>

using namespace stickslip;

namespace {

/// m_jj = 1 kg beside a neighbour of 0.5 kg: the mass matrix is positive definite below a coupling of √0.5 kg.
Joint coupled(double coupling)
{
    Joint joint = example_joint(6e4, 10, 1e-3);
    Neighbour n;
    n.inertia = 0.5, n.coupling = coupling, n.k_p = 1e4, n.k_v = 100;
    joint.neighbour.push_back(n);
    return joint;
}

Joint bristles(double breakaway)
{
    Joint joint = example_joint(6e4, 300, 1e-3);
    LuGre law;
    law.sigma0 = 1e5, law.sigma1 = 316, law.sigma2 = 0.4;
    law.coulomb = 1, law.breakaway = breakaway, law.stribeck_velocity = 1e-3;
    joint.friction.law = law;
    return joint;
}

Joint late(double ticks)
{
    Joint joint = ticked_joint(6e4, ticks * 1e-3);
    return joint;
}

/// A term below a table of the friction, which a law with a state of its own does not carry.
Joint bristle_on_memory()
{
    Joint joint = example_joint(6e4, 10, 1e-3);
    joint.friction.bristle.stiffness = 1e6;
    return joint;
}

}  // namespace

TEST_CASE("A joint obeys its rules where its file would be accepted", "[joint]")
{
    const std::pair<Joint, bool> cases[] = {{coupled(0.7071), true},     {coupled(0.7072), false}, {bristles(1), true},
                                            {bristles(0.99), false},     {late(1000), true},       {late(1001), false},
                                            {bristle_on_memory(), false}};
    for (const auto& [joint, possible] : cases) {
        CHECK(obeys_rules(joint) == possible);
        CHECK(check(joint).empty() == possible);
    }
}

TEST_CASE("A joint that breaks a rule has no verdict", "[joint]")
{
    CHECK(linear_point(coupled(0.5)).reason == Reason::none);
    const auto beyond = linear_point(coupled(1));
    CHECK(beyond.reason == Reason::impossible);
    CHECK(beyond.region == Region::undecided);
    CHECK(linear_verdict(bristles(0.5)).steady.reason == Reason::impossible);
}
