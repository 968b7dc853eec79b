// Answers written and read back, number for number.
#include "analysis/results/point.h"
#include "sweep/files/json/answer_fields.h"

#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <limits>
#include <typeinfo>
#include <utility>

using namespace stickslip;

namespace {

/// The same bits, NaN included.
bool same(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

template <class T>
T through_text(const T& value)
{
    const auto text = archive::written(value).dump();
    T back;
    archive::read(archive::Json::parse(text), back);
    return back;
}

}  // namespace

TEST_CASE("numbers survive the file bit by bit, those that JSON lacks included", "[answer]")
{
    constexpr double inf = std::numeric_limits<double>::infinity();
    Samples line{{0.1, 1 / 3.0, 5e-324, -0.0, inf}, {missing, -inf, 1.7976931348623157e308, 1e-300, 55e3}};
    const auto back = through_text(line);
    REQUIRE(back.x.size() == line.x.size());
    for (std::size_t i = 0; i < line.x.size(); ++i) {
        CHECK(same(back.x[i], line.x[i]));
        CHECK(same(back.y[i], line.y[i]));
    }
}

TEST_CASE("an answer comes back whole: lists, options, codes, texts that live elsewhere", "[answer]")
{
    JointAnswer answer;
    answer.linear.state_variable.eigenvalues = {{-1, 2}, {-1, -2}};
    answer.linear.state_variable.stable_intervals = {{55e3, std::numeric_limits<double>::infinity()}};
    answer.nonlinear.outcome = Outcome::period_n;
    answer.nonlinear.reason = Reason::diverges;
    answer.nonlinear.detail = Detail::larger_not_followed;
    answer.nonlinear.searched_from = LargerTried::swings;
    answer.region = Region::bistable;
    answer.details.ramps.emplace()[1].here = {{1, 2}};
    answer.locus.emplace().roots = {{{1, 0}}, {{2, 0}}};
    const auto back = through_text(answer);
    CHECK(back.linear.state_variable.eigenvalues == answer.linear.state_variable.eigenvalues);
    CHECK(std::isinf(back.linear.state_variable.stable_intervals.at(0).high));
    CHECK(back.nonlinear.outcome == Outcome::period_n);
    CHECK(back.nonlinear.reason == Reason::diverges);
    CHECK(back.nonlinear.detail == Detail::larger_not_followed);
    CHECK(back.nonlinear.searched_from == LargerTried::swings);
    CHECK(back.region == Region::bistable);
    CHECK_FALSE(back.nearest);
    CHECK(back.details.ramps->at(1).here.at(0).high == 2);
    CHECK(back.locus->roots == answer.locus->roots);
    CHECK(archive::written(back) == archive::written(answer));
}

namespace {

/// Becomes anything that an aggregate begins with.
struct Anything {
    template <class T>
    operator T() const;
};
template <std::size_t>
using Each = Anything;

template <class T, std::size_t... i>
constexpr bool made_of(std::index_sequence<i...>)
{
    return requires
    {
        T{Each<i>{}...};
    };
}

/// How many members an aggregate has.
template <class T, std::size_t n = 40>
constexpr std::size_t members()
{
    if constexpr (n == 0 || made_of<T>(std::make_index_sequence<n>{}))
        return n;
    else
        return members<T, n - 1>();
}

template <class T>
void check_complete()
{
    CAPTURE(typeid(T).name());
    CHECK(archive::written(T{}).size() == members<T>());
}

}  // namespace

TEST_CASE("every member of every struct of an answer is written", "[answer]")
{
    // a new member that its list of fields forgets would be missing from pages drawn again
    check_complete<LinearVerdict>();
    check_complete<SteadySliding>();
    check_complete<VelocityOnlyVerdict>();
    check_complete<StateVariableVerdict>();
    check_complete<LoopUse>();
    check_complete<NonlinearVerdict>();
    check_complete<LinearStudy>();
    check_complete<StableVelocities>();
    check_complete<Comparison>();
    check_complete<LoopMargins>();
    check_complete<ReductionStudy>();
    check_complete<LinearDetails>();
    check_complete<RootLocus>();
    check_complete<JointAnswer>();
    check_complete<NearestBoundary>();
    check_complete<Margin>();
    check_complete<BoundaryPoint>();
    check_complete<Curve>();
    check_complete<MapAnswer>();
    check_complete<LargeDisturbances>();
    check_complete<GainSurface>();
    check_complete<SweepAnswer>();
}

TEST_CASE("an answer that lacks a field, or has another thing in its place, says where", "[answer]")
{
    auto json = archive::written(JointAnswer());
    json["linear"]["steady"].erase("friction");
    JointAnswer answer;
    CHECK_THROWS_WITH(archive::read(json, answer), "linear: steady: lacks \"friction\"");
    json["linear"]["steady"]["friction"] = "much";
    CHECK_THROWS_WITH(archive::read(json, answer), "linear: steady: friction: is not a number");
}
