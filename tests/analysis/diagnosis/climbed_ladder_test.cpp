// Ladders climbed on records of a small machine, and what is judged of them.
#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/ladder/climber.h"
#include "analysis/diagnosis/plant/simulator.h"
#include "analysis/diagnosis/policy/ladder.h"
#include "analysis/diagnosis/verdict/chances.h"
#include "analysis/diagnosis/verdict/experiment.h"
#include "analysis/diagnosis/verdict/judge_ladder.h"
#include "tests/analysis/diagnosis/ladder_search.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

using namespace stickslip;
using namespace stickslip::gap;
using stickslip::test::Machine;
using Search = LadderRecords;

TEST_CASE("a number further off than documents are is freed beside a cause, though it earns no rung",
          "[gap][ladder][slow]")
{
    Machine m;
    m.coulomb = 2 * 0.78, m.viscous = 6, m.cubic = 300;  // and a spring of no catalogue
    const Search search(m, {"viscous", "coulomb-level"});
    const auto ladder = search.search->climb({}, policy::ladder.most_rungs);
    const FittedSet& last = ladder.last();
    REQUIRE(names_of(last.causes).size() == 2);
    const auto si = in_si(last.causes, last.of_causes(last.fit.x), search.scales);
    std::size_t at = 0;
    for (std::size_t i = 0; last.causes.effects[i]->name != "coulomb-level"; ++i)
        at += last.causes.count_of(*last.causes.forms[i]);
    constexpr double level = 2;  // N; the spring, for which a wave stands in, bends it by less than a hundredth
    CHECK(si[at] == Approx(-0.44).margin(0.01 * level));
}

TEST_CASE(
    "beside a cause a number counts as far off where the document is otherwise exact, not where it is off as a whole",
    "[gap][ladder][slow]")
{
    Machine m;
    m.viscous = 4, m.inertia = 1.2 * 1.1;
    const auto far_off = [](const Machine& machine) {
        const Search search(machine, {"viscous"});
        const auto ladder = search.search->climb({}, 1);
        REQUIRE(ladder.rungs.size() == 1);
        std::vector<std::string_view> names;
        for (const auto& number : search.search->far_off(ladder)) names.push_back(number.effect->name);
        return names;
    };
    CHECK(far_off(m) == std::vector<std::string_view>{"inertia"});
    m.coulomb = 2 * 0.94;  // 1.2 standard deviations beside the 2.5 of the inertia
    CHECK(far_off(m).empty());
    m.load = 2 * 0.13;  // which the document does not mention
    CHECK(far_off(m) == std::vector<std::string_view>{"constant-load"});
}

TEST_CASE("a level that only stood in for a rising curve gives way once that is found", "[gap][ladder][slow]")
{
    Machine m;
    m.peak = 0.4, m.peak_velocity = 0.06, m.viscous = 1.5 + 3;
    const Search search(m, {"coulomb-level", "stribeck:any-exponent", "viscous"});
    const Corrections corrections(search.cases, search.scales, policy::ladder.prior);
    const HeldOutData data(search.cases);
    SetFitter fitter(data, search.scales, corrections, policy::ladder.ranges);
    fitter.renew();
    Climber climber(search.singles, fitter, policy::ladder, test::in_order);
    const auto judged = [&](std::initializer_list<const char*> names) {
        Start start;
        start.causes.records = search.cases.size();
        Eigen::VectorXd x;
        for (const char* name : names) {
            const auto single = search.single(name);
            x = insert(start.causes, single.candidate.effects[0], single.candidate.forms[0], x, single.x[0]);
        }
        start.x0 = fitter.start(start.causes, {}, x);
        return climber.judged({start});
    };
    const FittedSet below = judged({"coulomb-level", "stribeck:any-exponent"}).front();
    REQUIRE_FALSE(below.correction);
    const auto tried = judged({"coulomb-level", "stribeck:any-exponent", "viscous"});
    REQUIRE(tried.front().correction);
    const auto other = climber.without_correction(below, tried);
    REQUIRE(other);
    CHECK(names_of(other->causes) == std::vector<std::string>{"viscous", "stribeck"});
    CHECK(other->misfit < below.misfit);
    CHECK_FALSE(climber.without_correction(tried.front(), tried));  // it comes no nearer
}

