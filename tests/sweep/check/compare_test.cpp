// What counts as a regression, and what as a refinement.
#include "sweep/check/baseline_file.h"
#include "sweep/check/boundaries.h"
#include "sweep/files/spec_file.h"

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
constexpr const char* strip = R"(
title = "strip"
[joint]
motion = "prismatic"
model = "single-mass"
inertia = 1.0
[control]
kind = "position"
k_p = 2.2e4
k_v = 47.5
V0 = 1.0e-2
[friction]
law = "rate-and-state"
f0 = 60.0
A = 1.0
B = 1.5
L = 1.0e-5
V_star = 1.0e-3
[axes]
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
    CHECK(compare({at(1, 1e-6, 1e-6)}, {})[0].kind == Kind::vanished);
    CHECK(compare({}, {at(1, 1e-6, 1e-6)})[0].kind == Kind::appeared);
    for (const auto kind : {Kind::within, Kind::refined, Kind::moved, Kind::coarser, Kind::vanished, Kind::appeared}) {
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
    const Spec spec = read_spec_text(std::string(strip) + "[check]\ntolerance = 0.01\n", "strip");
    for (const auto& w : watched_boundaries(spec, forwards)) CHECK(w.tolerance == 0.01);
}
