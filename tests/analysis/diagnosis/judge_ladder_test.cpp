#include "analysis/diagnosis/verdict/judge_ladder.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/policy/ladder.h"
#include "analysis/diagnosis/policy/ladder_verdict.h"
#include "analysis/diagnosis/verdict/chances.h"
#include "analysis/diagnosis/verdict/controller_cause.h"
#include "analysis/diagnosis/verdict/experiment.h"
#include "analysis/diagnosis/verdict/report_ladder.h"
#include "tests/analysis/diagnosis/small_machine.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

/// One cause with this held-out misfit, of 600 rows that are left at this mean square.
FittedSet rung(std::initializer_list<const char*> names, double misfit, double square)
{
    FittedSet set;
    for (const char* name : names) {
        set.causes.effects.push_back(effect_named(name));
        set.causes.forms.push_back(&set.causes.effects.back()->forms[0]);
    }
    for (auto& fold : set.left) fold.push_back({0, 0, 200, square});
    set.misfit = misfit;
    return set;
}

/// A ladder of one rung whose rivals lie so many margins behind.
JudgedLadder ladder_of_one(std::initializer_list<double> behind, double square, bool noise_left)
{
    JudgedLadder j;
    const FittedSet first = rung({"stribeck"}, 0.1, square);
    const double margin = margin_of(first, policy::ladder);
    j.ladder.rungs.push_back(first);
    j.ladder.rivals.emplace_back();
    for (const double m : behind) j.ladder.rivals[0].push_back(rung({"presliding"}, 0.1 + m * margin, square));
    j.noise_left = noise_left;
    j.shares.documented = j.shares.base = 1;
    j.shares.rungs = {0};
    return j;
}

}  // namespace

TEST_CASE("a rung is believed by the odds against its rivals, one margin a factor of e", "[gap][ladder]")
{
    const double sure = 1 - policy::doubt_of_noise;
    CHECK(chances_of(ladder_of_one({}, 1, true))[0] == Approx(sure));
    CHECK(chances_of(ladder_of_one({0}, 1, true))[0] == Approx(sure / 2));
    CHECK(chances_of(ladder_of_one({1}, 1, true))[0] == Approx(sure / (1 + std::exp(-1))));
    CHECK(chances_of(ladder_of_one({1, 2}, 3, true))[0] == Approx(sure / (1 + std::exp(-1) + std::exp(-2))));
    // a rival that is better on unseen rows, but has no rung, counts once and not more
    CHECK(chances_of(ladder_of_one({-3}, 1, true))[0] == Approx(sure / 2));
}

TEST_CASE("what makes the very motion of a rung is as likely as what it leaves, whatever its numbers cost",
          "[gap][ladder]")
{
    // gravity at another angle has an amplitude that nothing holds back, an encoder's offset a corrected one
    JudgedLadder j = ladder_of_one({}, 1, true);
    FittedSet &gravity = j.ladder.rungs[0], offset = rung({"sensor-offset"}, 0, 1),
              load = rung({"constant-load"}, 0, 1);
    gravity = rung({"gravity"}, 0.1, 1);
    gravity.causes.forms[0] = &effect_named("gravity")->forms[1];
    const double margin = margin_of(gravity, policy::ladder);
    offset.misfit = load.misfit = 0.1 + 5 * margin;
    j.ladder.rivals[0] = {offset, load};
    CHECK(odds_of_rivals(j, 0)[0] == Approx(1));
    CHECK(odds_of_rivals(j, 0)[1] == Approx(std::exp(-5)));
    for (auto& fold : j.ladder.rivals[0][0].left) fold[0].position = std::exp(margin);
    CHECK(odds_of_rivals(j, 0)[0] == Approx(std::exp(-1)));
}

TEST_CASE("what a ladder leaves of the gap, and of the explainable, speaks against its last rung", "[gap][ladder]")
{
    auto j = ladder_of_one({}, 3, false);
    j.shares.rungs = {0.06}, j.shares.explainable_to = 0.06;  // half of nearest_in_shape
    CHECK(chances_of(j)[0] == Approx(1 - policy::doubt_of_noise - policy::doubt_of_rest / 2));
    j.shares.rungs = {0.5}, j.shares.explainable_to = 0.5;
    CHECK(chances_of(j)[0] == Approx(1 - policy::doubt_of_noise - policy::doubt_of_rest));
    j.shares.rungs = {0.5}, j.shares.explainable_to = 0.2;  // 0.3 of 0.8 is left of what some force explains
    CHECK(chances_of(j)[0] == Approx(1 - policy::doubt_of_noise - policy::doubt_of_rest - 0.375));
    j.shares.rungs = {1}, j.shares.explainable_to = 0;
    CHECK(chances_of(j)[0] == 0);
}

