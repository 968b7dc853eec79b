// The scorer against answers whose score is counted by hand.
#include "sweep/study/binomial.h"
#include "sweep/study/score.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace stickslip::blind;

namespace {

Truth truth(const EffectSet& effects, const EffectSet& equivalent = {})
{
    Truth t{.verdict = effects.empty() ? "no-gap" : "gap", .effects = effects, .equivalent = equivalent};
    t.gap_before = 10;
    t.gap_after = 1;
    return t;
}

Answer gap(const std::vector<EffectSet>& ranked, const std::vector<double>& probabilities = {},
           const std::vector<EffectSet>& ambiguous = {})
{
    return {.verdict = "gap",
            .ranked = ranked,
            .probabilities = probabilities,
            .ambiguous_with = ambiguous,
            .gap_before = 8,
            .gap_after = 0.84};
}

}  // namespace

TEST_CASE("singles are counted first, by an equal name, and in an ambiguity set of two", "[score]")
{
    const std::map<std::string, Truth> truths = {
        {"a", truth({"viscous"})}, {"b", truth({"constant-load"}, {"asymmetric-friction"})},
        {"c", truth({"delay"})},   {"d", truth({"delay"})},
        {"e", truth({"delay"})},   {"f", truth({"delay"})}};
    const std::map<std::string, Answer> answers = {
        {"a", gap({{"viscous"}, {"stribeck"}})},
        {"b", gap({{"asymmetric-friction"}})},
        {"c", gap({{"actuator-lag"}}, {0.5}, {{"delay"}})},
        {"d", gap({{"actuator-lag"}}, {0.5}, {{"delay"}, {"compliance"}})},  // a set of three is no answer
        {"e", gap({{"delay", "viscous"}}, {0.9})},                           // named more than there was
    };
    const Score s = score(answers, truths);
    CHECK(s.top1.right == 2);
    CHECK(s.top1.of == 6);
    CHECK(s.top1_exact.right == 1);
    CHECK(s.named.right == 3);
    CHECK(s.by_effect.at("delay").right == 1);
    CHECK(s.by_effect.at("delay").of == 4);
    CHECK(s.verdicts.right == 5);
}

TEST_CASE("a pair needs both names; a flat ranking names its first two", "[score]")
{
    const std::map<std::string, Truth> truths = {
        {"a", truth({"viscous", "delay"})}, {"b", truth({"viscous", "delay"})}, {"c", truth({"viscous", "delay"})}};
    const Score s = score({{"a", gap({{"delay", "viscous"}}, {0.9})},
                           {"b", gap({{"delay"}, {"viscous"}})},
                           {"c", gap({{"viscous"}, {"delay"}}, {0.6, 0.4})}},
                          truths);
    CHECK(s.pairs_both.right == 2);
    CHECK(s.pair_members.right == 5);
    CHECK(s.pair_members.of == 6);
}

TEST_CASE("false alarms, abstention and hopeless data have their own counts", "[score]")
{
    std::map<std::string, Truth> truths = {{"none-1", truth({})}, {"none-2", truth({})}, {"none-3", truth({})}};
    truths["out-1"].verdict = truths["out-2"].verdict = "unknown";
    truths["few"].verdict = "insufficient-data";
    const Score s = score({{"none-1", {.verdict = "no-gap"}},
                           {"none-2", gap({{"viscous"}}, {0.3})},
                           {"none-3", {.verdict = "insufficient-data"}},
                           {"out-1", {.verdict = "unknown"}},
                           {"out-2", gap({{"viscous"}}, {0.8})},
                           {"few", {.verdict = "insufficient-data"}}},
                          truths);
    CHECK(s.false_alarms.right == 1);
    CHECK(s.false_alarms.of == 3);
    CHECK(s.abstained.right == 1);
    CHECK(s.abstained.of == 2);
    CHECK(s.insufficient.right == 1);
}

TEST_CASE("Brier score and calibration error of four forecasts", "[score]")
{
    std::map<std::string, Truth> truths;
    for (const char* name : {"a", "b", "c", "d"}) truths[name] = truth({"viscous"});
    const Score s = score({{"a", gap({{"viscous"}}, {0.95})},
                           {"b", gap({{"viscous"}}, {0.95})},
                           {"c", gap({{"delay"}}, {0.95})},
                           {"d", gap({{"delay"}}, {0.25})}},
                          truths);
    CHECK(s.brier == Approx((0.05 * 0.05 * 2 + 0.95 * 0.95 + 0.25 * 0.25) / 4));
    CHECK(s.calibration_error == Approx(0.75 * (0.95 - 2. / 3) + 0.25 * 0.25));
    CHECK(s.reliability[9].right.of == 3);
    CHECK(s.reliability[2].mean_probability == Approx(0.25));
}

