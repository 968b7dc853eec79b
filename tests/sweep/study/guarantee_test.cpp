// Conformal sets: the order statistic against closed forms, scores by hand, coverage of exchangeable draws.
#include "analysis/numerics/seeded_noise.h"
#include "sweep/files/json/calibration_json.h"
#include "sweep/study/guarantee/calibration.h"
#include "sweep/study/guarantee/order_statistic.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace stickslip;
using namespace stickslip::guarantee;

namespace {

/// P(X ≤ x) of X ~ Beta(k, m) by Simpson's rule on its density: no binomial sum.
double beta_below(double x, double k, double m)
{
    const double log_norm = std::lgamma(k + m) - std::lgamma(k) - std::lgamma(m);
    const auto density = [&](double t) {
        return t <= 0 || t >= 1 ? (t >= 1 && m == 1 ? k : 0.0)
                                : std::exp(log_norm + (k - 1) * std::log(t) + (m - 1) * std::log1p(-t));
    };
    constexpr int halves = 20000;
    double sum = density(0) + density(x);
    for (int i = 1; i < 2 * halves; ++i) sum += (i % 2 ? 4 : 2) * density(x * i / (2.0 * halves));
    return sum * x / (6.0 * halves);
}

blind::Answer gap(std::vector<blind::EffectSet> ranked, std::vector<double> probabilities)
{
    return {.verdict = "gap", .ranked = std::move(ranked), .probabilities = std::move(probabilities)};
}

CalibrationCase answered(const std::string& cause, const blind::Answer& answer, int number)
{
    return {std::to_string(number), {.verdict = "gap", .effects = {cause}}, answer, {}};
}

/// A joint whose cause is one of three, and an answer that is right more often the clearer the case is.
CalibrationCase drawn(SeededNoise& noise, int number)
{
    const std::vector<std::string> causes{"viscous", "backlash", "delay"};
    const auto cause = static_cast<std::size_t>(3 * noise.uniform());
    std::vector<std::pair<double, std::string>> evidence;
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        evidence.emplace_back(std::exp(1.5 * noise() + (i == cause ? 2 : 0)), causes[i]);
        sum += evidence.back().first;
    }
    std::ranges::sort(evidence, std::greater());
    blind::Answer answer = gap({}, {});
    // now and then a cause does not make it into the list
    for (std::size_t i = 0; i < (noise.uniform() < 0.1 ? 2U : 3U); ++i)
        answer.ranked.push_back({evidence[i].second}), answer.probabilities.push_back(evidence[i].first / sum);
    return answered(causes[cause], answer, number);
}

}  // namespace

TEST_CASE("the ranks are those of Wilks' tolerance limits", "[guarantee]")
{
    // Wilks, Ann. Math. Statist. 12 (1941): 59, 93, 124, 153, 181 draws for the largest to the fifth largest, 95 % / 95
    // %
    CHECK(fewest_that_cover(0.95, 0.95) == 59);
    CHECK(rank_that_covers(58, 0.95, 0.95) == 0);
    int nth = 1;
    for (const int n : {59, 93, 124, 153, 181}) {
        CHECK(rank_that_covers(n, 0.95, 0.95) == n + 1 - nth);
        if (nth > 1) CHECK(rank_that_covers(n - 1, 0.95, 0.95) == n + 1 - nth);
        ++nth;
    }
    CHECK(fewest_that_cover(0.9, 0.95) == 29);    // 0.9^29 = 0.047
    CHECK(fewest_that_cover(0.99, 0.95) == 299);  // 0.99^299 = 0.0495
}

TEST_CASE("the coverage of a rank is a Beta variable", "[guarantee]")
{
    for (const auto& [n, coverage, confidence] : {std::tuple{59, 0.95, 0.95}, std::tuple{100, 0.95, 0.95},
                                                  std::tuple{240, 0.9, 0.99}, std::tuple{700, 0.95, 0.95}}) {
        const int k = rank_that_covers(n, coverage, confidence);
        CAPTURE(n, k);
        CHECK(beta_below(coverage, k, n + 1 - k) <= 1 - confidence + 1e-9);
        CHECK(beta_below(coverage, k - 1, n + 2 - k) > 1 - confidence);
    }
}

TEST_CASE("of ten thousand calibrations one in twenty covers too little, and no more", "[guarantee]")
{
    SeededNoise noise(20261124);
    constexpr int repetitions = 10000, n = 120;
    const int rank = rank_that_covers(n, 0.95, 0.95);
    int short_of = 0;
    double mean = 0;
    for (int i = 0; i < repetitions; ++i) {
        std::vector<double> scores(n);
        for (auto& score : scores) score = noise.uniform();
        const double covered = score_that_covers(scores, 0.95, 0.95);  // of uniform scores: the threshold itself
        short_of += covered < 0.95;
        mean += covered / repetitions;
    }
    const double expected = beta_below(0.95, rank, n + 1 - rank);
    const double sigma = std::sqrt(expected * (1 - expected) / repetitions);
    CAPTURE(short_of, expected);
    CHECK(expected <= 0.05);
    CHECK(std::abs(static_cast<double>(short_of) / repetitions - expected) < 4 * sigma);
    CHECK(mean == Approx(static_cast<double>(rank) / (n + 1)).margin(1e-3));
}

