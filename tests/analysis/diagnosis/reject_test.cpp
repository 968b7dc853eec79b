#include "analysis/diagnosis/verdict/reject.h"
#include "analysis/diagnosis/policy/ladder_verdict.h"
#include "analysis/diagnosis/policy/verdict.h"
#include "analysis/results/contradictions.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

/// Probabilities of two causes as found, before anything speaks against them.
constexpr double first_found = 0.6, second_found = 0.3;
static_assert(first_found > policy::believed_simulated && policy::believed_simulated > policy::believed_doubted);

/// A named cause and what it leaves on held-out data, in floors.
Diagnosis leaving(double before, double after)
{
    Diagnosis d;
    d.verdict = Verdict::gap;
    d.effects.resize(2);
    d.effects[0].names = {"stribeck"}, d.effects[0].probability = first_found;
    d.effects[1].names = {"viscous"}, d.effects[1].probability = second_found;
    d.ambiguous_with = {{"viscous"}};
    d.overall.before = before, d.overall.after = after, d.overall.floor = 1;
    return d;
}

}  // namespace

TEST_CASE("a cause that makes held-out data worse is withdrawn, one that is settled and helps is not", "[gap]")
{
    auto d = leaving(3, 2.9);
    CHECK_FALSE(reject_if_not_validated(d, {.settled = true}));
    CHECK(d.verdict == Verdict::gap);
    CHECK(d.effects[0].probability == first_found);
    REQUIRE(d.reasons.size() == 1);  // it leaves more than 1.5 times the noise floor of whole records
    CHECK(d.reasons[0] == Note{.code = Note::Code::adds_up, .values = {2.9}});
    d.reasons.clear();
    d.overall.after = 3.1;
    CHECK(reject_if_not_validated(d, {.settled = true}));
    CHECK(d.verdict == Verdict::unknown);
    CHECK(d.ambiguous_with.empty());
    REQUIRE(d.reasons.size() == 1);
    CHECK(d.reasons[0] == Note{.code = Note::Code::rejected_worse, .names = {"stribeck"}});
    CHECK(d.effects.size() == 2);
}

TEST_CASE("a ladder of predictions stays where only the simulation of whole records gets worse, and names nothing",
          "[gap]")
{
    const auto rejected = [](double after, bool predicted) {
        auto d = leaving(3, after);
        LadderRung rung;
        rung.names = {"stribeck"}, rung.share = 0.5, rung.probability = first_found,
        rung.ambiguous_with = {{"viscous"}};
        d.ladder = {rung};
        d.corrected_share = 0.2, d.remainder.share = 0.3;
        d.overall.explained = (9 - after * after) / 8;
        CHECK(reject_if_not_validated(d, {.predicted = predicted}));
        CHECK(d.verdict == Verdict::unknown);
        CHECK(contradictions_in(d).empty());
        return d;
    };
    const auto worse = rejected(3.1, true);
    REQUIRE(worse.ladder.size() == 1);
    CHECK(worse.ladder[0].share == 0.5);
    CHECK(worse.ladder[0].probability == policy::believed_unnamed);
    CHECK(worse.ladder[0].ambiguous_with.empty());
    CHECK(worse.corrected_share == 0.2);
    CHECK(worse.remainder.share == 0.3);
    CHECK(rejected(3.1, false).ladder.empty());
    CHECK(rejected(2.4, true).ladder.empty());  // it helps, but leaves most
}

TEST_CASE("a cause that predictions leave open and that hardly helps on held-out data is not named", "[gap]")
{
    auto d = leaving(3, 2.4);  // (2.4² - 1)/(3² - 1) = 0.595 is left
    CHECK(reject_if_not_validated(d, {}));
    CHECK(d.verdict == Verdict::unknown);
    REQUIRE(d.reasons.size() == 1);
    CHECK(d.reasons[0] == Note{.code = Note::Code::rejected_leaves_most, .names = {"stribeck"}});
    CHECK(d.effects[0].probability == policy::believed_unnamed);
    CHECK(d.effects[1].probability == Approx(policy::believed_unnamed * second_found / first_found));
    // two simulations of a joint that sticks or slips by chance differ by more than two of the nominal one
    d = leaving(3, 2.4);
    d.overall.own_floor = 2;
    CHECK_FALSE(reject_if_not_validated(d, {}));
    CHECK(d.verdict == Verdict::gap);
}

TEST_CASE("a cause that leaves more than a documented noise is doubted, rivals alike", "[gap]")
{
    auto d = leaving(10, 2);
    CHECK_FALSE(reject_if_not_validated(d, {.noise_documented = true}));
    CHECK(d.verdict == Verdict::gap);
    CHECK(d.effects[0].probability == policy::believed_doubted);
    CHECK(d.effects[1].probability == Approx(policy::believed_doubted * second_found / first_found));
    REQUIRE(d.reasons.size() == 1);
    CHECK(d.reasons[0] == Note{.code = Note::Code::doubted_above_noise, .names = {"stribeck"}, .values = {2}});
    for (const auto& [after, standing] : {std::pair{1.2, Standing{.noise_documented = true}}, {2.0, Standing{}}}) {
        d = leaving(10, after);
        CHECK_FALSE(reject_if_not_validated(d, standing));
        CHECK(d.effects[0].probability == first_found);
    }
}

TEST_CASE("a ladder of predictions is doubted where whole records are simulated much worse than rows are predicted",
          "[gap]")
{
    const auto probability = [](double after, bool predicted) {
        auto d = leaving(10, after);
        d.overall.explained = (100 - after * after) / 99;
        CHECK_FALSE(reject_if_not_validated(d, {.settled = true, .predicted = predicted}));
        CHECK(d.verdict == Verdict::gap);
        return d.effects[0].probability;
    };
    CHECK(probability(4, true) == policy::believed_simulated);  // 0.85 is explained
    CHECK(probability(3, true) == first_found);
    CHECK(probability(4, false) == first_found);
}

