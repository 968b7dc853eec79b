#include "analysis/diagnosis/ladder/ladder.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/ladder/climber.h"
#include "analysis/diagnosis/ladder/flexible.h"
#include "analysis/diagnosis/ladder/plausible.h"
#include "analysis/diagnosis/policy/ladder.h"
#include "tests/analysis/diagnosis/small_machine.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace stickslip;
using namespace stickslip::gap;
using stickslip::test::Machine;

namespace {

/// A ladder climbed on two records of a machine whose document says something else.
struct Climbed {
    std::vector<Case> cases;
    Scales scales;
    std::vector<Attribution> singles;
    std::unique_ptr<LadderSearch> search;
    Ladder ladder;

    explicit Climbed(const Machine& m, const Joint& document = test::nominal_joint(),
                     const std::vector<const char*>& names = {"viscous", "stribeck", "asymmetric-friction",
                                                              "load-dependent-friction", "gravity", "friction-drift"})
        : Climbed(m, document, effects_named(names))
    {
    }
    Climbed(const Machine& m, const Joint& document, const std::vector<const Effect*>& effects)
    {
        std::vector<Note> notes;
        for (unsigned seed : {1u, 2u}) {
            cases.push_back(prepare(test::record_of(m, seed, 5), document, notes));
            cases.back().number = cases.size() - 1;
        }
        scales = scales_of(cases);
        const Nominal nominal = judge_nominal(cases);
        const Fit fit{cases, scales, nominal, test::in_order};
        for (const Effect* e : effects) {
            Attribution a;
            a.candidate = {{e}, {&e->forms[0]}, cases.size()};
            a.x.fill(to_fit(a.candidate, e->forms[0].seeds[0]));
            // where a wave lies is found before a ladder is climbed
            const bool wave = std::ranges::any_of(
                e->forms[0].parameters, [](const EffectParameter& p) { return p.grid != FrequencyGrid::none; });
            if (wave) a = fit_singles(fit, {a.candidate}).at(0);
            singles.push_back(a);
        }
        search = std::make_unique<LadderSearch>(fit, singles, policy::ladder);
        ladder = search->climb({}, policy::ladder.most_rungs);
    }
    static std::vector<const Effect*> effects_named(const std::vector<const char*>& names)
    {
        std::vector<const Effect*> effects;
        for (const char* name : names) effects.push_back(effect_named(name));
        return effects;
    }
    /// The refitted number of that name, SI; a factor for an inertia.
    double corrected(std::string_view name) const
    {
        const FittedSet& set = ladder.last();
        const auto si = in_si(set.model.candidate, set.fit.x, scales);
        std::size_t at = 0;
        for (std::size_t i = 0; i < set.model.corrections; ++i) {
            if (set.model.candidate.effects[i]->name == name) return si[at];
            at += set.model.candidate.count_of(*set.model.candidate.forms[i]);
        }
        return not_set;
    }
};

double share(const std::vector<Window>& left, const std::vector<Window>& of)
{
    return beyond_noise(left) / beyond_noise(of);
}

}  // namespace

TEST_CASE("numbers of the document that are a few per cent off are corrected to the true ones, and are no cause",
          "[gap][ladder][slow]")
{
    Machine m;
    m.inertia = 1.2 * 1.05, m.coulomb = 2 * 0.95, m.viscous = 1.5 * 1.1;
    const Climbed c(m);
    CHECK(c.ladder.rungs.empty());
    CHECK(share(c.ladder.corrected.all_left(), c.ladder.documented) < 0.05);
    CHECK(c.corrected("inertia") == Approx(1.05).margin(0.01));
    CHECK(c.corrected("coulomb-level") == Approx(-0.1).margin(0.03));
    CHECK(c.corrected("viscous") == Approx(0.15).margin(0.06));
}