TEST_CASE("the rest speaks against the last cause that was found, not against those above it", "[gap][ladder]")
{
    auto j = ladder_of_one({}, 3, false);
    j.ladder.rungs.push_back(rung({"stribeck", "viscous"}, 0.05, 1.5));
    j.ladder.rivals.emplace_back();
    // a lower rung is no rival of the first
    j.ladder.rivals[0].push_back(rung({"viscous"}, 0.1, 3));
    j.shares.rungs = {0.4, 0.12}, j.shares.explainable_to = 0.12;
    const auto chances = chances_of(j);
    REQUIRE(chances.size() == 2);
    CHECK(chances[0] == Approx(1 - policy::doubt_of_noise));
    CHECK(chances[1] == Approx(1 - policy::doubt_of_noise - policy::doubt_of_rest));
}

TEST_CASE("a further rung that takes less than it leaves may be a part of what is left", "[gap][ladder]")
{
    auto j = ladder_of_one({}, 3, false);
    j.ladder.rungs.push_back(rung({"stribeck", "delay"}, 0.05, 3));
    j.ladder.rivals.emplace_back();
    const auto last_of = [&](double above, double left) {
        j.shares.rungs = {above, left}, j.shares.explainable_to = left;
        for (std::size_t f = 0; f < HeldOutData::folds; ++f)
            j.ladder.rungs[0].left[f][0].position = 1 + above, j.ladder.rungs[1].left[f][0].position = 1 + left;
        return chances_of(j)[1];
    };
    const double whole = 1 - policy::doubt_of_noise - policy::doubt_of_rest;  // 0.3 is beyond nearest_in_shape
    CHECK(last_of(0.6, 0.3) == Approx(whole));
    CHECK(last_of(0.4, 0.3) == Approx(whole / 3));
    CHECK(last_of(0.3, 0.3) == 0);
    j.noise_left = true;
    CHECK(last_of(0.4, 0.3) == Approx(1 - policy::doubt_of_noise));
}

TEST_CASE("windows that are lost whatever the numbers do not speak against a jagged cause", "[gap][ladder]")
{
    // each of three windows of 200 rows: what the causes above leave, and what all of them do, in multiples of the
    // noise
    const auto last_of = [&](const char* cause, std::array<double, 3> above, std::array<double, 3> all) {
        auto j = ladder_of_one({}, 3, false);
        j.ladder.rungs.push_back(rung({"gravity", cause}, 0.05, 3));
        j.ladder.rivals.emplace_back();
        j.shares.rungs = {0.4, 0.3}, j.shares.explainable_to = 0.3;
        for (std::size_t f = 0; f < 3; ++f)
            j.ladder.rungs[0].left[f][0].position = above[f], j.ladder.rungs[1].left[f][0].position = all[f];
        return chances_of(j)[1];
    };
    const double whole = 1 - policy::doubt_of_noise - policy::doubt_of_rest;
    CHECK(last_of("backlash", {101, 101, 1000}, {2, 2, 1000}) == Approx(whole));  // geometric means 217 and 16
    CHECK(last_of("stribeck", {101, 101, 1000}, {2, 2, 1000}) == Approx(whole * 198 / 1001));
    CHECK(last_of("backlash", {1, 1, 1000}, {1, 1, 1000}) == 0);
    CHECK(last_of("backlash", {2, 2, 1001}, {2, 2, 501}) == Approx(whole * 500 / 502));  // 5 of 16 in the mean
}

TEST_CASE("a rival of a lower rung is believed by the set that it makes with the rungs on top", "[gap][ladder]")
{
    auto j = ladder_of_one({0, 0}, 3, false);
    j.ladder.rungs.push_back(rung({"stribeck", "constant-load"}, 0.05, 3));
    j.ladder.rivals.emplace_back();
    const double margin = margin_of(j.ladder.rungs[1], policy::ladder);
    j.ladder.rivals[0][0].in_the_last = 0.05 + 2 * margin;
    j.ladder.rivals[0][1].in_the_last = infinity;  // no rung at all beside the others
    j.shares.rungs = {0.4, 0.12}, j.shares.explainable_to = 0.12;
    const auto odds = odds_of_rivals(j, 0);
    CHECK(odds[0] == Approx(std::exp(-2)));
    CHECK(odds[1] == 0);
}