TEST_CASE("rungs of a ladder are no surer than the set that simulations doubt, and the reason is said", "[gap]")
{
    const auto doubted = [](std::size_t findings, std::vector<double> probabilities) {
        auto d = leaving(10, 4);
        d.overall.explained = 84.0 / 99;
        d.ladder.resize(probabilities.size());
        for (std::size_t i = 0; i < probabilities.size(); ++i) d.ladder[i].probability = probabilities[i];
        CHECK_FALSE(reject_if_not_validated(d, {.settled = true, .predicted = true, .findings = findings}));
        CHECK(d.effects[0].probability == policy::believed_simulated);
        REQUIRE(d.reasons.size() == 1);
        CHECK(d.reasons[0].code == Note::Code::doubted_as_a_whole);
        CHECK(d.reasons[0].names == std::vector<std::string>{"stribeck"});
        CHECK(d.reasons[0].values == std::vector<double>{84.0 / 99, 4});
        std::vector<double> left;
        for (const auto& rung : d.ladder) left.push_back(rung.probability);
        return left;
    };
    CHECK(doubted(0, {first_found})[0] == Approx(policy::believed_simulated));
    // what a set of two is doubted for its last rung bears: their product is that of the set
    const auto two = doubted(0, {0.8, 0.75});
    CHECK(two[0] == 0.8);
    CHECK(two[0] * two[1] == Approx(policy::believed_simulated));
    CHECK(doubted(1, {0.98})[0] == 0.98);  // read off the command
    CHECK(doubted(1, {0.98, first_found})[1] == Approx(policy::believed_simulated));
}

TEST_CASE("a cause that leaves many floors which nobody documented is not named", "[gap]")
{
    auto d = leaving(15, 7.5);  // three quarters of the mean square are gone
    CHECK(reject_if_not_validated(d, {}));
    CHECK(d.verdict == Verdict::unknown);
    REQUIRE(d.reasons.size() == 1);
    CHECK(d.reasons[0] == Note{.code = Note::Code::rejected_in_many_floors, .names = {"stribeck"}, .values = {7.5}});
    for (const auto& standing : {Standing{.settled = true}, Standing{.noise_documented = true}}) {
        d = leaving(15, 7.5);
        CHECK_FALSE(reject_if_not_validated(d, standing));
        CHECK(d.verdict == Verdict::gap);
    }
}

TEST_CASE("a cause that leaves a rest and needs an implausible number is not named", "[gap]")
{
    auto d = leaving(10, 1.3);
    d.effects[0].plausible = false;
    CHECK_FALSE(reject_if_not_validated(d, {.settled = true}));
    CHECK(d.verdict == Verdict::gap);
    CHECK(reject_if_not_validated(d, {.noise_documented = true}));
    CHECK(d.verdict == Verdict::unknown);
    CHECK(d.reasons.at(0) == Note{.code = Note::Code::rejected_implausible, .names = {"stribeck"}});
}

TEST_CASE("a joint whose predictions hide in the noise is not free of a gap that the whole motion shows", "[gap]")
{
    Diagnosis d;
    d.verdict = Verdict::no_gap;
    const Note before{Note::Code::too_few_rows, "a.csv"}, after{Note::Code::free_force};
    d.reasons = {before, {Note::Code::within_noise}, after};
    d.overall.before = 1.25;
    CHECK_FALSE(reject_no_gap(d));
    CHECK(d.verdict == Verdict::no_gap);
    d.overall.before = 3.85;
    CHECK(reject_no_gap(d));
    CHECK(d.verdict == Verdict::unknown);
    REQUIRE(d.reasons.size() == 3);  // what stands no longer goes, wherever it stood; other remarks stay
    CHECK(d.reasons[0] == before);
    CHECK(d.reasons[1] == after);
    CHECK(d.reasons[2] == Note{.code = Note::Code::far_as_a_whole, .values = {3.85}});
    d.verdict = Verdict::gap;
    CHECK_FALSE(reject_no_gap(d));
}

TEST_CASE("the only cause of a ladder is not named where none of the catalogue is likelier", "[gap]")
{
    const auto rejected = [](double probability, std::vector<std::string> names, std::size_t findings) {
        auto d = leaving(3, 1.2);
        d.effects.resize(1);
        d.effects[0].names = std::move(names), d.effects[0].probability = probability;
        LadderRung rung;
        rung.names = d.effects[0].names, rung.share = 0.6, rung.probability = probability;
        d.ladder = {rung};
        const bool taken_back = reject_if_not_validated(d, {.settled = true, .predicted = true, .findings = findings});
        CHECK(taken_back == (d.verdict == Verdict::unknown));
        if (taken_back) {
            REQUIRE(d.reasons.size() == 1);
            CHECK(d.reasons[0] ==
                  Note{.code = Note::Code::rejected_less_likely, .names = {"stribeck"}, .values = {1 - probability}});
            CHECK(d.ladder.empty());
            CHECK(d.remainder.share == 1);
        }
        return taken_back;
    };
    CHECK(rejected(0.34, {"stribeck"}, 0));
    CHECK_FALSE(rejected(0.51, {"stribeck"}, 0));
    CHECK_FALSE(rejected(0.34, {"stribeck", "gravity"}, 0));  // of a set a part may still be right
    CHECK_FALSE(rejected(0.34, {"stribeck"}, 1));             // the audit of the controller does not rest on rows
}