TEST_CASE("a documented gravity that is a few per cent off is corrected, one that is far off is a cause",
          "[gap][ladder][slow]")
{
    Joint document = test::nominal_joint();
    document.load.gravity_amplitude = 10;
    Machine m;
    m.gravity = 10 * 1.08;
    const Climbed off(m, document);
    CHECK(off.ladder.rungs.empty());
    CHECK(off.corrected("gravity") == Approx(0.8).margin(0.1));
    m.gravity = 10 * 1.4;
    const Climbed far(m, document);
    REQUIRE(far.ladder.rungs.size() >= 1);
    CHECK(far.ladder.rungs[0].causes.effects[0]->name == "gravity");
}

TEST_CASE("a gravity of nearly the documented size at another angle is a cause, and no constant load",
          "[gap][ladder][slow]")
{
    Joint document = test::nominal_arm();
    document.load.gravity_amplitude = 10;
    Machine m;
    m.inertia = 1.2 * 0.97, m.gravity = 10 * 0.95, m.gravity_angle = 0.1;
    m.amplitude = 4;  // the cosine changes by some per cent over the travel
    const Climbed c(m, document, {"viscous", "constant-load", "gravity", "asymmetric-friction"});
    REQUIRE(c.ladder.rungs.size() == 1);
    CHECK(c.ladder.rungs[0].causes.effects[0]->name == "gravity");
}

TEST_CASE("an encoder that is off makes the motion of gravity at another angle, however far off its amplitude is",
          "[gap][ladder][slow]")
{
    Joint document = test::nominal_arm();
    document.load.gravity_amplitude = 10;
    Machine m;
    m.gravity = 10 * 0.95, m.gravity_angle = 0.1;
    m.amplitude = 4;
    const Climbed c(m, document, {"viscous", "constant-load", "gravity", "sensor-offset"});
    REQUIRE(c.ladder.rungs.size() == 1);
    const auto& named = c.ladder.rungs[0];
    const auto& rivals = c.ladder.rivals[0];
    const auto is_other = [&](const FittedSet& set) {
        const auto name = set.causes.effects[0]->name;
        return name != named.causes.effects[0]->name && (name == "gravity" || name == "sensor-offset");
    };
    const auto other = std::ranges::find_if(rivals, is_other);
    REQUIRE(other != rivals.end());
    // noise, as the one named leaves; its numbers may cost more
    CHECK(other->misfit < named.misfit + policy::out_of_question * margin_of(named, policy::ladder));
}

TEST_CASE("a number that is far off against its prior is a cause", "[gap][ladder][slow]")
{
    Machine m;
    m.viscous = 3;  // documented: 1.5
    const Climbed c(m);
    REQUIRE(c.ladder.rungs.size() >= 1);
    CHECK(c.ladder.rungs[0].causes.effects[0]->name == "viscous");
}

TEST_CASE(
    "a cause is named by what it takes on unseen rows although numbers are off and a drag of no catalogue remains",
    "[gap][ladder][slow]")
{
    Machine m;
    m.inertia = 1.2 * 1.04, m.coulomb = 2 * 1.05;
    m.drag = 1;
    m.one_way = 1.2;
    const Climbed c(m);
    REQUIRE(c.ladder.rungs.size() >= 1);
    CHECK(c.ladder.rungs[0].causes.effects[0]->name == "asymmetric-friction");
    CHECK(share(c.ladder.rungs[0].all_left(), c.ladder.documented) < 0.3);
    for (const auto& rival : c.ladder.rivals[0])
        CHECK(rival.misfit > c.ladder.rungs[0].misfit + margin_of(c.ladder.rungs[0], policy::ladder));
}

TEST_CASE("a joint at rest is no evidence, however exactly it is predicted", "[gap][ladder]")
{
    // moving: a tenth of the square is taken; at rest: a residual of 1e-4 or of 1e-8 of the noise floor
    const std::vector<Window> one{{0, 0, 100, 10}, {0, 100, 200, 1e-8}}, other{{0, 0, 100, 9}, {0, 100, 200, 1e-16}};
    CHECK(mean_log(one) - mean_log(other) == Approx(std::log(10.0 / 9) / 2));
    // a noise that is documented somewhat too high still tells rivals apart
    CHECK(mean_log({{0, 0, 100, 0.4}}) - mean_log({{0, 0, 100, 0.3}}) == Approx(std::log(4.0 / 3)));
}

