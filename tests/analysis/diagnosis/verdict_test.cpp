#include "analysis/diagnosis/policy/verdict.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/fit/moment.h"
#include "analysis/diagnosis/heldout/ensemble.h"
#include "analysis/diagnosis/policy/ladder_verdict.h"
#include "analysis/diagnosis/report_findings.h"
#include "analysis/diagnosis/verdict/causes.h"
#include "analysis/diagnosis/verdict/decide.h"
#include "tests/analysis/diagnosis/small_machine.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

constexpr double rows = 3e4;  // of all records
// Rules are tested just beside the policy's thresholds, wherever those stand.
constexpr double slightly = 1e-3;
constexpr double sure = 1 - policy::doubt_of_accepted;

Attribution found(std::initializer_list<const char*> names, double score, double explained, bool accepted)
{
    Attribution a;
    for (const char* name : names) {
        a.candidate.effects.push_back(effect_named(name));
        a.candidate.forms.push_back(&a.candidate.effects.back()->forms[0]);
    }
    a.score = a.evidence = score, a.explained = explained, a.accepted = accepted, a.refined = true;
    return a;
}

}  // namespace

TEST_CASE("a pair is named only when nothing is left, and two free functions of position explain nothing before",
          "[gap]")
{
    constexpr double alone = policy::explained_single - slightly, together = 1 - slightly;
    const std::vector<Attribution> singles{found({"gravity"}, 1.8, alone, false)};
    std::vector<Attribution> pairs{found({"gravity", "cogging"}, 0.08, together, false)};
    CHECK_FALSE(decide(singles, pairs, rows).named);
    CHECK(decide(singles, pairs, rows).best_explained == alone);
    pairs[0].accepted = true;
    CHECK(decide(singles, pairs, rows).named);
    // a shape and a slope cannot bend into anything
    const auto d = decide(singles, {found({"viscous", "cogging"}, 0.08, together, false)}, rows);
    CHECK_FALSE(d.named);
    CHECK(d.best_explained == together);
}

TEST_CASE("a pair that leaves nothing wins over a single that leaves little if it is clearly better", "[gap]")
{
    constexpr double score_alone = 0.19;
    const auto named = [](const char* alone, double explained, double score) {
        const std::vector<Attribution> singles{found({alone}, score_alone, explained, false)};
        return decide(singles, {found({"viscous", alone}, score, 1, true)}, rows).named;
    };
    const double little = policy::explained_single + slightly;
    CHECK(named("frictional-memory", little, score_alone - policy::worth_a_partner - slightly));
    CHECK_FALSE(named("frictional-memory", little, score_alone - policy::worth_a_partner + slightly));
    CHECK(named("frictional-memory", little - 2 * slightly, score_alone - policy::worth_a_partner + slightly));
    // real backlash leaves a rest by itself, of which a partner makes something
    CHECK_FALSE(named("backlash", little, score_alone - policy::worth_a_partner - slightly));
    CHECK(named("backlash", little, score_alone - policy::worth_a_doubted_partner - slightly));
    CHECK(named("backlash", little - 2 * slightly, score_alone - policy::worth_a_partner + slightly));
}

TEST_CASE("probabilities fall with the misfit, with a needless parameter and with what is left", "[gap]")
{
    std::vector<Attribution> singles{found({"coulomb-level"}, 0.010, 1, true),
                                     found({"asymmetric-friction"}, 0.010, 1, true),
                                     found({"viscous"}, 0.4, 0.6, false)};
    const auto ranked = rank(singles, {}, decide(singles, {}, rows), rows);
    CHECK(ranked[0].probability / ranked[1].probability ==
          Approx(policy::needless_parameter));  // one parameter more, and nothing gained
    CHECK(ranked[2].probability < 1e-6);
    CHECK(ranked[0].probability + ranked[1].probability + ranked[2].probability == Approx(sure));
    const double rest = 0.1;
    singles[0].explained = 1 - rest;
    CHECK(rank(singles, {}, decide(singles, {}, rows), rows)[0].probability ==
          Approx((1 - 0.5 * rest / sure) * ranked[0].probability));
}

TEST_CASE("the odds between causes at the noise are those of a likelihood, and grow with the rows", "[gap]")
{
    std::vector<Attribution> singles{found({"delay"}, 0.003, 1, true), found({"actuator-lag"}, 0.003, 1, true)};
    singles[0].evidence = -0.101, singles[1].evidence = -0.100;  // both below a floor that is too high
    const auto odds = [&](double n) {
        const auto ranked = rank(singles, {}, decide(singles, {}, n), n);
        return ranked[0].probability / ranked[1].probability;
    };
    // Gaussian innovations of unknown variance: ln L = -n/2 ln(mean square), one independent reading in so many rows
    CHECK(odds(30000) == Approx(std::exp(0.5 * 30000 / policy::rows_per_reading * 0.001)));
    CHECK(odds(120000) == Approx(std::pow(odds(30000), 4)));
    // far above the floor margins are model error, whatever the rows
    for (auto& s : singles) s.score = 0.5;
    CHECK(odds(1e6) < 2);
}

