#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/search/search.h"
#include "analysis/diagnosis/verdict/decide.h"
#include "tests/analysis/diagnosis/small_machine.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

Candidate of(std::initializer_list<const char*> names)
{
    Candidate c;
    for (const char* name : names) {
        c.effects.push_back(effect_named(name));
        c.forms.push_back(&c.effects.back()->forms[0]);
    }
    return c;
}

double worst(const Attribution& a)
{
    double most = 0;
    for (const auto& level : a.evaluation) most = std::max(most, level.records[0].position);
    return most;
}

}  // namespace

TEST_CASE("a member that explains everything alone, from where the pair found it, takes the place of its own poor fit",
          "[gap]")
{
    test::Machine m;
    m.coulomb = 2.3;
    std::vector<Note> notes;
    const std::vector<Case> cases{prepare(test::record_of(m, 1), test::nominal_joint(), notes)};
    const Scales scales = scales_of(cases);
    const Nominal nominal = judge_nominal(cases);
    const Fit context{cases, scales, nominal, test::in_order};
    const auto at = [&](const Candidate& c, std::vector<double> scaled) {
        LevelFit fit;
        fit.x = to_fit(c, scaled);
        fit.evaluation = evaluate(cases, c, in_si(c, fit.x, scales), levels[0]);
        return as_screened(context, c, fit);
    };
    // caught far from the truth, beside another cause that looks better
    std::vector<Attribution> singles{at(of({"viscous"}), {0.1}), at(of({"coulomb-level"}), {-0.5})};
    auto pair = at(of({"coulomb-level", "viscous"}), {0.25 / scales.effort, 0.02});
    pair.refined = true;
    REQUIRE_FALSE(singles[0].accepted);
    REQUIRE_FALSE(singles[1].accepted);
    fit_members_alone(context, singles, {pair});
    CHECK(singles[0].candidate.effects[0]->name == "coulomb-level");
    CHECK(singles[0].accepted);
    CHECK(in_si(singles[0].candidate, singles[0].x[1], scales)[0] == Approx(0.3).epsilon(0.05));
    CHECK(singles.size() == 2);
}

TEST_CASE("what the best pair brings to light looks for its own partner", "[gap]")
{
    test::Machine m;
    m.inertia = 1.5;
    m.viscous = 3;
    std::vector<Note> notes;
    const std::vector<Case> cases{prepare(test::record_of(m, 1), test::nominal_joint(), notes)};
    const Scales scales = scales_of(cases);
    const Nominal nominal = judge_nominal(cases);
    const Fit context{cases, scales, nominal, test::in_order};
    std::vector<Attribution> singles;
    for (const char* name : {"coulomb-level", "inertia", "viscous"}) {
        const Candidate c = of({name});
        LevelFit fit;
        fit.x = to_fit(c, {0.05});
        fit.evaluation = evaluate(cases, c, in_si(c, fit.x, scales), levels[0]);
        singles.push_back(as_screened(context, c, fit));
    }
    // only the first of the singles, which is no part of the truth, looks for a partner among all
    const auto pairs = fit_pairs(context, singles, 1);
    REQUIRE_FALSE(pairs.empty());
    CHECK(pairs[0].candidate.effects == std::vector{effect_named("viscous"), effect_named("inertia")});
    CHECK(pairs[0].accepted);
}

TEST_CASE("a descent finds back from where friction has been taken away altogether", "[gap]")
{
    test::Machine m;
    m.viscous = 0.3;  // documented: 1.5
    std::vector<Note> notes;
    const std::vector<Case> cases{prepare(test::record_of(m, 1), test::nominal_joint(), notes)};
    const Scales scales = scales_of(cases);
    const Candidate viscous = of({"viscous"});
    const double all_of_it = -1.5 / unit_of(Scale::damping, scales);
    // nothing depends on the change where all of the friction is gone
    const auto fit = descend({cases, viscous, scales, levels[1]}, to_fit(viscous, {3 * all_of_it}), 12);
    CHECK(in_si(viscous, fit.x, scales)[0] == Approx(-1.2).epsilon(0.02));
    CHECK(fit.evaluation.records[0].position < 1.1);
}

TEST_CASE("a dead time of whole ticks is found from just behind them, where the row shows the command before", "[gap]")
{
    test::Machine m;
    m.effort_noise = 0.05;
    std::vector<Note> notes;
    std::vector<Case> cases{prepare(test::record_of(m, 1, 4), test::nominal_joint(), notes)};
    Ticks& t = cases[0].ticks;
    const Candidate delay = of({"delay"});
    const Scales scales = scales_of(cases);
    const Joint late = edited(cases[0].joint, delay, {0.003}, 0);
    const Trace trace = simulate_closed_loop(flatten(late), t, 5);
    t.position = trace.position, t.velocity = trace.velocity, t.command = trace.command, t.effort = trace.effort;
    const double tick = unit_of(Scale::tick, scales);
    const auto fit = descend({cases, delay, scales, levels[1]}, to_fit(delay, {0.00301 / tick}), 12);
    CHECK(in_si(delay, fit.x, scales)[0] == Approx(0.003).epsilon(1e-4));
    CHECK(fit.evaluation.records[0].effort < 1.1);
}

