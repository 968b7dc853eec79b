// Backlash on a ladder of causes.
#include "analysis/diagnosis/fit/candidate_numbers.h"
#include "analysis/diagnosis/fit/joint_edits.h"
#include "analysis/diagnosis/ladder/fit_set.h"
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

TEST_CASE("a ladder looks for backlash before the encoder, too, where that alone came nearest behind it",
          "[gap][ladder][slow]")
{
    for (const double asymmetry : {0.0, 0.6}) {
        CAPTURE(asymmetry);
        LadderRecords records(test::Machine{}, {});
        records.simulate(with_play(asymmetry), {"backlash:divided-mass-encoder-on-link", "asymmetric-friction"});
        const auto set = records.search->climb({}, policy::ladder.most_rungs).last();
        const auto& effects = set.causes.effects;
        const auto backlash = std::ranges::find(effects, "backlash", &Effect::name) - effects.begin();
        REQUIRE(backlash < static_cast<std::ptrdiff_t>(effects.size()));
        CHECK(set.causes.forms[static_cast<std::size_t>(backlash)]->name == "divided-mass");
        CHECK(effects.size() == (asymmetry == 0 ? 1 : 2));
        const auto si = in_si(set.causes, set.of_causes(set.fit.x), records.scales);
        std::size_t first = 0;  // number of the backlash
        for (std::ptrdiff_t i = 0; i < backlash; ++i)
            first += set.causes.count_of(*set.causes.forms[static_cast<std::size_t>(i)]);
        CHECK(si[first] == Approx(width).epsilon(0.05));
    }
}

TEST_CASE(
    "beside the cause that hides backlash, fitted without it, the misfit over the width has its dip at the right one",
    "[gap][ladder]")
{
    Joint documented = test::nominal_joint();
    divide_mass(documented, 0.4, 3e5, 0.3, 0.3);
    Joint joint = documented;
    const auto& level = std::get<CoulombViscous>(documented.frictions.motor.law);
    joint.frictions.motor.law = Stribeck{level.coulomb, level.viscous, 1, 0.03};
    joint.mechanism.transmission.backlash = width;
    LadderRecords records(test::Machine{}, {});
    for (auto& c : records.cases) c.joint = documented;
    records.simulate(joint, {});
    const HeldOutData data(records.cases);
    const Corrections corrections(records.cases, records.scales, policy::correction_prior);
    SetFitter fitter(data, records.scales, corrections, policy::physical_ranges);
    fitter.renew();
    FittedSet none;
    none.model = corrections.beside({});
    none.fit.x = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(none.model.numbers));
    const Attribution backlash = records.single("backlash:two-mass");
    const Attribution peak = records.single("stribeck");
    const FittedSet below = fitter.fit(peak.candidate, fitter.start(peak.candidate, none, peak.x[ladder_level]));
    auto dips = fitter.dips(below, *backlash.candidate.effects[0], *backlash.candidate.forms[0], 1.15);
    REQUIRE(!dips.empty());
    std::ranges::stable_sort(dips, {}, &Start::objective);
    const auto si = in_si(corrections.beside(dips[0].causes).candidate, dips[0].x0, records.scales);
    CHECK(si.back() == Approx(width).epsilon(0.15));
}
