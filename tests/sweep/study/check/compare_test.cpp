// What counts as a regression, and what as a refinement.
#include "sweep/files/json/baseline_file.h"
#include "sweep/files/toml/spec_file.h"
#include "sweep/study/check/boundaries.h"

#include "tests/example_joint.h"

#include <catch2/catch.hpp>

using namespace stickslip;

namespace {

const ParallelFor forwards = [](std::size_t n, const std::function<void(std::size_t)>& task) {
    for (std::size_t i = 0; i < n; ++i) task(i);
};
const ParallelFor backwards = [](std::size_t n, const std::function<void(std::size_t)>& task) {
    for (std::size_t i = n; i-- > 0;) task(i);
};

WatchedBoundary at(double value, double bracket, double tolerance)
{
    WatchedBoundary w;
    w.theory = "fold", w.axis = "control.k_p", w.unit = "N/m";
    w.point = {value, value * (1 - bracket / 2), value * (1 + bracket / 2), -1, true, 9};
    w.tolerance = tolerance;
    return w;
}

Deviation::Kind compared(const WatchedBoundary& stored, const WatchedBoundary& now)
{
    const auto all = compare({stored}, {now});
    REQUIRE(all.size() == 1);
    return all[0].kind;
}

/// One chart of the bistable strip, small enough for a test; at 10 mm/s with a disturbance of 20 slip distances.
const std::string strip = "title = \"strip\"\n" + example_joint_text(1, 2.2e4, 47.5, 1e-2) + R"([axes]
"control.k_p" = { from = 1.5e4, to = 3e4, points = 5 }
[nonlinear]
enabled = true
)";

}  // namespace

TEST_CASE("a boundary may move within its tolerance, and be refined", "[check]")
{
    using Kind = Deviation::Kind;
    CHECK(compared(at(1, 1e-6, 4e-6), at(1 + 3e-6, 1e-6, 4e-6)) == Kind::within);
    CHECK(compared(at(1, 1e-6, 4e-6), at(1 + 5e-6, 1e-6, 4e-6)) == Kind::moved);
    CHECK(compared(at(1, 1e-6, 4e-6), at(1 + 3e-7, 1e-9, 4e-9)) == Kind::refined);
    CHECK(compared(at(1, 1e-6, 4e-6), at(1 + 5e-6, 1e-9, 4e-9)) == Kind::moved);
    CHECK(compared(at(1, 1e-6, 4e-6), at(1, 1e-3, 4e-3)) == Kind::coarser);
    auto other_unit = at(1, 1e-6, 4e-6), other_side = other_unit;
    other_unit.unit = "kN/m", other_side.point.direction = 1;
    CHECK(compared(other_unit, at(1, 1e-6, 4e-6)) == Kind::changed);
    CHECK(compared(other_side, at(1, 1e-6, 4e-6)) == Kind::changed);
    CHECK(compare({at(1, 1e-6, 1e-6)}, {})[0].kind == Kind::vanished);
    CHECK(compare({}, {at(1, 1e-6, 1e-6)})[0].kind == Kind::appeared);
    for (const auto kind :
         {Kind::within, Kind::refined, Kind::moved, Kind::changed, Kind::coarser, Kind::vanished, Kind::appeared}) {
        Deviation d;
        d.kind = kind, d.stored = d.now = at(1, 1e-6, 1e-6);
        CHECK(d.passes() == (kind == Kind::within || kind == Kind::refined));
        CHECK_FALSE(describe(d).empty());
    }
}

TEST_CASE("folds are watched where nonlinear outcomes are, in an order that no thread changes", "[check]")
{
    const Spec spec = read_spec_text(strip, "strip");
    const auto one = watched_boundaries(spec, forwards), other = watched_boundaries(spec, backwards);
    REQUIRE(one.size() == 2);
    CHECK(one[0].theory == "state_variable");
    CHECK(one[0].point.value == Approx(19449).epsilon(1e-4));
    CHECK(one[0].tolerance == 1e-9);
    CHECK(one[1].theory == "fold");
    CHECK(one[1].point.value == Approx(24849).epsilon(1e-4));
    CHECK(one[1].tolerance < 1e-5);
    REQUIRE(other.size() == one.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
        CHECK(other[i].name() == one[i].name());
        CHECK(other[i].point.value == one[i].point.value);
    }
}

TEST_CASE("a stated tolerance holds for every kind", "[check]")
{
    const Spec spec = read_spec_text(strip + "[check]\ntolerance = 0.01\n", "strip");
    for (const auto& w : watched_boundaries(spec, forwards)) CHECK(w.tolerance == 0.01);
}

TEST_CASE("outcomes are watched where a disturbance has a size, to their own precision", "[check]")
{
    const Spec spec = read_spec_text(strip + "disturbance = { kind = \"position\", size = 2e-4 }\n", "strip");
    std::vector<WatchedBoundary> outcomes;
    for (const auto& w : watched_boundaries(spec, forwards))
        if (w.theory == "outcome") outcomes.push_back(w);
    REQUIRE(outcomes.size() == 1);
    // continuation and simulation: the cycle persists at 24840 and decays at 24860 N/m
    CHECK(outcomes[0].point.value == Approx(24850).margin(10));
    CHECK(outcomes[0].point.precision() <= 1e-4);
    CHECK(outcomes[0].tolerance == Approx(4 * outcomes[0].point.precision()));
}

TEST_CASE("the least velocity is watched where the velocity is an axis", "[check]")
{
    std::string text = strip;
    text.replace(text.find("\"control.k_p\" ="), text.find("[nonlinear]") - text.find("\"control.k_p\" ="),
                 "\"control.V0\" = { from = 1e-3, to = 1.05e-2, points = 5, scale = \"log\" }\n");
    text.erase(text.find("[nonlinear]"));
    std::vector<WatchedBoundary> least;
    for (const auto& w : watched_boundaries(read_spec_text(text, "strip"), forwards))
        if (w.theory == "v_min") least.push_back(w);
    REQUIRE(least.size() == 1);
    CHECK(least[0].axis == "control.V0");
    CHECK(least[0].tolerance == 1e-9);
    // k_p = (0.5 − 47.5 V)/L (1 + V/(L (47.5 + 1/V)))
    const double V = least[0].point.value;
    CHECK((0.5 - 47.5 * V) / 1e-5 * (1 + V / (1e-5 * (47.5 + 1 / V))) == Approx(2.2e4).epsilon(1e-8));
}