TEST_CASE("a soft spring is found although springs too stiff to be seen miss by less than others as soft", "[gap]")
{
    test::Machine m;
    m.amplitude = 0.05, m.step = 0.02;
    std::vector<Note> notes;
    std::vector<Case> cases{prepare(test::record_of(m, 1, 4), test::nominal_joint(), notes)};
    Ticks& t = cases[0].ticks;
    const Candidate spring = of({"compliance"});
    const Scales scales = scales_of(cases);
    const double stiffness = 700;  // 53 rad/s
    const Joint soft = edited(cases[0].joint, spring, {0.7, stiffness, 0, 0.07}, 0);
    const Trace trace = simulate_closed_loop(flatten(soft), t, 5);
    t.position = trace.position, t.velocity = trace.velocity, t.command = trace.command;
    const Nominal nominal = judge_nominal(cases);
    const Fit context{cases, scales, nominal, test::in_order};
    const auto found = fit_singles(context, {spring});
    REQUIRE(found.size() == 1);
    CHECK(found[0].accepted);
    const auto si = in_si(spring, found[0].x[1], scales);
    CHECK(si[0] == Approx(0.7).epsilon(0.02));
    CHECK(si[1] == Approx(stiffness).epsilon(0.03));
}

TEST_CASE("numbers that make up for each other are searched together in the end", "[gap]")
{
    test::Machine m;
    m.coulomb = 2.4, m.limit = 3;
    std::vector<Note> notes;
    const std::vector<Case> cases{prepare(test::record_of(m, 1), test::nominal_joint(), notes)};
    const Scales scales = scales_of(cases);
    const Nominal nominal = judge_nominal(cases);
    const Fit context{cases, scales, nominal, test::in_order};
    const auto at = [&](const Candidate& c, const std::vector<double>& scaled) {
        LevelFit fit;
        fit.x = to_fit(c, scaled);
        fit.evaluation = evaluate(cases, c, in_si(c, fit.x, scales), levels[0]);
        auto a = as_screened(context, c, fit);
        a.refined = true;
        return a;
    };
    const double limit = m.limit / scales.peak_effort;
    std::vector<Attribution> pairs{at(of({"coulomb-level", "saturation"}), {0.1 / scales.effort, 0.9 * limit}),
                                   at(of({"coulomb-level", "viscous"}), {0.1 / scales.effort, 0.01})};
    REQUIRE(worst(pairs[0]) > 1.5);
    const auto smooth = pairs[1].x[0];
    polish_best(context, pairs, 2);
    REQUIRE(pairs[0].candidate.effects[1]->name == "saturation");
    CHECK(worst(pairs[0]) < 1.1);
    const auto si = in_si(pairs[0].candidate, pairs[0].x[1], scales);
    CHECK(si[0] == Approx(0.4).epsilon(0.05));
    CHECK(si[1] == Approx(m.limit).epsilon(0.01));
    CHECK(pairs[1].x[0] == smooth);  // a smooth misfit needs no simplex
}

TEST_CASE("backlash in a single mass damps its contact by the ratio that is fitted", "[gap]")
{
    const Candidate backlash = of({"backlash"});
    Joint joint;
    joint.mechanism.inertia = 2;
    CoulombViscous law;
    law.coulomb = 1;
    joint.friction.law = law;
    // width, share, stiffness, friction on the link, damping ratio: c = 2 ζ √(k m₁ m₂ / (m₁ + m₂))
    const Joint divided = edited(joint, backlash, {0.01, 0.25, 800, 0.4, 0.3}, 0);
    CHECK(divided.mechanism.motor_inertia == Approx(0.5));
    CHECK(divided.mechanism.transmission.damping == Approx(2 * 0.3 * std::sqrt(800 * 0.375)));
    CHECK(divided.mechanism.transmission.backlash == 0.01);
}

TEST_CASE("only backlash between two known masses is looked at on whole records", "[gap]")
{
    const Effect* backlash = effect_named("backlash");
    for (const auto& form : backlash->forms)
        CHECK(needs_history({{backlash}, {&form}, 1}) == (form.name == "two-mass"));
    CHECK_FALSE(needs_history(of({"compliance"})));
}