TEST_CASE("a wave stays where it is when what was found with it is taken away", "[gap][ladder][slow]")
{
    Machine m;
    m.cogging = 0.8, m.viscous = 6;
    const Search search(m, {"viscous", "cogging"});
    Attribution known;
    known.candidate = {{effect_named("viscous"), effect_named("cogging")},
                       {&effect_named("viscous")->forms[0], &effect_named("cogging")->forms[0]},
                       search.cases.size()};
    known.x.fill(to_fit(known.candidate, {0.5, 0.3, 0.1, 3}));
    const Ladder both = search.search->of(known), one = search.search->without(both, *effect_named("viscous"));
    REQUIRE(both.rungs.size() == 2);
    REQUIRE(one.rungs.size() == 1);
    const FittedSet &with = both.last(), &less = one.last();
    REQUIRE(less.causes.effects[0]->name == "cogging");
    // sizes answer to what is missing; the length of the wave is what it is called by
    CHECK(less.of_causes(less.fit.x)[0] != with.of_causes(with.fit.x)[1]);
    CHECK(less.of_causes(less.fit.x)[2] == with.of_causes(with.fit.x)[3]);
}

TEST_CASE("a divided mass is found beside a larger cause that brought it to a stiff spring alone",
          "[gap][ladder][slow]")
{
    Machine m;
    m.viscous = 9, m.hung = 0.5, m.hung_stiffness = 900, m.hung_damping = 1;
    const Search search(m, {"viscous", "coulomb-level", "gravity", "compliance:divided-mass-encoder-on-link"});
    auto stiff = search.singles;
    stiff.back().x.fill(to_fit(stiff.back().candidate, {0.9, 5000, 0.3, 0.05}));
    LadderSearch beside({search.cases, search.scales, search.nominal, test::in_order}, stiff, policy::ladder);
    const auto ladder = beside.climb({}, policy::ladder.most_rungs);
    REQUIRE(ladder.rungs.size() == 2);
    const FittedSet& last = ladder.last();
    CHECK(names_of(last.causes) == std::vector<std::string>{"viscous", "compliance"});
    const auto si = in_si(last.causes, last.of_causes(last.fit.x), search.scales);
    CHECK(si[1] == Approx(1 - m.hung / m.inertia).margin(0.03));
    CHECK(si[2] == Approx(m.hung_stiffness).epsilon(0.05));
}

TEST_CASE("a ladder without its last rung is that of the corrections alone", "[gap][ladder]")
{
    Machine m;
    m.viscous = 3;
    const Search search(m, {"viscous"});
    auto ladder = search.search->climb({}, 1);
    REQUIRE(ladder.rungs.size() == 1);
    search.search->shorten(ladder);
    CHECK(ladder.rungs.empty());
    const auto j = search.judged(std::move(ladder));
    CHECK(j.shares.corrected == Approx(j.shares.base));
}

TEST_CASE("corrections that leave most of the gap are not the answer, those that leave noise are",
          "[gap][ladder][slow]")
{
    Machine m;
    m.inertia = 1.2 * 1.06, m.coulomb = 2 * 0.93;
    const Search sound(m, {"stribeck"});
    const auto off = sound.judged(sound.search->climb({}, policy::ladder.most_rungs));
    REQUIRE(off.ladder.rungs.empty());
    CHECK(off.only_corrections);
    CHECK(off.answers());
    CHECK_FALSE(off.why_not);
    // held readings are no function of any signal: all that is explainable is the little that the numbers are off
    m.inertia = 1.2 * 1.01, m.coulomb = 2 * 0.99;
    const Search held(m, {"stribeck"}, 0.02);
    const auto dropped = held.judged(held.search->climb({}, policy::ladder.most_rungs));
    REQUIRE(dropped.ladder.rungs.empty());
    const auto& s = dropped.shares;
    CHECK(s.base > 0.5 * s.documented);
    CHECK_FALSE(dropped.answers());
    REQUIRE(dropped.why_not);
    CHECK(dropped.why_not->code == Note::Code::nothing_earns);
}

TEST_CASE("the climb ends where only noise is left", "[gap][ladder][slow]")
{
    Machine m;
    m.viscous = 3, m.one_way = 0.4;
    const Search search(m, {"viscous", "asymmetric-friction", "gravity"});
    const auto whole = search.search->climb({}, policy::ladder.most_rungs);
    REQUIRE(whole.rungs.size() == 2);
    int asked = 0;
    const auto ended = search.search->climb({}, policy::ladder.most_rungs, [&](const FittedSet& set) {
        ++asked;
        return set.causes.effects.size() == 1;
    });
    CHECK(asked == 1);
    CHECK(ended.rungs.size() == 1);
}

TEST_CASE("a limit that single steps reach has a rung beside a cause that acts everywhere", "[gap][ladder][slow]")
{
    Machine m;
    m.one_way = 0.4, m.step = 0.03, m.limit = 12;
    Machine later = m;
    later.step_time = 0.8;  // in another fold
    const Search search({m, later}, {"asymmetric-friction", "saturation"});
    const auto ladder = search.search->climb({}, policy::ladder.most_rungs);
    REQUIRE(ladder.rungs.size() == 2);
    CHECK(beyond_noise(ladder.last().all_left()) < 1e-3 * beyond_noise(ladder.corrected.all_left()));
}

