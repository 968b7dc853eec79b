// The exact step of a memory at constant speed against small steps of the law's own rate.
#include "analysis/friction/memory_step.h"

#include "analysis/friction/ageing.h"
#include "analysis/friction/rate_and_state.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace stickslip;

namespace {

constexpr double A = 1, B = 1.5, L = 1e-5, V_star = 1e-3;

const auto exponential = [](double x) { return std::exp(x); };
const auto logarithm = [](double x) { return std::log(x); };

template <class Law>
Law law_of()
{
    Law law;
    law.f0 = 60, law.A = A, law.V_star = V_star;
    law.B.push_back(B), law.L.push_back(L);
    return law;
}

/// Runge and Kutta's fourth order, so many steps.
template <class Law>
double integrated(const Law& law, double theta, double speed, double h, int steps)
{
    const auto rate = [&](double x) {
        States states{};
        states[0] = x;
        return law.respond(speed, states).rate[0];
    };
    const double dt = h / steps;
    for (int i = 0; i < steps; ++i) {
        const double a = rate(theta), b = rate(theta + 0.5 * dt * a), c = rate(theta + 0.5 * dt * b),
                     d = rate(theta + dt * c);
        theta += dt / 6 * (a + 2 * b + 2 * c + d);
    }
    return theta;
}

}  // namespace

TEST_CASE("the exact step of a memory is what its law's rate adds up to", "[friction]")
{
    for (const double speed : {1e-4, 1e-3, 2e-2})
        for (const double theta : {-0.8, 0.0, 1.7})
            for (const double slip : {0.01, 0.5, 4.0}) {
                const double h = slip * L / speed;
                INFO("speed " << speed << ", theta " << theta << ", slip " << slip);
                const double steady = -B * std::log(speed / V_star);
                CHECK(after_slip(theta, steady, slip, exponential) ==
                      Approx(integrated(law_of<RateAndState>(), theta, speed, h, 4000)).epsilon(1e-8).margin(1e-9));
                CHECK(after_ageing(theta, B, L, V_star, speed, h, slip, exponential, logarithm) ==
                      Approx(integrated(law_of<Ageing>(), theta, speed, h, 4000)).epsilon(1e-8).margin(1e-9));
            }
}

TEST_CASE("at rest contacts age and do not slip", "[friction]")
{
    const double age = L / V_star, h = 2.5;
    CHECK(after_ageing(0.0, B, L, V_star, 0.0, h, 0.0, exponential, logarithm) ==
          Approx(B * std::log((age + h) * V_star / L)));
    CHECK(after_slip(0.3, 0.7, 0.0, exponential) == 0.3);
}
