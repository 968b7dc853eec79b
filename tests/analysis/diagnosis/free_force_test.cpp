#include "analysis/diagnosis/search/free_force.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "tests/analysis/diagnosis/small_machine.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

/// Two records of a machine, and the unmodelled forces that were fitted to them.
struct Fitted {
    std::vector<Case> cases;
    Scales scales;
    std::vector<FreeFit> fits;

    explicit Fitted(const test::Machine& m)
    {
        std::vector<Note> notes;
        for (unsigned seed : {1u, 2u}) {
            cases.push_back(prepare(test::record_of(m, seed), test::nominal_joint(), notes));
            cases.back().number = cases.size() - 1;
        }
        scales = scales_of(cases);
        fits = fit_free_forces({cases, scales, judge_nominal(cases), test::in_order});
    }

    const FreeFit& best() const { return fits.at(0); }
    FreeForce force() const
    {
        const Attribution& fit = best().fit;
        return edited_plant(cases[0].joint, fit.candidate, in_si(fit.candidate, fit.x[2], scales), 0).free;
    }
};

}  // namespace

TEST_CASE("a free force of position is a spline that holds every parabola", "[gap]")
{
    FreeForce f;
    f.from = -2, f.width = 0.5;
    const auto parabola = [](double q) { return 3 - 2 * q + 0.7 * q * q; };
    for (std::size_t i = 0; i < FreeForce::coefficients; ++i) {
        // the blossom of a parabola at the two knots of a coefficient
        const double a = f.from + f.width * (static_cast<double>(i) - 1), b = a + f.width;
        f.of_position[i] = 3 - (a + b) + 0.7 * a * b;
    }
    for (double q = -2; q < 2; q += 0.13) CHECK(f.at(q, 0) == Approx(parabola(q)));
}

TEST_CASE("a spring of no effect is found as a force of position, with its size", "[gap][slow]")
{
    test::Machine m;
    m.cubic = 2000;  // 2 N at the ends
    const Fitted fitted(m);
    REQUIRE(fitted.best().of == "position");
    CHECK(fitted.best().fit.explained > 0.99);
    const FreeForce f = fitted.force();
    for (double q = -0.07; q < 0.08; q += 0.01) CHECK(f.at(q, 0) == Approx(-m.cubic * q * q * q).margin(0.03));
}

TEST_CASE("drag with the square of speed is found as a force of velocity, with its size", "[gap][slow]")
{
    test::Machine m;
    m.drag = 40;
    const Fitted fitted(m);
    REQUIRE(fitted.best().of == "velocity");
    CHECK(fitted.best().fit.explained > 0.99);
    const FreeForce f = fitted.force();
    for (double v = -0.15; v < 0.16; v += 0.05) CHECK(f.at(0, v) == Approx(-m.drag * v * std::abs(v)).margin(0.02));
}

TEST_CASE("a spring that lags behind the position is found as a hysteresis, with its play and stiffness", "[gap][slow]")
{
    test::Machine m;
    m.bellows = 20, m.bellows_play = 0.012;  // 1.6 N at the ends
    const Fitted fitted(m);
    REQUIRE(fitted.best().of == "hysteresis");
    CHECK(fitted.best().fit.explained > 0.99);
    const FreeForce f = fitted.force();
    CHECK(f.play == Approx(m.bellows_play).epsilon(0.02));
    for (double q = -0.06; q < 0.07; q += 0.02) CHECK(f.at(q, 0) == Approx(-m.bellows * q).margin(0.03));
    // nothing that goes by the place alone comes near
    for (const auto& other : fitted.fits)
        if (other.of == "position") CHECK(clearly_better(fitted.best(), other.fit));
}

TEST_CASE("a hysteresis of another kind is nearer to a play than to any force of position", "[gap][slow]")
{
    test::Machine m;
    m.bellows = 20, m.bellows_play = 0.012, m.bellows_creeps = true;
    const Fitted fitted(m);
    REQUIRE(fitted.best().of == "hysteresis");
    REQUIRE(fitted.fits.size() == 4);
    CHECK(clearly_better(fitted.best(), fitted.fits[1].fit));
}

TEST_CASE("a force without a name beats a cause only by a clear part of what the cause leaves", "[gap]")
{
    const auto leaving = [](double misfit) {
        Attribution a;
        for (auto& e : a.evaluation) e.records = {{misfit, 1}};
        return a;
    };
    CHECK(clearly_better({"position", leaving(1.0)}, leaving(1.06)));
    CHECK_FALSE(clearly_better({"position", leaving(1.0)}, leaving(1.003)));
    CHECK_FALSE(clearly_better({"position", leaving(2.7)}, leaving(3.0)));
    CHECK(clearly_better({"position", leaving(1.5)}, leaving(3.0)));
    // what it gains may be the error of a known load
    CHECK_FALSE(clearly_better({"position", leaving(1.0), 0.07}, leaving(1.06)));
    CHECK(clearly_better({"position", leaving(1.0), 0.04}, leaving(1.06)));
}

TEST_CASE("a load that is picked up on the way is found as an inertia that changes, with its size", "[gap][slow]")
{
    test::Machine m;
    m.picked_up = 0.5;
    const Fitted fitted(m);
    REQUIRE(fitted.best().of == "inertia");
    CHECK(fitted.best().fit.explained > 0.95);
    const FreeForce f = fitted.force();
    for (const double t : {1.0, 1.5, 2.0}) CHECK(f.inertia_factor(t) == Approx(1).margin(0.05));
    for (const double t : {4.5, 5.0, 5.5}) CHECK(f.inertia_factor(t) == Approx(1.7 / 1.2).margin(0.05));
    for (const auto& other : fitted.fits)
        if (other.of != "inertia") CHECK(clearly_better(fitted.best(), other.fit));
}
