// A small term of machines that was taken out of a ladder is no rival of what stays in it.
#include "analysis/diagnosis/policy/ladder.h"
#include "analysis/diagnosis/policy/ladder_verdict.h"
#include "analysis/diagnosis/verdict/judge_ladder.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

FittedSet set_of(std::initializer_list<const char*> names, double misfit)
{
    FittedSet set;
    for (const char* name : names) {
        set.causes.effects.push_back(effect_named(name));
        set.causes.forms.push_back(&set.causes.effects.back()->forms[0]);
    }
    for (auto& fold : set.left) fold.push_back({0, 0, 200, 1.0});
    set.misfit = misfit;
    return set;
}

}  // namespace

TEST_CASE("a small term that was dropped does not speak against the causes that stay", "[gap][ladder]")
{
    JudgedLadder j;
    j.ladder.rungs = {set_of({"stribeck"}, 0.5), set_of({"stribeck", "delay"}, 0.2)};
    const double margin = margin_of(j.ladder.rungs[1], policy::ladder);
    j.ladder.rivals.resize(2);
    j.ladder.rivals[1] = {set_of({"stribeck", "cogging"}, 0.2 - margin),
                          set_of({"stribeck", "backlash"}, 0.2 + margin)};
    j.noise_left = true;
    j.shares.documented = j.shares.base = 1;
    j.shares.rungs = {0.4, 0};

    CHECK(odds_of_rivals(j, 1)[0] == 1);
    j.dropped = {effect_named("cogging")};
    CHECK(odds_of_rivals(j, 1)[0] == 0);
    CHECK(odds_of_rivals(j, 1)[1] == Approx(std::exp(-1)));
    CHECK(chances_of(j)[1] == Approx((1 - policy::doubt_of_noise) / (1 + std::exp(-1))));
}