TEST_CASE("what has implausible numbers is no rival of a rung", "[gap][ladder]")
{
    const auto of = [](std::initializer_list<const char*> names) {
        FittedSet set;
        for (const char* name : names) set.causes.effects.push_back(effect_named(name));
        return set;
    };
    const FittedSet rung = of({"load-dependent-friction"});
    FittedSet rival = of({"frictional-memory"});
    CHECK(may_stand_for(rival, rung, {}));
    CHECK_FALSE(may_stand_for(rung, rung, {}));
    CHECK_FALSE(may_stand_for(of({"frictional-memory", "gravity"}), rung, {}));
    CHECK_FALSE(may_stand_for(rival, rung, of({"gravity"}).causes));
    rival.plausible = false;  // a slip length below the step of the encoder, say
    CHECK_FALSE(may_stand_for(rival, rung, {}));
    rival.plausible = true, rival.correction = true;
    CHECK_FALSE(may_stand_for(rival, rung, {}));
}

TEST_CASE("a form with its number at a bound gives way to another form of the same effect", "[gap][ladder]")
{
    Effect friction = *effect_named("viscous");
    EffectForm capped = friction.forms[0];
    capped.name = "capped", capped.parameters[0].high = 0.02;  // what is missing is far beyond
    friction.forms.insert(friction.forms.begin(), capped);
    Machine m;
    m.viscous = 3;  // documented: 1.5
    const Climbed c(m, test::nominal_joint(), {&friction, effect_named("stribeck")});
    REQUIRE(c.ladder.rungs.size() == 1);
    REQUIRE(c.ladder.rungs[0].causes.effects[0] == &friction);
    CHECK(c.ladder.rungs[0].causes.forms[0] == &friction.forms[1]);
}

TEST_CASE("the place of a cause that is also a number of the document is by what it takes, not by what is left to it",
          "[gap][ladder][slow]")
{
    Machine m;
    m.inertia = 1.2 * 1.2;  // takes more than the ripple does; a document is 12 % off at most
    m.ripple = 0.25;
    const Climbed c(m, test::nominal_joint(), {"inertia", "position-dependent-friction", "viscous"});
    REQUIRE(c.ladder.rungs.size() == 2);
    CHECK(c.ladder.rungs[0].causes.effects[0]->name == "inertia");
    // what leaves the inertia to its correction comes no nearer without that
    for (const auto& rival : c.ladder.rivals[0]) CHECK(rival.misfit > c.ladder.rungs[0].misfit);
}

TEST_CASE("a bend over the travel is no wave of friction: it stays in the remainder and out of the cause's numbers",
          "[gap][ladder][slow]")
{
    Machine m;
    m.viscous = 3;  // documented: 1.5
    m.drag = 3;     // of no catalogue, and largest in the middle of the travel
    m.cubic = 400;
    const Climbed c(m);
    REQUIRE(c.ladder.rungs.size() >= 1);
    CHECK(c.ladder.rungs[0].causes.effects[0]->name == "viscous");
    const FittedSet& set = c.ladder.last();
    const auto si = in_si(set.model.candidate, set.fit.x, c.scales);
    for (std::size_t i = 0; i < set.model.numbers; ++i)
        if (set.model.candidate.parameter(i).name == "periods") {
            INFO(si[i]);
            CHECK(si[i] * c.scales.position > 2 * std::numbers::pi * 0.999);
        }
}

