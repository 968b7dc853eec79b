// Bad parameters of each law: check() says where and what, in words.
#include <algorithm>
#include <catch2/catch.hpp>

#include "analysis/joint/parameters.h"
#include "tests/analysis/friction/sample_laws.h"

using namespace stickslip;

namespace {

Joint joint_with(FrictionLaw law)
{
    Joint joint;
    joint.mechanism.inertia = 1;
    joint.control.k_p = 1000;
    joint.control.V0 = 1e-3;
    joint.friction.law = std::move(law);
    return joint;
}

/// Everything that check() says, one line each.
std::string complaints(const Joint& joint)
{
    std::string text;
    for (const auto& p : check(joint)) text += p.path + ": " + p.message + "\n";
    return text;
}

template <class Law>
void expect(Law law, const std::string& complaint)
{
    const auto text = complaints(joint_with(law));
    CAPTURE(complaint, text);
    CHECK(text.find(complaint) != std::string::npos);
}

}  // namespace

TEST_CASE("sound samples of every law pass the check", "[friction]")
{
    for (const auto& [name, law] : samples::laws()) {
        CAPTURE(name);
        CHECK(complaints(joint_with(law)) == "");
    }
}

TEST_CASE("every law complains about each number that is missing", "[friction]")
{
    for (const auto& known : laws()) {
        auto joint = joint_with(*law_named(known.name));
        if (known.name == "maxwell-slip") continue;  // needs no number but elements, see below
        CAPTURE(known.name);
        CHECK(complaints(joint).find("is missing") != std::string::npos);
    }
}

TEST_CASE("what each law refuses", "[friction]")
{
    expect(CoulombViscous{-1, 0}, "friction.coulomb: is -1, expected ≥ 0");
    expect(KineticStatic{10, 9}, "friction: static friction is less than kinetic");
    expect(Stribeck{10, 5, 4, 0, 2}, "friction.c3: is 0, expected > 0");
    auto uneven = samples::rate_and_state<RateAndState>({1, 2}, {1e-5});
    expect(uneven, "friction: B and L need one value a state each, got 2 and 1");
    auto no_distance = samples::rate_and_state<Ageing>({1.5}, {0});
    expect(no_distance, "friction.L: is 0, expected > 0");
    auto no_direct = samples::regularised(MemoryForm::slip);
    no_direct.A = 0;
    expect(no_direct, "friction.A: is 0, expected > 0");
    expect(Dahl{10, 1e5, 0.5}, "friction.exponent: is 0.5, expected ≥ 1");
    auto upside_down = samples::lugre();
    upside_down.breakaway = 0.5;
    expect(upside_down, "friction: static friction is less than Coulomb friction");
    expect(MaxwellSlip{}, "friction: elements needs at least one");
    auto lagging_level = samples::maxwell_slip(false);
    lagging_level.static_ratio = 1.2;
    expect(lagging_level, "friction: static_ratio needs a finite attraction");
    auto bad_element = samples::maxwell_slip(false);
    bad_element.elements[1].yield = -2;
    expect(bad_element, "friction.elements.1.yield: is -2, expected > 0");
    expect(samples::time_lag(Stribeck{10, 5, 4, 1e-2, 2}, -1), "friction.lag: is -1, expected > 0");
    expect(samples::time_lag(Stribeck{10, 5, 4, -1, 2}), "friction.curve.c3: is -1, expected > 0");
    auto growing = samples::kernel(false);
    growing.exponentials[0].rate = -100;
    expect(growing, "friction.exponentials.0.rate: is -100, expected > 0");
}

TEST_CASE("a kernel table that is unread or unsound is refused, and its numbers are part of the canonical text",
          "[friction]")
{
    auto law = samples::kernel(true);
    const auto sound = canonical_text(joint_with(law));
    law.samples = nullptr;
    expect(law, "friction: table = \"g.csv\" has not been read");
    const auto with = [&](std::vector<double> time, std::vector<double> value) {
        law.samples = std::make_shared<const KernelTable>(KernelTable{std::move(time), std::move(value)});
        return law;
    };
    expect(with({0, 1}, {1}), "unequal columns");
    expect(with({0}, {1}), "at least two rows");
    expect(with({1, 2}, {1, 1}), "must start at time 0");
    expect(with({0, 2, 1}, {1, 1, 1}), "row 3 does not");
    expect(with({0, 1e-3, 4e-3}, {2e4, not_set, 0}), "row 2 of the table is not finite");
    CHECK(canonical_text(joint_with(with({0, 1e-3, 4e-3}, {2e4, 5e4, 0}))) == sound);
    CHECK(canonical_text(joint_with(with({0, 1e-3, 4e-3}, {2e4, 5.1e4, 0}))) != sound);

    auto joint = joint_with(law);
    const auto slots = tables(joint);
    REQUIRE(slots.size() == 1);
    CHECK(slots[0].path == "friction.table");
    CHECK(*slots[0].name == "g.csv");
    *slots[0].table = std::make_shared<const KernelTable>(KernelTable{{0, 1}, {1, 0}});
    CHECK(complaints(joint) == "");
}

TEST_CASE("the terms on top of a law refuse laws that they do not fit", "[friction]")
{
    auto joint = joint_with(samples::rate_and_state<RateAndState>());
    joint.friction.bristle.stiffness = 1e5;
    CHECK(complaints(joint).find("friction: bristle needs a static law") != std::string::npos);
    joint = joint_with(samples::rate_and_state<RateAndState>({1, 1, 1, 1, 1, 1, 1, 1},
                                                             {1e-5, 1e-5, 1e-5, 1e-5, 1e-5, 1e-5, 1e-5, 1e-5}));
    joint.friction.memory.B = 1;
    CHECK(complaints(joint).find("more than 8 states") != std::string::npos);
}
