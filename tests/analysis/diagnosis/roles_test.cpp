// What the fields of an effect say it does, against what its edit does to a joint.
#include "analysis/diagnosis/fit/effect.h"
#include "analysis/diagnosis/fit/joint_edits.h"
#include "analysis/joint/parameters.h"
#include "tests/analysis/diagnosis/small_machine.h"

#include <catch2/catch.hpp>
#include <map>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

/// A geared joint of two masses, or one mass, with a number in everything that an edit may multiply.
Joint full_joint(bool two_masses)
{
    Joint j = test::nominal_joint();
    Stribeck law;
    law.c0 = 2, law.c1 = 1.5, law.c2 = 0.5, law.c3 = 0.01, law.c4 = 2;
    j.friction.law = j.frictions.motor.law = j.frictions.link.law = law;
    if (two_masses) {
        j.mechanism.model = Model::two_mass;
        j.mechanism.motor_inertia = 0.4, j.mechanism.link_inertia = 0.8;
        j.mechanism.transmission.stiffness = 1e4, j.mechanism.transmission.damping = 3;
    }
    j.actuator.kind = ActuatorKind::dc_motor;
    j.actuator.k_t = 0.5, j.actuator.k_e = 0.5, j.actuator.resistance = 2;
    j.control.k_i = 10;
    j.control.dead_zone = 1e-4;
    j.control.feed_forward.coulomb = 0.5, j.control.feed_forward.acceleration = 0.2;
    return j;
}

std::map<std::string, double> numbers_of(Joint j)
{
    std::map<std::string, double> all;
    for (const auto& p : parameters(j)) all[p.path] = is_set(*p.value) ? *p.value : -1e300;
    return all;
}

template <class Check>
void for_every_form(Check check)
{
    for (const bool two_masses : {false, true}) {
        const Joint before = full_joint(two_masses);
        for (const auto& effect : effects())
            for (const auto& form : effect.forms)
                if (form.apply && (!form.applies || form.applies(before))) {
                    CAPTURE(effect.name, form.name, two_masses);
                    check(before, effect, form);
                }
    }
}

Joint with(Joint joint, const EffectForm& form, const std::vector<double>& values)
{
    form.apply(joint, values.data());
    return joint;
}

}  // namespace

TEST_CASE("a factor on a documented number changes nothing at 1, and no other parameter does so", "[gap]")
{
    int factors = 0;
    for_every_form([&](const Joint& before, const Effect&, const EffectForm& form) {
        for (std::size_t i = 0; i < form.parameters.size(); ++i) {
            if (form.parameters.size() != 1) continue;
            const bool unchanged = numbers_of(with(before, form, {1})) == numbers_of(before);
            CHECK(unchanged == form.parameters[i].factor);
            factors += unchanged;
        }
    });
    CHECK(factors > 10);
}

TEST_CASE("the forms said to move the encoder put it on the link", "[gap]")
{
    for_every_form([](const Joint& before, const Effect&, const EffectForm& form) {
        const Joint after = with(before, form, form.seeds.front());
        CHECK((after.control.feedback == Feedback::link) == form.encoder_on_link);
    });
}

TEST_CASE("effects of the transmission divide the mass or change what lies between two, and no others do", "[gap]")
{
    for_every_form([](const Joint& before, const Effect& effect, const EffectForm& form) {
        const Joint after = with(before, form, form.seeds.back());
        const auto &was = before.mechanism, &is = after.mechanism;
        const auto differ = [](double a, double b) { return is_set(a) != is_set(b) || (is_set(a) && a != b); };
        const bool changed = is.model != was.model || differ(is.transmission.stiffness, was.transmission.stiffness) ||
                             differ(is.transmission.damping, was.transmission.damping) ||
                             differ(is.transmission.backlash, was.transmission.backlash);
        CHECK(changed == effect.of_transmission);
    });
}

TEST_CASE("effects that a logged command shows change nothing but the controller", "[gap]")
{
    for_every_form([](const Joint& before, const Effect& effect, const EffectForm& form) {
        if (!effect.in_command) return;
        const auto was = numbers_of(before);
        for (const auto& [path, value] : numbers_of(with(before, form, form.seeds.front())))
            if (value != was.at(path)) CHECK(path.starts_with("control."));
    });
}

TEST_CASE("forms of a number of their own leave alone what the effect's first form changes", "[gap]")
{
    const Joint before = full_joint(true);
    const auto changed_by = [&](const EffectForm& form) {
        std::vector<std::string> paths;
        const auto was = numbers_of(before);
        for (const auto& [path, value] : numbers_of(with(before, form, form.seeds.front())))
            if (value != was.at(path)) paths.push_back(path);
        return paths;
    };
    int own = 0;
    for (const auto& effect : effects())
        for (const auto& form : effect.forms) {
            if (!form.own_number || (form.applies && !form.applies(before))) continue;
            CAPTURE(effect.name, form.name);
            CHECK(changed_by(form) != changed_by(effect.forms[0]));
            ++own;
        }
    CHECK(own >= 4);
}

TEST_CASE("a divided mass shares out level and slope of its friction, the rest stays with the drive", "[gap]")
{
    Joint j = test::nominal_joint();
    Stribeck law;
    law.c0 = 2, law.c1 = 1.5, law.c2 = 0.5, law.c3 = 0.01, law.c4 = 2;
    j.friction.law = law;
    j.friction.asymmetry = {0.3, 0.2};
    j.friction.ripple.amplitude = 0.1;
    const double inertia = j.mechanism.inertia;
    divide_mass(j, 0.25, 1e4, 0.1, 0.4);
    CHECK(j.mechanism.motor_inertia == Approx(0.25 * inertia));
    CHECK(j.mechanism.motor_inertia + j.mechanism.link_inertia == Approx(inertia));
    const auto motor = std::get<Stribeck>(j.frictions.motor.law);
    const auto link = std::get<CoulombViscous>(j.frictions.link.law);
    CHECK(link.coulomb == Approx(0.4 * 2));
    CHECK(link.viscous == Approx(0.4 * 1.5));
    CHECK(motor.c0 + link.coulomb == Approx(2));
    CHECK(motor.c1 + link.viscous == Approx(1.5));
    CHECK(motor.c2 == 0.5);
    // a level that differs by direction would press a link of its own against one flank of its backlash
    CHECK(j.frictions.motor.asymmetry.coulomb == 0.3);
    CHECK(j.frictions.motor.asymmetry.viscous == 0.2);
    CHECK(j.frictions.motor.ripple.amplitude == 0.1);
    CHECK(j.frictions.link.asymmetry.coulomb == 0);
    CHECK(j.frictions.link.ripple.amplitude == 0);
}