TEST_CASE("what cannot be told from the named cause has its part of the probability", "[gap]")
{
    // scores that the floor hides; the likelihood of all rows is what distinguishes
    std::vector<Attribution> singles{found({"asymmetric-friction"}, 0.006, 1, true),
                                     found({"constant-load"}, 0.010, 1, true)};
    const auto answer = [&](double worse) {
        singles[0].evidence = -0.1, singles[1].evidence = -0.1 + worse;
        const auto d = decide(singles, {}, rows);
        return std::pair{d.ambiguous.size(), rank(singles, {}, d, rows)[0].probability};
    };
    const auto [none, alone] = answer(0.05);
    CHECK(none == 0);
    CHECK(alone == Approx(sure));
    for (double worse = 0; worse < 0.02; worse += 0.0003) {
        const auto [rivals, probability] = answer(worse);
        INFO(worse);
        CHECK((rivals == 0) == (probability > sure / (1 + policy::odds_of_indistinguishable)));
    }
    CHECK(answer(0).first == 1);
}

TEST_CASE("causes of the very same motion are told together, whatever their parameters", "[gap]")
{
    // friction whose level alone differs by direction is a constant load, and has a slope that it does not need
    const auto answer = [](const char* one, const char* other) {
        std::vector<Attribution> singles{found({one}, 0.010, 1, true), found({other}, 0.010, 1, true)};
        singles[1].candidate.forms[0] = &singles[1].candidate.effects[0]->forms.back();
        const auto d = decide(singles, {}, rows);
        return std::pair{d.ambiguous.size(), rank(singles, {}, d, rows)[0].probability};
    };
    CHECK(answer("constant-load", "asymmetric-friction") == std::pair<std::size_t, double>{1, sure / 2});
    CHECK(answer("sensor-offset", "gravity") == std::pair<std::size_t, double>{1, sure / 2});
    CHECK(answer("viscous", "asymmetric-friction").first == 0);
}

TEST_CASE("of causes that come down to the noise the likelier comes first, though the floor hides the difference",
          "[gap]")
{
    std::vector<Attribution> singles{found({"delay"}, 0.003, 1, true), found({"actuator-lag"}, 0.004, 1, true),
                                     found({"viscous"}, 0.5, 0, false)};
    singles[0].evidence = -0.100, singles[1].evidence = -0.105, singles[2].evidence = -0.9;
    confirm({{}, {}, {}, test::in_order}, singles);
    CHECK(singles[0].candidate.effects[0]->name == "actuator-lag");
    CHECK(singles[1].candidate.effects[0]->name == "delay");
    CHECK(singles[2].candidate.effects[0]->name == "viscous");  // not accepted: its floor is not the question
}

TEST_CASE("a step lost in one moment does not decide between causes that are alike everywhere else", "[gap]")
{
    std::vector<Attribution> singles{found({"coulomb-level"}, 0.02, 1, true), found({"viscous"}, 0.12, 1, true)};
    constexpr std::size_t blocks = 100, at = 40;
    const auto odds = [&](double everywhere, double in_one_moment) {
        for (auto& a : singles)
            for (auto& level : a.evaluation) level.records.assign(1, {1, 1, std::vector<double>(blocks, 1.0), {}});
        auto& slow = singles[1].evaluation[2].records[0].position_blocks;
        for (double& x : slow) x = everywhere;
        slow[at] += in_one_moment, slow[at + 1] += in_one_moment;
        double mean = 0;
        for (double x : slow) mean += x / blocks;
        // three levels of one record, and its effort at the fastest
        singles[1].evidence = 0.02 + std::log(mean) / 4;
        const auto ranked = rank(singles, {}, decide(singles, {}, rows), rows);
        return ranked[0].probability / ranked[1].probability;
    };
    CHECK(odds(1, 100) == Approx(1));
    CHECK(decide(singles, {}, rows).ambiguous.size() == 1);
    // the same misfit all over the record tells them apart: half of log 3 for each independent reading of its rows
    CHECK(odds(3, 0) == Approx(std::exp(rows / policy::rows_per_reading / 2 * std::log(3.0) / 4)).epsilon(1e-3));
    CHECK(decide(singles, {}, rows).ambiguous.empty());
    // seconds of which a record has but a few are no moments
    for (auto& a : singles)
        for (auto& level : a.evaluation) level.records[0].position_blocks.assign(20, 1.0);
    singles[1].evaluation[2].records[0].position_blocks[7] = 100;
    CHECK(hangs_on_a_moment(singles[0].evaluation, singles[1].evaluation, exact_square) == 0);
    // where one of them is not known to be right, a lost step may be what is wrong with it
    singles[1].accepted = false;
    CHECK(odds(1, 100) > 1e10);
}