TEST_CASE("a stand-in that came with a pair is exchanged for the cause that belongs beside the other",
          "[gap][ladder][slow]")
{
    Machine m;
    m.viscous = 10, m.load = 0.4;
    const Search search(m, {"constant-load"});
    Attribution pair;
    for (const char* name : {"viscous", "asymmetric-friction"}) {
        const Effect* e = effect_named(name);
        pair.candidate.effects.push_back(e), pair.candidate.forms.push_back(&e->forms[0]);
    }
    pair.candidate.records = 2;
    pair.x.fill(to_fit(pair.candidate, {0.1, 0.01, 0.01}));
    const auto ladder = search.search->climb({pair}, 2);
    REQUIRE(ladder.rungs.size() == 2);
    CHECK(names_of(ladder.last().causes) == std::vector<std::string>{"viscous", "constant-load"});
    // and the stand-in is a rival, which the chances count
    CHECK(std::ranges::any_of(ladder.rivals[1], [](const FittedSet& s) {
        return names_of(s.causes) == std::vector<std::string>{"viscous", "asymmetric-friction"};
    }));
}

TEST_CASE("small terms that every machine has are not named beside a cause", "[gap][ladder][slow]")
{
    Machine m;
    m.inertia = 1.2 * 1.5, m.one_way = 0.06 * m.viscous;
    const auto of = [](const Machine& machine) {
        const Search search(machine, {"inertia", "asymmetric-friction"});
        auto j = search.judged(search.search->climb({}, policy::ladder.most_rungs));
        REQUIRE(j.ladder.rungs.size() == 2);
        CHECK(j.noise_left);
        return small_against_corrections(j);
    };
    CHECK(of(m));
    m.one_way = 0.5 * m.viscous;  // no term of machines
    CHECK_FALSE(of(m));
}

TEST_CASE("a small term stands behind all other causes, and goes from there", "[gap][ladder][slow]")
{
    Machine m;
    m.inertia = 1.2 * 1.5, m.one_way = 0.06 * m.viscous, m.gravity = 0.08;
    const Search search(m, {"inertia", "asymmetric-friction", "gravity"});
    const auto j = search.judged(search.search->climb({}, policy::ladder.most_rungs));
    REQUIRE(j.ladder.rungs.size() == 3);
    CHECK(names_of(j.ladder.rungs[1].causes) == std::vector<std::string>{"inertia", "gravity"});
    CHECK(small_term_between(j) == nullptr);
    CHECK(small_against_corrections(j));
    const auto shorter = search.judged(search.search->without(j.ladder, *effect_named("asymmetric-friction")));
    CHECK(names_of(shorter.ladder.last().causes) == std::vector<std::string>{"inertia", "gravity"});
}

TEST_CASE("a small term on top of a cause goes among the corrections of a ladder that is climbed anew",
          "[gap][ladder][slow]")
{
    Machine m;
    m.viscous = 3;
    const Search search(m, {"viscous"});
    Attribution two = search.single("viscous");
    const Attribution wave = search.single("position-dependent-friction");
    two.candidate.effects.push_back(wave.candidate.effects[0]), two.candidate.forms.push_back(wave.candidate.forms[0]);
    for (std::size_t l = 0; l < two.x.size(); ++l) {
        Eigen::VectorXd both(two.x[l].size() + wave.x[l].size());
        both << two.x[l], wave.x[l];
        two.x[l] = both;
    }
    const Ladder ladder = search.search->of(two);
    REQUIRE(ladder.rungs.size() == 2);
    REQUIRE(names_of(ladder.rungs[0].causes) == std::vector<std::string>{"viscous"});
    const auto anew = search.search->with_small_term(ladder, {}, {});
    REQUIRE(anew);
    CHECK(names_of(anew->last().causes) == std::vector<std::string>{"viscous"});
    const auto& model = anew->last().model;
    CHECK(std::any_of(model.candidate.effects.begin(), model.candidate.effects.begin() + model.corrections,
                      [](const Effect* e) { return e->name == "position-dependent-friction"; }));
    CHECK_FALSE(search.search->with_small_term(ladder, {}, {}));
}

TEST_CASE("what could not be told from a rung is fitted anew before it is", "[gap][ladder][slow]")
{
    Machine m;
    m.load = 1.2, m.inertia = 1.2 * 1.08, m.coulomb = 2 * 0.9;
    // the same motion, but for a viscous part that is 0; what else is tried lets the first be fitted again
    const Search search(m, {"constant-load", "asymmetric-friction", "viscous", "stribeck"});
    const auto ladder = search.search->climb({}, policy::ladder.most_rungs);
    REQUIRE(ladder.rungs.size() == 1);
    REQUIRE(!ladder.rivals[0].empty());
    const auto& rung = ladder.rungs[0];
    CHECK(std::abs(ladder.rivals[0][0].misfit - rung.misfit) < margin_of(rung, policy::ladder));
}

