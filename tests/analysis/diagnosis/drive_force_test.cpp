#include "analysis/diagnosis/heldout/drive_force.h"
#include "analysis/diagnosis/audit/prepare.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

constexpr double T = 1e-3, mass = 2;

Joint free_mass()
{
    Joint j;
    j.mechanism.inertia = mass;
    CoulombViscous law;
    law.coulomb = law.viscous = 0;
    j.friction.law = law;
    j.control.k_p = 1;
    j.control.period = T;
    return j;
}

/// A record of a free mass under a force that changes every tick and that nobody logged: parabolas, in closed form.
Case unlogged_force(const std::function<double(double)>& force)
{
    Record r;
    double q = 0, v = 0;
    for (int k = 0; k < 4000; ++k) {
        r.time.push_back(k * T);
        r.position.push_back(q);
        r.effort_command.push_back(0);
        const double a = force(k * T) / mass;
        q += v * T + 0.5 * a * T * T;
        v += a * T;
    }
    std::vector<Note> notes;
    return prepare(r, free_mass(), notes);
}

}  // namespace

TEST_CASE("the missing force is the force that nobody logged, below the corner, without a shift in time", "[gap]")
{
    const auto push = [](double t) { return 3 + std::sin(2 * M_PI * 10 * t); };
    const auto force = missing_force(unlogged_force(push), free_mass(), 100);
    double worst = 0;
    for (int n = 1000; n < 3000; ++n)
        worst = std::max(worst, std::abs(force[static_cast<std::size_t>(n)] - 0.5 * (push((n - 1) * T) + push(n * T))));
    CHECK(worst < 1e-3);
    CHECK(std::isnan(force.front()));
    CHECK(std::isnan(force.back()));
}

TEST_CASE("above the corner the missing force is not seen", "[gap]")
{
    // (f/corner)^8 = 3^8 after both ways of a fourth order
    const auto force =
        missing_force(unlogged_force([](double t) { return std::sin(2 * M_PI * 300 * t); }), free_mass(), 100);
    double largest = 0;
    for (int n = 1000; n < 3000; ++n) largest = std::max(largest, std::abs(force[static_cast<std::size_t>(n)]));
    CHECK(largest < 1e-3);
}
