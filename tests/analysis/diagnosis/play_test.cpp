// Backlash on a ladder of causes.
#include "analysis/diagnosis/fit/candidate_numbers.h"
#include "analysis/diagnosis/fit/joint_edits.h"
#include "tests/analysis/diagnosis/ladder_search.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

constexpr double width = 1e-3;  // m

Joint with_play(double asymmetry)
{
    Joint joint = test::nominal_joint();
    joint.friction.asymmetry.coulomb = asymmetry;
    divide_mass(joint, 0.4, 3e5, 0.3, 0.3);
    joint.mechanism.transmission.backlash = width;
    return joint;
}

}  // namespace

TEST_CASE("a ladder looks for a play before the encoder, too, where it alone came nearest behind it",
          "[gap][ladder][slow]")
{
    for (const double asymmetry : {0.0, 0.6}) {
        CAPTURE(asymmetry);
        LadderRecords records(test::Machine{}, {});
        records.simulate(with_play(asymmetry), {"backlash:divided-mass-encoder-on-link", "asymmetric-friction"});
        const auto set = records.search->climb({}, policy::ladder.most_rungs).last();
        const auto& effects = set.causes.effects;
        const auto play = std::ranges::find(effects, "backlash", &Effect::name) - effects.begin();
        REQUIRE(play < static_cast<std::ptrdiff_t>(effects.size()));
        CHECK(set.causes.forms[static_cast<std::size_t>(play)]->name == "divided-mass");
        CHECK(effects.size() == (asymmetry == 0 ? 1 : 2));
        const auto si = in_si(set.causes, set.of_causes(set.fit.x), records.scales);
        std::size_t first = 0;  // number of the play
        for (std::ptrdiff_t i = 0; i < play; ++i)
            first += set.causes.count_of(*set.causes.forms[static_cast<std::size_t>(i)]);
        CHECK(si[first] == Approx(width).epsilon(0.05));
    }
}
