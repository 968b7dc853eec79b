// Fits that go on side by side.
#include "analysis/diagnosis/fit/side_by_side.h"

#include "analysis/diagnosis/audit/audit.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/effects/catalogue.h"
#include "analysis/diagnosis/fit/candidate_numbers.h"
#include "analysis/diagnosis/fit/problem.h"
#include "analysis/diagnosis/search/search.h"
#include "tests/analysis/diagnosis/record_rows.h"
#include "tests/analysis/diagnosis/small_machine.h"

#include <catch2/catch.hpp>

#include <stdexcept>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

Candidate only(std::string_view name)
{
    const Effect* effect = effect_named(name);
    return {{effect}, {&effect->forms[0]}};
}

Fitting<int> one()
{
    co_return 1;
}

Fitting<int> fails()
{
    const int first = co_await one();
    if (first == 1) throw std::runtime_error("no");
    co_return first;
}

Fitting<int> awaits_failure()
{
    const int never = co_await fails();
    co_return never;
}

}  // namespace

TEST_CASE("a fit comes to the same bits alone and beside others", "[gap][lanes]")
{
    test::Machine m;
    m.viscous = 0.3, m.limit = 14;
    std::vector<Note> notes;
    const std::vector<Case> cases{prepare(test::record_of(m, 1, 4), test::nominal_joint(), notes)};
    const Scales scales = scales_of(cases);
    const Candidate viscous = only("viscous"), limit = only("saturation"), inertia = only("inertia");
    const auto all = [&] {
        std::vector<Fitting<LevelFit>> fits;
        fits.push_back(descending({cases, viscous, scales, levels[1]}, to_fit(viscous, {-0.1}), 6));
        fits.push_back(searching_rough({cases, limit, scales, levels[0]}, to_fit(limit, {1.0}), 20));
        fits.push_back(improving({cases, inertia, scales, levels[2]}, to_fit(inertia, {0.1}), 10, 4));
        return fits;
    };
    auto first = all();
    const auto together = side_by_side(all());
    for (std::size_t i = 0; i < first.size(); ++i) {
        const LevelFit by_itself = alone(std::move(first[i]));
        CAPTURE(i);
        CHECK(by_itself.x == together[i].x);
        CHECK(by_itself.evaluation.objective == together[i].evaluation.objective);
        CHECK(by_itself.evaluations == together[i].evaluations);
        CHECK(by_itself.evaluations > 2);
        // what it says it misses by is what is missed there
        const auto anew = evaluate(cases,
                                   i == 0   ? viscous
                                   : i == 1 ? limit
                                            : inertia,
                                   in_si(i == 0   ? viscous
                                         : i == 1 ? limit
                                                  : inertia,
                                         together[i].x, scales),
                                   i == 0   ? levels[1]
                                   : i == 1 ? levels[0]
                                            : levels[2]);
        CHECK(together[i].evaluation.objective == anew.objective);
    }
}

TEST_CASE("what a part of a fit throws reaches whoever waits for the fit", "[gap]")
{
    CHECK(alone(one()) == 1);
    CHECK_THROWS_AS(alone(awaits_failure()), std::runtime_error);
}

TEST_CASE("dear candidates are in groups of few, and begin first", "[gap]")
{
    using Groups = std::vector<std::vector<std::size_t>>;
    CHECK(in_groups(std::vector<double>{1, 1, 1, 1, 1}, 4) == Groups{{0, 1, 2, 3}, {4}});
    CHECK(in_groups(std::vector<double>{1, 10, 10, 1, 1}, 2) == Groups{{1}, {2}, {3, 4}, {0}});
    CHECK(in_groups({}, 3).empty());
    const Candidate spring = only("compliance"), viscous = only("viscous");
    CHECK(cost_of(spring) > 5 * cost_of(viscous));
}