TEST_CASE("a wave that a larger cause hid is a small term of the ladder that is climbed anew", "[gap][ladder][slow]")
{
    Machine m;
    m.inertia = 1.2 * 1.5, m.gravity = 5, m.cogging = 0.03,
    m.waves = 50;  // 1.6 waves in the travel: in part what gravity explains
    const Search search(m, {"inertia", "gravity", "cogging"});
    const auto ladder = search.search->climb({}, policy::ladder.most_rungs);
    CHECK(names_of(ladder.last().causes) == std::vector<std::string>{"inertia", "gravity"});
    CHECK(ladder.corrections->has("cogging"));
    CHECK(beyond_noise(ladder.last().all_left()) < 1e-3 * beyond_noise(ladder.corrected.all_left()));
}

TEST_CASE("a Stribeck peak of another shape than the catalogue's is one cause", "[gap][ladder][slow]")
{
    Machine m;
    m.peak = 1;
    const auto climbed = [&](const char* form) {
        const Search search(m, {form, "viscous"});
        return search.search->climb({}, policy::ladder.most_rungs);
    };
    // of a fixed exponent the tail of the peak is left, and would be called a viscous slope
    CHECK(names_of(climbed("stribeck:gaussian").last().causes) == std::vector<std::string>{"stribeck"});
    const auto ladder = climbed("stribeck:any-exponent");
    CHECK(names_of(ladder.last().causes) == std::vector<std::string>{"stribeck"});
    CHECK(beyond_noise(ladder.last().all_left()) < 0.003 * beyond_noise(ladder.corrected.all_left()));
}

TEST_CASE("a divided mass on a spring that hardens is found by its stiffness at small stretches", "[gap][slow]")
{
    Machine m;
    // twice as stiff from 0.3 N on, where the Coulomb level is 2 N
    m.hung = 0.8, m.hung_stiffness = 300, m.hung_damping = 1.5, m.hung_stretch = 1e-3;
    const Search search(m, {});
    const Effect* e = effect_named("compliance");
    std::vector<Candidate> forms;
    for (const char* name : {"divided-mass", "divided-mass-hardening"})
        forms.push_back({{e}, {&*std::ranges::find(e->forms, name, &EffectForm::name)}, search.cases.size()});
    const auto best = fit_singles({search.cases, search.scales, search.nominal, test::in_order}, forms);
    REQUIRE(best.size() == 1);
    REQUIRE(best[0].candidate.forms[0]->name == "divided-mass-hardening");
    const auto si = in_si(best[0].candidate, best[0].x[0], search.scales);
    CHECK(si[0] == Approx(1 - m.hung / m.inertia).margin(0.03));
    CHECK(si[1] == Approx(m.hung_stiffness).epsilon(0.05));
    CHECK(si[4] == Approx(m.hung_stiffness * m.hung_stretch).epsilon(0.1));
}

TEST_CASE("a cause that would pay with impossible numbers alone is told as that", "[gap][ladder][slow]")
{
    Machine m;
    m.cubic = 4000;  // a spring of no catalogue, to which a wave longer than the travel comes near
    const Search search(m, {"cogging"});
    const auto j = search.judged(search.search->climb({}, policy::ladder.most_rungs));
    REQUIRE(j.ladder.rungs.empty());
    REQUIRE(j.why_not);
    CHECK(j.why_not->code == Note::Code::earns_implausible);
    CHECK(j.why_not->names == std::vector<std::string>{"cogging"});
}

TEST_CASE("a small drift that could grow into the place of a changed level stands behind it", "[gap][ladder][slow]")
{
    constexpr double level = 2 * 0.2, drift = 2 * 0.03, time_constant = 5;  // N, N, s; records of 5 s
    Joint joint = test::nominal_joint();
    shift_coulomb(joint.friction, level + drift);
    joint.friction.drift.change = -drift, joint.friction.drift.time_constant = time_constant;
    Search search(Machine{}, {});
    search.simulate(joint, {"coulomb-level", "friction-drift:to-document"});
    Attribution both = search.singles[0];
    const Attribution& other = search.singles[1];
    both.candidate.effects.push_back(other.candidate.effects[0]);
    both.candidate.forms.push_back(other.candidate.forms[0]);
    both.x.fill(to_fit(both.candidate, {level / search.scales.effort, drift / search.scales.effort,
                                        time_constant / search.scales.duration}));
    const Ladder ladder = search.search->of(both);
    REQUIRE(ladder.rungs.size() == 2);
    CHECK(ladder.rungs[0].causes.effects[0]->name == "coulomb-level");
    CHECK(ladder.rungs[1].causes.effects[1]->name == "friction-drift");
}