TEST_CASE("scores of an answer, by hand", "[guarantee]")
{
    const auto answer = gap({{"backlash"}, {"compliance", "delay"}, {"compliance"}}, {0.5, 0.25, 0.125});
    CHECK(nonconformity(answer, "backlash") == 0.5);
    CHECK(nonconformity(answer, "compliance") == 0.625);  // acts in two of the three
    CHECK(nonconformity(answer, "delay") == 0.75);
    CHECK(nonconformity(answer, "viscous") == 1);
    CHECK(nonconformity(answer, none_of_these) == 0.875);
    CHECK(nonconformity(answer, no_gap) == 1);
    CHECK(nonconformity({.verdict = "no-gap"}, no_gap) == 0);
    // what concludes nothing excludes nothing; what failed excludes everything
    CHECK(nonconformity({.verdict = "insufficient-data"}, "viscous") == 0);
    CHECK(nonconformity({.verdict = "failed"}, none_of_these) == 1);
    // a case is as bad as the worst of the causes that act
    CHECK(nonconformity(answer, blind::Truth{.verdict = "gap", .effects = {"delay", "compliance"}}) == 0.75);
    // a name of the very same motion counts
    CHECK(nonconformity(
              answer, blind::Truth{.verdict = "gap", .effects = {"constant-load"}, .equivalent = {"backlash"}}) == 0.5);
    // so does a correction of a document that is off, and of no other
    blind::Truth off{.verdict = "no-gap", .equivalent = {"inertia", "viscous"}, .dirty = true};
    const auto numbers = gap({{"viscous", "inertia"}}, {0.75});
    CHECK(nonconformity(numbers, off) == 0.25);
    off.dirty = false;
    CHECK(nonconformity(numbers, off) == 1);
}

TEST_CASE("a set keeps what its threshold keeps, and what no case can exclude", "[guarantee]")
{
    const std::vector<std::string> catalogue{"backlash", "compliance", "delay"};
    Calibration c{.method = "m", .populations = {"p"}};
    // backlash is given 0.9 in 58 cases and 0.3 in one: its threshold is 0.7
    for (int i = 0; i < 59; ++i) c.cases.push_back(answered("backlash", gap({{"backlash"}}, {i == 7 ? 0.3 : 0.9}), i));
    const auto promise = promise_of(c, 0.95);
    REQUIRE(promise.kept);
    CHECK(promise.holds == CauseSet::Holds::every_cause);
    const auto clear = set_of(gap({{"compliance"}, {"backlash"}}, {0.8, 0.2}), promise, c, catalogue);
    CHECK(clear.names == std::vector<blind::EffectSet>{{"compliance"}, {"delay"}});
    CHECK(clear.uncalibrated == std::vector<std::string>{"compliance", "delay", no_gap, none_of_these});
    CHECK(clear.no_gap);
    CHECK(clear.none_of_these);
    const auto open = set_of(gap({{"compliance"}, {"backlash"}}, {0.6, 0.4}), promise, c, catalogue);
    CHECK(open.names == std::vector<blind::EffectSet>{{"compliance"}, {"backlash"}, {"delay"}});
}

TEST_CASE("too few of a cause leave a promise over the population; too few in all, none", "[guarantee]")
{
    const std::vector<std::string> catalogue{"backlash", "compliance", "delay"};
    Calibration c{.method = "m", .populations = {"p"}};
    for (int i = 0; i < 58; ++i)
        c.cases.push_back(answered(i % 2 ? "backlash" : "delay",
                                   gap({{"backlash"}, {"delay"}}, {i % 2 ? 0.9 : 0.1, i % 2 ? 0.1 : 0.9}), i));
    CHECK_FALSE(promise_of(c, 0.95).kept);
    CHECK(promise_of(c, 0.9).kept);
    c.cases.push_back(answered("delay", gap({{"backlash"}, {"delay"}}, {0.75, 0.25}), 58));
    const auto promise = promise_of(c, 0.95);
    REQUIRE(promise.kept);
    CHECK(promise.holds == CauseSet::Holds::population);
    CHECK(promise.threshold == 0.75);
    const auto set = set_of(gap({{"backlash"}, {"delay"}}, {0.7, 0.25}), promise, c, catalogue);
    CHECK(set.names == std::vector<blind::EffectSet>{{"backlash"}, {"delay"}});
    CHECK(holds(set, {.verdict = "gap", .effects = {"backlash", "delay"}}));
    CHECK_FALSE(holds(set, {.verdict = "gap", .effects = {"backlash", "compliance"}}));
    // of these there is no case, and the promise says nothing of them
    CHECK(set.uncalibrated == std::vector<std::string>{"compliance", no_gap, none_of_these});
    // an answer that concludes nothing excludes nothing
    const auto nothing = set_of({.verdict = "insufficient-data"}, promise, c, catalogue);
    CHECK(nothing.names == std::vector<blind::EffectSet>{{"backlash"}, {"compliance"}, {"delay"}});
}