TEST_CASE("the small terms that every machine has are corrections beside a cause, which then leaves next to nothing",
          "[gap][ladder][slow]")
{
    Machine m;
    m.viscous = 3;  // documented: 1.5
    m.inertia = 1.2 * 1.03;
    m.ripple = 0.06, m.cogging = 0.08;  // 3 and 4 % of the Coulomb level
    const Climbed c(m);
    REQUIRE(c.ladder.rungs.size() == 1);
    CHECK(c.ladder.rungs[0].causes.effects[0]->name == "viscous");
    CHECK(share(c.ladder.last().all_left(), c.ladder.documented) < 0.01);
    const FittedSet& set = c.ladder.last();
    const auto si = in_si(set.model.candidate, set.fit.x, c.scales);
    const auto term = [&](std::string_view name) {
        std::array<double, 3> numbers{};
        std::size_t at = 0;
        for (std::size_t i = 0; i < set.model.corrections; ++i) {
            const auto count = set.model.candidate.count_of(*set.model.candidate.forms[i]);
            if (set.model.candidate.effects[i]->name == name)
                std::copy_n(si.begin() + static_cast<std::ptrdiff_t>(at), 3, numbers.begin());
            at += count;
        }
        return numbers;
    };
    const auto ripple = term("position-dependent-friction"), cogging = term("cogging");
    CHECK(std::hypot(cogging[0], cogging[1]) == Approx(m.cogging).margin(0.01));
    CHECK(cogging[2] == Approx(m.waves).epsilon(0.01));
    CHECK(std::hypot(ripple[0], ripple[1]) == Approx(m.ripple).margin(0.01));
    CHECK(ripple[2] == Approx(1.3 * m.waves).epsilon(0.01));
}

TEST_CASE("a cogging of another shape than a sine keeps its name, with its second harmonic", "[gap][ladder][slow]")
{
    const auto climbed = [](double second) {
        Machine m;
        m.inertia = 1.2 * 1.03, m.coulomb = 2 * 0.97;
        m.cogging = 0.8, m.second = second;
        return Climbed(m, test::nominal_joint(), {"cogging", "position-dependent-friction", "gravity", "viscous"});
    };
    const Climbed bent = climbed(0.5);
    REQUIRE(bent.ladder.rungs.size() == 1);
    const FittedSet& set = bent.ladder.last();
    REQUIRE(set.causes.effects == std::vector<const Effect*>{effect_named("cogging")});
    CHECK(set.causes.forms[0]->name == "two-harmonics");
    CHECK(share(set.all_left(), bent.ladder.documented) < 0.01);
    const auto si = in_si(set.causes, set.of_causes(set.fit.x), bent.scales);
    CHECK(std::hypot(si[0], si[1]) == Approx(0.8).margin(0.02));
    CHECK(si[2] == Approx(200).epsilon(0.005));
    CHECK(std::hypot(si[3], si[4]) == Approx(0.4).margin(0.02));
    CHECK(std::atan2(si[4], si[3]) == Approx(1).margin(0.1));

    const Climbed pure = climbed(0);
    REQUIRE(pure.ladder.rungs.size() == 1);
    CHECK(pure.ladder.last().causes.forms[0] == &effect_named("cogging")->forms[0]);
}

TEST_CASE("a cogging of little more than one period in the travel is found, with numbers that its own floor allows",
          "[gap][ladder][slow]")
{
    Machine m;
    m.inertia = 1.2 * 0.91, m.gravity = 10 * 0.92;
    m.cogging = 2.4, m.second = 0.45, m.waves = 45;  // travel: 0.17 to 0.19 m
    Joint joint = test::nominal_joint();
    joint.load.gravity_amplitude = 10;
    const Climbed c(m, joint, {"cogging", "gravity", "viscous"});
    REQUIRE(c.ladder.rungs.size() == 1);
    const FittedSet& set = c.ladder.last();
    REQUIRE(set.causes.effects == std::vector<const Effect*>{effect_named("cogging")});
    const auto si = in_si(set.causes, set.of_causes(set.fit.x), c.scales);
    CHECK(si[2] == Approx(m.waves).epsilon(0.01));
    CHECK(std::hypot(si[0], si[1]) == Approx(m.cogging).epsilon(0.02));
    CHECK(share(set.all_left(), c.ladder.documented) < 0.01);
}

TEST_CASE("what remains is told by the signal that it depends on", "[gap][ladder][slow]")
{
    Machine m;
    m.cubic = 4000;  // a spring of no catalogue
    const Climbed c(m);
    const auto& base = c.ladder.corrected;
    const auto flexible = regress(c.search->data(), c.scales, base.model.candidate, base.x, base.fit.x);
    REQUIRE(flexible.before > 0);
    CHECK(flexible.after < 0.2 * flexible.before);
    CHECK(flexible.alone[0].first == "position");
    CHECK(flexible.share_of("position") > 0.8);
    CHECK(flexible.share_of("time") < 0.5);
}