TEST_CASE("rivals of every rung are told as whole sets, and none that the chances do not count", "[gap][ladder]")
{
    auto j = ladder_of_one({0.5, 3}, 3, false);
    REQUIRE(indistinguishable(j).size() == 1);
    CHECK(indistinguishable(j)[0].odds == Approx(std::exp(-0.5)));
    j.ladder.rungs.push_back(rung({"stribeck", "constant-load"}, 0.05, 3));
    const double margin = margin_of(j.ladder.rungs[1], policy::ladder);
    j.ladder.rivals.push_back({rung({"stribeck", "sensor-offset"}, 0.05 + 0.2 * margin, 3)});
    j.ladder.rivals[0].push_back(rung({"constant-load"}, 0.1, 3));  // another rung
    j.shares.rungs = {0.4, 0.12}, j.shares.explainable_to = 0.12;
    const auto near = indistinguishable(j);
    REQUIRE(near.size() == 2);
    CHECK(near[0].names == std::vector<std::string>{"presliding", "constant-load"});
    CHECK(near[1].names == std::vector<std::string>{"stribeck", "sensor-offset"});
    CHECK(near[1].separates == std::pair<std::string, std::string>{"constant-load", "sensor-offset"});
    for (const auto& chance : chances_of(j)) CHECK(chance < 1 / (1 + policy::odds_of_indistinguishable));
    // a set with one rung exchanged is judged by its odds from the whole set, not from that rung alone
    j.chances = chances_of(j);
    CHECK(chance_of_all(j) == Approx(j.chances[0] * j.chances[1]));
    const auto all = rivals_of(j);
    REQUIRE(all.size() == 4);
    CHECK(all[1].names == std::vector<std::string>{"presliding", "constant-load"});
    CHECK(all[1].odds == Approx(std::exp(-3)));
    CHECK(all[2].odds == 0);  // another rung
    // where only noise is left, what stood beside a lower rung is no doubt
    j.noise_left = true;
    REQUIRE(indistinguishable(j).size() == 1);
    CHECK(indistinguishable(j)[0].rung == 1);
    CHECK(chances_of(j)[0] == Approx(1 - policy::doubt_of_noise));
}

TEST_CASE("corrections alone are held against free forces, which have to take as much as a cause would",
          "[gap][ladder]")
{
    JudgedLadder j;
    j.only_corrections = true;
    j.winner.explained = 0.6;
    for (auto& e : j.winner.evaluation) e.records = {{5, 1}};
    const auto force = [](double explained, double misfit) {
        FreeFit f{"position", {}};
        f.fit.explained = explained;
        for (auto& e : f.fit.evaluation) e.records = {{misfit, 1}};
        return f;
    };
    const auto answers = [&](const FreeFit& f) {
        JudgedLadder held = j;
        hold_against(held, f);
        CHECK(held.answers() != held.why_not.has_value());
        return held.answers();
    };
    CHECK_FALSE(answers(force(0.97, 1.3)));
    CHECK(answers(force(0.7, 1.3)));  // a sixth of what the corrections take: every machine has such things
    CHECK(answers(force(0.97, 4.5)));
    j.only_corrections = false, j.named = true;  // a rung has taken as much
    j.ladder.rungs.push_back(rung({"gravity"}, 0.1, 5));
    j.shares.base = 1, j.shares.rungs = {0.1};
    CHECK_FALSE(answers(force(0.7, 1.3)));
    // with its own ripple and cogging the cause came as near, and a free force only took those along
    j.with_small_terms = mean_log_misfit(force(0, 1.35).fit.evaluation);
    CHECK(answers(force(0.7, 1.3)));
    CHECK_FALSE(answers(force(0.7, 1.05)));
    j.shares.rungs = {0.9 * policy::all_but_explained};  // whatever a force takes of that
    CHECK(answers(force(0.7, 1.05)));
}

TEST_CASE("a dead time that is as much a lag may be either, with the odds of their sizes", "[gap][ladder]")
{
    for (const double lag : {0.3, 0.7}) {  // in dead times
        CAPTURE(lag);
        JudgedLadder j;
        FittedSet late = rung({"delay"}, 0.1, 1);
        const auto& forms = late.causes.effects[0]->forms;
        late.causes.forms[0] = &*std::ranges::find(forms, "with-lag", &EffectForm::name);
        late.fit.x = Eigen::Vector2d(2, std::log(lag));
        const double far = 50 * margin_of(late, policy::ladder);
        j.ladder.rungs.push_back(late);
        j.ladder.rivals.emplace_back();
        for (const char* name : {"actuator-lag", "compliance"})
            j.ladder.rivals[0].push_back(rung({name}, 0.1 + far, 1));
        const auto odds = odds_of_rivals(j, 0);
        CHECK(odds[0] == Approx(lag < policy::as_much_the_other ? 0 : lag).margin(1e-12));
        CHECK(odds[1] < 1e-12);
    }
}