TEST_CASE("a joint whose closed loop differs from no record by more than noise has no gap", "[gap]")
{
    const auto at_its_floor = [&](const test::Machine& m) {
        std::vector<Note> notes;
        const std::vector<Case> cases{prepare(test::record_of(m, 1), test::nominal_joint(), notes)};
        Nominal nominal = judge_nominal(cases);
        nominal.worst = 1.2;  // a slow observer that once took a stop for a slip
        Attribution none;
        none.evaluation = nominal.evaluation;
        for (auto& misfit : none.evaluation.back().records) misfit.position = 1.3;
        return at_floor({cases, scales_of(cases), nominal, test::in_order}, none);
    };
    CHECK(at_its_floor({}));
    test::Machine rougher;
    rougher.coulomb = 2.1;
    CHECK_FALSE(at_its_floor(rougher));
}

TEST_CASE("what a cause explains is measured over the longest horizon where shorter ones hide the gap", "[gap]")
{
    const auto at = [](double middle, double slow) {
        std::array<Evaluation, levels.size()> all;
        for (auto& level : all) level.records.resize(1);
        all[0].records[0].position = 1, all[1].records[0].position = middle, all[2].records[0].position = slow;
        return all;
    };
    Nominal nominal;
    nominal.evaluation = at(0.99, 5);
    Attribution a = found({"viscous"}, 0, 0, false);
    a.evaluation = at(0.99, 2);
    judge(a, nominal);
    CHECK(a.explained == Approx(0.75));  // (2 − 1)/(5 − 1) is left
    // where the middle one shows it, the middle one counts
    nominal.evaluation = at(3, 5);
    a.evaluation = at(2, 2);
    judge(a, nominal);
    CHECK(a.explained == Approx(0.5));
}

TEST_CASE("a cause that is itself noise is not held to make things worse", "[gap]")
{
    OverallGap gap;
    gap.before = 2.2, gap.after = 2.4, gap.floor = 1;
    CHECK(gap.worse());
    gap.own_floor = 2.4;  // two simulations with it differ by as much as the record does
    CHECK_FALSE(gap.worse());
}

TEST_CASE("a wave of which the travel holds only a bend is told from one that turns", "[gap]")
{
    const auto pair = found({"gravity", "cogging"}, 0.02, 1, true).candidate;
    Scales scales;
    scales.position = 6.6;
    const auto seen = [&](double wave_number) {
        std::vector<double> x(pair.parameter_count(), 0.1);
        for (std::size_t i = 0; i < x.size(); ++i)
            if (pair.parameter(i).grid == FrequencyGrid::position) x[i] = wave_number * scales.position;
        return bends_only(pair, to_fit(pair, x), scales);
    };
    CHECK(seen(0.45));  // period 14 rad
    CHECK_FALSE(seen(1.5));
    CHECK_FALSE(bends_only(found({"gravity"}, 0.02, 1, true).candidate, Eigen::VectorXd::Zero(2), scales));
}

TEST_CASE("what a true joint's own noise leaves is no unexplained rest", "[gap]")
{
    Nominal nominal;
    nominal.evaluation[1].records = {{101, 1}, {2, 1}};
    Evaluation middle;
    middle.records = {{4, 1}, {1, 1}};
    NoiseSpread own;
    for (auto& level : own.mean) level = {{1, 1}, {1, 1}};
    CHECK(explained_beyond(own, middle, nominal) == Approx(1 - 3 / 101.0));
    own.mean[1][0].position = 3;  // a jump between two rows of a slow log
    CHECK(explained_beyond(own, middle, nominal) == Approx(1 - 1 / 101.0));
    own.mean[1][0].position = 0.5;  // fewer than one floor is luck
    CHECK(explained_beyond(own, middle, nominal) == Approx(1 - 3 / 101.0));
}

TEST_CASE("what the audit found belongs to every set, rivals' too", "[gap]")
{
    Prepared p;
    p.audit.findings.push_back({"gain-k_i", "gain-k_i.value", 1500, 1, Quantity::integral_gain, 1});
    using Names = std::vector<std::string>;
    CHECK(with_findings(p, {"frictional-memory"}) == Names{"gain-k_i", "frictional-memory"});
    CHECK(with_findings(p, {"gain-k_i"}) == Names{"gain-k_i"});
}

TEST_CASE("a filter that is the documented one, discretised exactly, is said to be that", "[gap]")
{
    const double tick = 1e-3, documented = 2e-3;
    // low pass of a held input: v(T) = v + (1 - exp(-T/tau)) (d - v)
    const double same = tick / std::expm1(tick / documented);
    Prepared p;
    p.documented.emplace_back();
    p.documented[0].control.period = tick;
    p.documented[0].control.velocity_estimate.tau = documented;
    const auto said = [&](double tau, double error) {
        Diagnosis d;
        d.effects.emplace_back();
        d.effects[0].parameters = {{"velocity-filter.tau", tau, error, "s"}};
        report_filter(p, d);
        return std::ranges::any_of(d.notes, [](const Note& n) { return n.code == Note::Code::filter_as_exponential; });
    };
    CHECK(said(same, 0));
    CHECK_FALSE(said(1.1 * same, 0));
    CHECK(said(1.1 * same, 0.06 * same));  // within the interval of what was found
    p.documented[0].control.velocity_estimate.tau = 0;
    CHECK_FALSE(said(same, 0));
}
