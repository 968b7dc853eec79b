#include "analysis/results/contradictions.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace stickslip;

namespace {

/// One cause that takes 80 % of a gap of 20 noise floors, beside corrections of 15 %.
Diagnosis answer()
{
    Diagnosis d;
    d.verdict = Verdict::gap;
    d.reasons = {{.code = Note::Code::cause_predicts_best, .names = {"stribeck"}}};
    d.effects.resize(2);
    d.effects[0].names = {"stribeck"}, d.effects[0].probability = 0.9;
    d.effects[1].names = {"presliding"}, d.effects[1].probability = 0.05;
    d.ladder.push_back({{"stribeck"}, 0.8, {}, {}, {}, 0.9});
    d.corrections.push_back({"inertia", {"inertia.factor", 1.03, 0.01, "1"}, 0.04});
    d.corrected_share = 0.15;
    d.ceiling.share = 0.97;
    d.remainder = {0.05, {"position"}};
    d.overall = {20, 4, 1, (400.0 - 16) / (400 - 1), {}, 0};
    return d;
}

bool finds(const Diagnosis& d, std::string_view what)
{
    const auto found = contradictions_in(d);
    return std::ranges::count(found, what) > 0;
}

}  // namespace

TEST_CASE("an answer whose numbers agree contradicts nothing", "[gap]")
{
    CHECK(contradictions_in(answer()).empty());
    CHECK(contradictions_in({}).empty());
}

TEST_CASE("an answer that contradicts its own numbers is found, each by what it contradicts", "[gap]")
{
    const auto with = [](auto change) {
        Diagnosis d = answer();
        change(d);
        return d;
    };
    CHECK(finds(with([](auto& d) { d.effects[1].probability = 0.2; }), "probabilities-exceed-one"));
    CHECK(finds(with([](auto& d) { d.effects[0].probability = 0.02; }), "first-cause-is-not-the-likeliest"));
    CHECK(finds(with([](auto& d) { d.ambiguous_with = {{"presliding"}}; }), "sure-beside-a-rival"));
    CHECK(finds(with([](auto& d) { d.ladder[0].probability = 1.2; }), "probability-of-a-rung"));
    CHECK(finds(with([](auto& d) { d.effects[0].names = {"viscous", "viscous"}; }), "a-cause-twice-in-a-set"));
    CHECK(finds(with([](auto& d) { d.corrected_share = 0.5; }), "shares-are-not-the-whole"));
    CHECK(finds(with([](auto& d) { d.ceiling.share = 0.6; }), "more-taken-than-explainable"));
    CHECK(finds(with([](auto& d) { d.remainder.share = 1.2; }), "remainder-is-no-share"));
    CHECK(finds(with([](auto& d) { d.overall.after = 30; }), "named-and-worse"));
    CHECK(finds(with([](auto& d) { d.overall.explained = 0.5; }), "explained-is-not-before-less-after"));
    CHECK(finds(with([](auto& d) { d.reasons[0].code = Note::Code::cause_to_noise; }), "structure-of-noise"));
    CHECK(finds(with([](auto& d) { d.reasons[0].code = Note::Code::within_noise; }), "within-noise-and-a-gap"));
    // "takes only 0 % of a gap of which 0 % are explainable" beside a ceiling of 0.9997
    const auto unknown = with([](Diagnosis& d) {
        d.verdict = Verdict::unknown;
        d.ladder.clear();
        d.effects[0].probability = 0.02, d.effects[1].probability = 0.01;
        d.corrected_share = 0.999, d.ceiling.share = 0.9997, d.remainder.share = 1;
        d.reasons = {{.code = Note::Code::takes_too_little, .names = {"stribeck"}, .values = {0.0002, 0.0007}}};
    });
    CHECK(finds(unknown, "too-little-of-nothing"));
    CHECK(finds(unknown, "unknown-though-mostly-taken"));
    CHECK(finds(unknown, "shares-are-not-the-whole"));
    CHECK(finds(with([](auto& d) { d.verdict = Verdict::unknown; }), "rungs-without-a-cause"));
    CHECK(finds(with([](auto& d) { d.verdict = Verdict::unknown; }), "likely-and-not-named"));
    // a ladder may stand without a cause only where the simulation of whole records got worse, and no rung is likely
    const auto withdrawn = [](double after, double probability) {
        Diagnosis d = answer();
        d.verdict = Verdict::unknown;
        d.reasons = {{.code = Note::Code::rejected_worse, .names = {"stribeck"}}};
        d.effects[0].probability = d.effects[1].probability = 0.05;
        d.ladder[0].probability = probability;
        d.overall = {20, after, 1, (400.0 - after * after) / (400 - 1), {}, 0};
        return d;
    };
    CHECK(contradictions_in(withdrawn(21, 0.1)).empty());
    CHECK(finds(withdrawn(21, 0.9), "rungs-without-a-cause"));
    CHECK(finds(withdrawn(4, 0.1), "rungs-without-a-cause"));
    CHECK(finds(withdrawn(4, 0.1), "unknown-though-mostly-taken"));
    CHECK(finds(withdrawn(4, 0.1), "withdrawn-as-worse-and-better"));
}