TEST_CASE("a slight peak, and a drift that a record sees little of, are what every machine has", "[gap][ladder]")
{
    std::vector<Note> notes;
    const std::vector<Case> cases{prepare(test::record_of({}, 1, 3), test::nominal_joint(), notes)};
    const Scales scales = scales_of(cases);
    const Corrections corrections(cases, scales, policy::ladder.prior);
    const double level = test::Machine().coulomb / unit_of(Scale::friction_effort, scales);
    const auto usual = [&](const char* name, double part, double other) {
        const Candidate c = rung({name}, 0, 1).causes;
        Eigen::VectorXd x = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(c.parameter_count()));
        x[0] = part * level, x[1] = std::log(other);
        return corrections.is_usual(c, x, *c.effects[0]);
    };
    CHECK(usual("stribeck", 0.015, 0.1));
    CHECK_FALSE(usual("stribeck", 0.2, 0.1));
    CHECK_FALSE(usual("stribeck", 0.1, 0.1));
    CHECK(usual("stribeck", 0.1, 3));  // usual speeds: a record sees a tenth of such a peak
    CHECK_FALSE(usual("presliding", 0.015, 0.1));
    CHECK(usual("friction-drift", 0.02, 0.5));
    CHECK_FALSE(usual("friction-drift", 0.2, 0.5));  // time constants in records
    CHECK(usual("friction-drift", 0.2, 8));
}

TEST_CASE("a small term that takes little is not what the gap comes from, any other cause stays", "[gap][ladder]")
{
    auto j = ladder_of_one({}, 3, false);
    j.shares.documented = 1, j.shares.base = j.shares.corrected = 0.2;  // corrections take 0.8
    j.shares.rungs = {0.05};                                            // and the cause 0.15: less than a quarter of it
    CHECK_FALSE(small_against_corrections(j));
    j.usual = true;
    CHECK(small_against_corrections(j));
    j.shares.corrected = 0.3;  // 0.25 beside 0.7
    CHECK_FALSE(small_against_corrections(j));
    j.shares.rungs = {0.2, 0.1};  // the second takes 0.1 beside the 0.8 of corrections and the first
    CHECK(small_against_corrections(j));
    j.shares.rungs = {0.29, 0.1};  // 0.19 beside 0.71
    CHECK_FALSE(small_against_corrections(j));
}

TEST_CASE("the controller stands first by itself, and with causes that take a good part beside it", "[gap][ladder]")
{
    std::vector<Note> notes;
    const std::vector<Case> cases{prepare(test::record_of({}, 1, 3), test::nominal_joint(), notes)};
    const auto corrections = std::make_shared<Corrections>(cases, scales_of(cases), policy::ladder.prior);
    constexpr double likely = 0.9, of_rival = 0.05;
    static_assert(likely > policy::finding_and_more);
    const auto answer = [&](double of_controller, double of_rung, double chance, bool noise_left = false,
                            bool numbers = false, const char* cause = "presliding", bool usual = false,
                            double left = 0.1) {
        Diagnosis d;
        d.ladder.resize(2);
        d.ladder[0].share = of_controller, d.ladder[1].share = of_rung;
        d.effects.resize(2);
        d.effects[0].names = {"velocity-filter", "presliding"}, d.effects[0].probability = chance;
        d.effects[1].names = {"compliance"}, d.effects[1].probability = of_rival;
        Cause controller;
        controller.names = {"velocity-filter"};
        JudgedLadder j;
        j.noise_left = noise_left, j.only_corrections = numbers, j.usual = usual;
        j.shares.base = 1, j.shares.rungs = {left};
        j.ladder.corrections = corrections;
        j.ladder.rungs.push_back(rung({cause}, 0, 1));
        put_controller_in_order(controller, j, d);
        return d.effects;
    };
    const auto both = answer(0.3, 0.5, likely);
    CHECK(both[0].names.size() == 2);
    CHECK(both[0].probability == likely);
    CHECK(both[1].names.size() == 1);
    CHECK(both[1].probability == Approx(1 - likely - of_rival));
    for (const auto& alone :
         {answer(0.9, 0.05, likely), answer(0.3, 0.5, 0.8 * policy::finding_and_more), answer(0, 0, 0.6)}) {
        CHECK(alone[0].names.size() == 1);
        CHECK(alone[0].probability == policy::finding_and_more);
        CHECK(alone[1].names.size() == 2);
    }
    // a fifth of its share is no scatter, but a small term of every machine may be as large
    CHECK(answer(0.7, 0.14, likely)[0].names.size() == 2);
    CHECK(answer(0.7, 0.14, likely, false, false, "cogging", true)[0].names.size() == 1);
    CHECK(answer(0.6, 0.16, likely, false, false, "cogging", true)[0].names.size() == 2);
    // where much remains, what else takes a fifth may be only the nearest in shape
    CHECK(answer(0.6, 0.12, likely, false, false, "presliding", false, 0.15)[0].names.size() == 1);
    CHECK(answer(0.6, 0.16, likely, false, false, "presliding", false, 0.15)[0].names.size() == 2);
    // numbers of the document beside it are none of it
    const auto beside_numbers = answer(0.6, 0, 0.75, false, true);
    CHECK(beside_numbers[0].probability == Approx(policy::finding_with_numbers));
    CHECK(beside_numbers[1].probability == Approx(0.75 * (1 - policy::finding_with_numbers)));
    // small things that leave only noise are no doubt about the controller, and large ones belong to the answer
    CHECK(answer(0.9, 0.01, likely, true)[0].names.size() == 1);
    CHECK(answer(0.9, 0.01, likely, true)[0].probability == Approx(1 - policy::doubt_of_noise));
    CHECK(answer(0.3, 0.5, likely, true)[0].probability == likely);
    CHECK(answer(0.3, 0.5, likely, true).size() == 2);
    // a documented inertia that is further off than documents are is wrong, however little the records feel it
    const auto with_inertia = answer(0.9, 0.01, likely, true, false, "inertia");
    CHECK(with_inertia[0].names.size() == 2);
    CHECK(with_inertia[0].probability == likely);
    CHECK(answer(0.9, 0.01, likely, false, false, "inertia")[0].names.size() == 1);
}