TEST_CASE("fresh cases are covered as promised, over the population and for every cause", "[guarantee]")
{
    const std::vector<std::string> catalogue{"viscous", "backlash", "delay"};
    for (const int n : {59, 400}) {  // the first calibrates the population only, the second every cause
        SeededNoise noise(static_cast<std::uint64_t>(n));
        int covered = 0, fresh = 0, kept_short = 0;
        double size = 0;
        constexpr int calibrations = 200, each = 50;
        for (int i = 0; i < calibrations; ++i) {
            Calibration c{.method = "m", .populations = {"p"}};
            for (int k = 0; k < n; ++k) c.cases.push_back(drawn(noise, k));
            const auto promise = promise_of(c, 0.95);
            REQUIRE(promise.kept);
            CHECK(promise.holds == (n == 59 ? CauseSet::Holds::population : CauseSet::Holds::every_cause));
            int here = 0;
            for (int k = 0; k < each; ++k, ++fresh) {
                const auto one = drawn(noise, k);
                const auto set = set_of(one.answer, promise, c, catalogue);
                here += holds(set, one.truth);
                size += static_cast<double>(set.names.size());
            }
            covered += here;
            kept_short += here < each * 0.8;
        }
        const double share = static_cast<double>(covered) / fresh;
        CAPTURE(n, share, size / fresh);
        // ten thousand fresh cases: the expected coverage is at least rank / (n + 1) of the smallest group
        CHECK(share >= 0.95);
        CHECK(kept_short <= calibrations / 20);
    }
}

TEST_CASE("a joint that is unlike the calibration's is told so", "[guarantee]")
{
    Place one{
        .kind = "revolute single-mass, effort, pd", .columns = {"time", "position"}, .records = 2, .duration = 20};
    one.period = one.step = 1e-3, one.noise = 1e-4;
    Place two = one;
    two.duration = 40;
    const std::vector<Place> population{one, two};
    Place mine = one;
    mine.duration = 30;
    CHECK(strangers(mine, population).empty());
    mine.duration = 49;
    CHECK(strangers(mine, population).empty());  // up to a quarter beyond
    mine.duration = 51;
    REQUIRE(strangers(mine, population).size() == 1);
    CHECK(strangers(mine, population)[0].number == "duration");
    mine = one;
    mine.columns = {"time"};
    REQUIRE(strangers(mine, population).size() == 1);
    CHECK(strangers(mine, population)[0].why == Stranger::Why::columns);
    mine = one;
    mine.kind = "prismatic single-mass, effort, pd";
    REQUIRE(strangers(mine, population).size() == 1);
    CHECK(strangers(mine, population)[0].why == Stranger::Why::kind);
    mine = one;
    mine.noise = std::nan("");
    REQUIRE(strangers(mine, population).size() == 1);
    CHECK(strangers(mine, population)[0].number == "noise");
}

TEST_CASE("calibrations survive their file, and shards are one", "[guarantee]")
{
    Calibration c{.method = "m", .populations = {"seed 12"}, .joint = "j"};
    c.cases = {answered("backlash", gap({{"backlash"}, {"delay", "viscous"}}, {0.7, 0.2}), 0)};
    c.cases[0].place = {.kind = "k", .columns = {"time"}, .noise_documented = true, .records = 1, .duration = 2};
    const auto back = parse_calibration(calibration_json(c));
    CHECK(calibration_json(back) == calibration_json(c));
    CHECK(std::isnan(back.cases[0].place.period));
    Calibration other = c;
    other.cases[0].name = "another";
    merge(c, other);
    CHECK(c.cases.size() == 2);
    CHECK(c.populations == std::vector<std::string>{"seed 12"});
    other.populations = {"seed 1"};  // whose name is a part of the other's
    merge(c, other);
    CHECK(c.population() == "seed 12; seed 1");
    merge(c, other);
    CHECK(c.cases.size() == 2);  // a case counts once
    other.cases[0].answer.probabilities[0] = 0.6;
    CHECK_THROWS_AS(merge(c, other), std::invalid_argument);
    other.method = "n";
    CHECK_THROWS_AS(merge(c, other), std::invalid_argument);
    CHECK_THROWS_AS(parse_calibration("{}"), std::invalid_argument);
    CHECK_THROWS_AS(parse_calibration("[]"), std::invalid_argument);
}