TEST_CASE("numbers outside their physical range are no cause", "[gap][ladder]")
{
    const Effect* e = effect_named("periodic-disturbance");
    const Candidate slow{{e}, {&e->forms[0]}, 1};
    Scales scales;
    scales.duration = 6;
    scales.effort = 2;
    const Joint joint = test::nominal_joint();
    CHECK_FALSE(plausible(slow, to_fit(slow, {0.1, 0.1, 0.5}), scales, joint, policy::ladder.ranges));
    CHECK(plausible(slow, to_fit(slow, {0.1, 0.1, 20}), scales, joint, policy::ladder.ranges));
    const Effect* memory = effect_named("frictional-memory");
    const Candidate lag{{memory}, {&memory->forms[0]}, 1};
    CHECK_FALSE(plausible(lag, to_fit(lag, {0.02, 0.04, 0.5, 0.1}), scales, joint, policy::ladder.ranges));
    // a direct effect of half the level of 2 N, or a slip length below the encoder's step of 5 µm, is no memory
    CHECK(plausible(lag, to_fit(lag, {0.1, 0.12, 0.01, 0.1}), scales, joint, policy::ladder.ranges));
    CHECK_FALSE(plausible(lag, to_fit(lag, {0.49, 0.1, 0.01, 0.1}), scales, joint, policy::ladder.ranges));
    CHECK_FALSE(plausible(lag, to_fit(lag, {0.1, 0.49, 0.01, 0.1}), scales, joint, policy::ladder.ranges));
    CHECK_FALSE(plausible(lag, to_fit(lag, {0.1, 0.12, 4e-6, 0.1}), scales, joint, policy::ladder.ranges));
    // backlash that the encoder does not resolve is a spring
    const Effect* backlash = effect_named("backlash");
    const Candidate contact{{backlash}, {&backlash->forms[0]}, 1};
    CHECK(plausible(contact, to_fit(contact, {2e-5, 0.5, 1000, 0.3, 0.2}), scales, joint, policy::ladder.ranges));
    CHECK_FALSE(plausible(contact, to_fit(contact, {4e-6, 0.5, 1000, 0.3, 0.2}), scales, joint, policy::ladder.ranges));
    // LuGre's bristles without damping are Dahl's; without stiffness they are none
    const Effect* bristles = effect_named("presliding");
    const Candidate lugre{{bristles}, {&bristles->forms[1]}, 1};
    CHECK(plausible(lugre, to_fit(lugre, {30, 0.001}), scales, joint, policy::ladder.ranges));
    CHECK_FALSE(plausible(lugre, to_fit(lugre, {1, 0.1}), scales, joint, policy::ladder.ranges));
    CHECK_FALSE(plausible(lugre, to_fit(lugre, {30, 1000}), scales, joint, policy::ladder.ranges));
}

TEST_CASE("of causes that are out of sight of the best no folds are fitted", "[gap][ladder]")
{
    Machine m;
    m.viscous = 9;
    const Climbed c(m, test::nominal_joint(), {"viscous", "coulomb-level", "gravity"});
    REQUIRE(c.ladder.rungs.size() == 1);
    const FittedSet& viscous = c.ladder.rungs[0];
    REQUIRE(viscous.causes.effects[0]->name == "viscous");
    for (const auto& x : viscous.x) CHECK(x != viscous.fit.x);
    REQUIRE_FALSE(c.ladder.rivals[0].empty());
    for (const auto& rival : c.ladder.rivals[0]) {
        CAPTURE(rival.causes.effects[0]->name);
        REQUIRE(rival.misfit > viscous.misfit + policy::out_of_sight * margin_of(viscous, policy::ladder));
        for (const auto& x : rival.x) CHECK(x == rival.fit.x);
    }
}
