// Which forms of a cause a ladder tries, without a number that stands at its bound and only what records can show, and
// which numbers may stand there.
#include "analysis/diagnosis/fit/joint_edits.h"
#include "analysis/diagnosis/ladder/climber.h"
#include "analysis/diagnosis/ladder/plausible.h"
#include "analysis/diagnosis/policy/ladder.h"
#include "tests/analysis/diagnosis/answers.h"
#include "tests/analysis/diagnosis/ladder_search.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using namespace stickslip::gap;
using stickslip::test::Machine;

TEST_CASE("a spring that would harden at efforts that it never carries is a linear one", "[gap][ladder][slow]")
{
    LadderRecords records(Machine{}, {"viscous"});
    Joint joint = test::nominal_joint();
    constexpr double motor_share = 0.4, stiffness = 2e4, damping_ratio = 0.1, link_friction = 0.3;
    divide_mass(joint, motor_share, stiffness, damping_ratio, link_friction);
    records.simulate(joint, {"compliance:divided-mass-hardening"});
    const Corrections corrections(records.cases, records.scales, policy::ladder.prior);
    const HeldOutData data(records.cases);
    SetFitter fitter(data, records.scales, corrections, policy::ladder.ranges);
    fitter.renew();
    Climber climber(records.singles, fitter, policy::ladder, test::in_order);
    // a range so narrow that noise cannot keep the number off its end
    Effect narrow = *effect_named("compliance");
    const auto form = std::ranges::find(narrow.forms, "divided-mass-hardening", &EffectForm::name);
    EffectParameter& at = form->parameters.back();
    REQUIRE(at.name == "hardening_effort");
    at.high = 1;
    const Candidate hardening{{&narrow}, {&*form}, records.cases.size()};
    Start start;
    start.causes = hardening;
    const double scaled = stiffness / unit_of(Scale::stiffness, records.scales);
    start.x0 =
        fitter.start(hardening, {}, to_fit(hardening, {motor_share, scaled, link_friction, damping_ratio, at.high}));
    const auto sets = climber.judged({start});
    REQUIRE(sets.size() == 2);
    for (const auto& set : sets) {
        const bool linear = set.causes.forms[0]->name == "divided-mass";
        CHECK(set.plausible == linear);
        if (linear)
            CHECK(in_si(set.causes, set.of_causes(set.fit.x), records.scales)[1] == Approx(stiffness).epsilon(0.02));
    }
    CHECK(sets[0].plausible);
}

TEST_CASE("without a measured effort a back-EMF that is off is viscous friction", "[gap][ladder]")
{
    LadderRecords records(Machine{}, {"viscous"});
    Joint joint = test::nominal_joint();
    joint.actuator.kind = ActuatorKind::dc_motor;
    joint.actuator.k_t = joint.actuator.k_e = 2;
    joint.actuator.resistance = 3;
    for (auto& c : records.cases) c.joint.actuator = joint.actuator;
    joint.actuator.k_e *= 2;
    records.simulate(joint, {"effort-gain"});
    const Corrections corrections(records.cases, records.scales, policy::ladder.prior);
    const HeldOutData data(records.cases);
    SetFitter fitter(data, records.scales, corrections, policy::ladder.ranges);
    fitter.renew();
    Climber climber(records.singles, fitter, policy::ladder, test::in_order);
    REQUIRE_FALSE(fitter.logs_effort());
    const auto looks = climber.looks(fitter.fit({}, fitter.start({}, {}, {})));
    REQUIRE(looks.size() == 1);
    CHECK(looks[0].form->name != "back-emf");
}

TEST_CASE("a part of a whole may be all of it, a number of the search not", "[gap][ladder]")
{
    const auto number = [](const char* effect, std::string_view form, std::string_view name) {
        const auto& forms = effect_named(effect)->forms;
        const auto& numbers = std::ranges::find(forms, form, &EffectForm::name)->parameters;
        return *std::ranges::find(numbers, name, &EffectParameter::name);
    };
    CHECK_FALSE(at_bound(number("load-dependent-friction", "gear", "beyond"), 1));
    CHECK_FALSE(at_bound(number("compliance", "divided-mass", "link_friction"), 1));
    CHECK_FALSE(at_bound(number("compliance", "divided-mass", "link_friction"), 0));
    CHECK(at_bound(number("compliance", "divided-mass", "motor_share"), 0.98));
    const auto damping = number("backlash", "divided-mass", "damping_ratio");
    CHECK_FALSE(at_bound(damping, damping.high));
    CHECK(at_bound(damping, damping.low));
}

TEST_CASE("a force that comes and goes once in a record is no periodic one, even where it explains all", "[gap][slow]")
{
    Machine m;
    m.swing = 1.2, m.swing_period = 4.5;  // of 6 s
    const std::vector<Record> records{test::record_of(m, 1), test::record_of(m, 2)};
    DiagnosisOptions options;
    options.ensemble = 2;
    const auto d = test::answer(test::nominal_joint(), records, test::in_order, options).diagnosis;
    REQUIRE_FALSE(d.verdict == Verdict::no_gap);
    const bool named = d.verdict == Verdict::gap && std::ranges::count(d.effects.at(0).names, "periodic-disturbance");
    CHECK_FALSE(named);
}