TEST_CASE("a documented number that would go back to its bound is told apart from other last rungs", "[gap][ladder]")
{
    std::vector<Note> notes;
    const std::vector<Case> cases{prepare(test::record_of({}, 1, 3), test::nominal_joint(), notes)};
    Ladder ladder;
    ladder.corrections = std::make_shared<Corrections>(cases, scales_of(cases), policy::ladder.prior);
    const auto held_at = [&](double deviations, std::initializer_list<const char*> last) {
        FittedSet below = rung({"load-dependent-friction"}, 1, 5);
        below.causes.records = cases.size();
        below.model = ladder.corrections->beside(below.causes);
        below.fit.x = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(below.model.candidate.parameter_count()));
        REQUIRE(below.model.candidate.effects[0]->name == "inertia");
        below.fit.x[0] = deviations * policy::correction_prior.inertia;
        ladder.rungs = {below, rung(last, 0.8, 4)};
        return frees_held_number(ladder);
    };
    const double widest = policy::correction_prior.widest;
    CHECK(held_at(widest, {"load-dependent-friction", "inertia"}));
    CHECK_FALSE(held_at(0.9 * widest, {"load-dependent-friction", "inertia"}));
    CHECK_FALSE(held_at(widest, {"load-dependent-friction", "stribeck"}));
    ladder.rungs.clear();
    CHECK_FALSE(frees_held_number(ladder));
}

TEST_CASE("a controller beside which one of two causes acts is not alone", "[gap][ladder]")
{
    Diagnosis d;
    d.ladder.resize(2), d.ladder[0].share = 0.7, d.ladder[1].share = 0.2;
    d.effects.resize(2);
    d.effects[0].names = {"gain-k_i", "constant-load"}, d.effects[1].names = {"gain-k_i", "asymmetric-friction"};
    d.effects[0].probability = d.effects[1].probability = 0.48;
    Cause controller;
    controller.names = {"gain-k_i"};
    JudgedLadder j;
    j.shares.base = 1, j.shares.rungs = {0.01};
    put_controller_in_order(controller, j, d);
    REQUIRE(d.effects.size() == 3);
    CHECK(d.effects[0].names.size() == 2);
    CHECK(d.effects[0].probability == 0.48);
    CHECK(d.effects[2].names.size() == 1);
    CHECK(d.effects[2].probability == Approx(0.04));
    // unless that is likelier than any one of them
    d.effects.pop_back();
    d.effects[0].probability = d.effects[1].probability = 0.3;
    put_controller_in_order(controller, j, d);
    CHECK(d.effects[0].names.size() == 1);
    CHECK(d.effects[0].probability == Approx(0.4));
}