TEST_CASE("shrinks are compared on named cases only", "[score]")
{
    const Truth outside{.verdict = "unknown", .gap_before = 10, .gap_after = 1};
    const Answer abstained{.verdict = "unknown", .gap_before = 8, .gap_after = 8};
    const Score s = score({{"a", gap({{"viscous"}})}, {"b", gap({{"stribeck"}})}, {"c", abstained}},
                          {{"a", truth({"viscous"})}, {"b", truth({"viscous"})}, {"c", outside}});
    CHECK(s.median_shrink == Approx(0.105));
    CHECK(s.median_truth_shrink == Approx(0.1));
    CHECK(s.within_tenth.right == 1);
    CHECK(s.within_tenth.of == 1);
}

TEST_CASE("the explained share is a part of the squares of the gap, and may be off by a tenth of them", "[score]")
{
    const auto explained_in = [](double after) {
        Answer a = gap({{"viscous"}});
        a.gap_before = 10, a.gap_after = after;
        Truth t = truth({"viscous"});
        t.gap_before = 10, t.gap_after = 1;  // 0.99 of the squares
        return score({{"a", a}}, {{"a", t}});
    };
    CHECK(explained_in(3.3).explained_within_tenth.right == 1);  // 0.891
    CHECK(explained_in(3.4).explained_within_tenth.right == 0);  // 0.884
    CHECK(explained_in(3.3).within_tenth.right == 0);
    CHECK(explained_in(3.4).explained_within_tenth.of == 1);
}

TEST_CASE("answers are read with names, sets or objects of names, and errors name the case", "[score]")
{
    const auto answers =
        parse_answers(R"({"x": {"verdict": "gap", "effects": ["viscous", ["delay", "inertia"], {"names": ["backlash"]}],
        "probabilities": [0.7, 0.2], "ambiguous_with": [["gravity"]], "gap_before": 3, "gap_after": 1.5}, "y": {"verdict": "no-gap", "gap_before": null}})");
    const auto& x = answers.at("x");
    CHECK(x.ranked == std::vector<EffectSet>{{"viscous"}, {"delay", "inertia"}, {"backlash"}});
    CHECK(x.ambiguous_with == std::vector<EffectSet>{{"gravity"}});
    CHECK(x.gap_after == 1.5);
    CHECK(std::isnan(answers.at("y").gap_before));
    CHECK_THROWS_WITH(parse_answers(R"({"z": {"effects": []}})"), Catch::Contains("z"));
    CHECK_THROWS_AS(parse_truths("[1]"), std::invalid_argument);
}

TEST_CASE("bounds of a counted share are those of Clopper and Pearson", "[score]")
{
    // all right: the share p with p^n = 0.05; 8 of 10: 45p⁸q² + 10p⁹q + p¹⁰ = 0.05, in exact fractions
    CHECK(share_at_least(59, 59) == Approx(std::pow(0.05, 1.0 / 59)).epsilon(1e-9));
    CHECK(share_at_least(8, 10) == Approx(0.4930987).epsilon(1e-6));
    CHECK(share_at_most(0, 300) == Approx(1 - std::pow(0.05, 1.0 / 300)).epsilon(1e-9));
    CHECK(share_at_least(0, 5) == 0);
    CHECK(share_at_most(5, 5) == 1);
}

TEST_CASE("a document that is off is no false alarm where it is called that, and dirty cases are told apart", "[score]")
{
    Truth off = truth({}, {"inertia", "coulomb-level"});
    off.dirty = true;
    const std::map<std::string, Truth> truths = {{"a", off}, {"b", off}, {"c", truth({})}};
    const std::map<std::string, Answer> answers = {
        {"a", gap({{"inertia", "coulomb-level"}})}, {"b", gap({{"backlash"}})}, {"c", gap({{"inertia"}})}};
    const Score s = score(answers, truths);
    REQUIRE(s.parts.size() == 2);
    CHECK(s.parts[0].state == "clean");
    CHECK(s.parts[0].false_alarms.right == 1);  // a joint that is its document has nothing to correct
    CHECK(s.parts[1].false_alarms.right == 1);
    CHECK(s.parts[1].false_alarms.of == 2);
}
