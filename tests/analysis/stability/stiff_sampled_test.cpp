// Sampled loops whose friction answers far faster than they tick: against multipliers with sixty digits.
#include "analysis/stability/real_loop.h"
#include "analysis/stability/stable_gains.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>

using namespace stickslip;

namespace {

/// The direct effect takes the velocity back `A T/(V m)` times within a tick.
struct Stiff {
    double inertia, V0, k_p, period, delay, A, B, L, growth;
};

// growth: mpmath with 60 digits, the monodromy put together apart from this project
constexpr Stiff stiff[] = {
    {0.0963216795740633, 3.724619129522709e-06, 591295.7163952077, 0.003274755441897392, 0.003274755441897392,
     1.1171218082491876, 1.6756827123737814, 1.3372653311680367e-06, -0.2785474},
    {0.02623691479952065, 1.4513301477971473e-06, 627172.1126440677, 0.0016424084441835035, 0.002463612666275255,
     3.036834389813053, 4.55525158471958, 3.7897480266869275e-06, -0.0540},
    {0.048838647239613474, 7.310083799597275e-07, 441990.73819869035, 0.0022635662245686534, 0.0022635662245686534,
     1.0585267089435155, 1.5877900634152733, 1.6447721288519968e-06, -0.0413},
    {0.17611785596585997, 2.909553275137595e-07, 50013.1381606989, 0.0055180672529859765, 0, 1.973302043207362,
     2.9599530648110433, 3.0185414889609698e-05, -0.00128},
};

}  // namespace

TEST_CASE("stiff friction in a slow loop has the multipliers of many digits", "[stability][sampled]")
{
    for (const Stiff& s : stiff) {
        Joint joint = ticked_joint(s.k_p);
        joint.mechanism.inertia = s.inertia;
        auto& c = joint.control;
        c.k_v = 1, c.V0 = s.V0, c.period = s.period, c.delay = s.delay;
        RateAndState law;
        law.f0 = 60, law.A = s.A, law.V_star = 1e-3;
        law.B.push_back(s.B), law.L.push_back(s.L);
        joint.friction.law = law;
        INFO("A T / (V m) = " << s.A * s.period / (s.V0 * s.inertia));
        const auto verdict = linear_verdict(joint);
        CHECK(verdict.state_variable.stable);
        CHECK(verdict.state_variable.spectral_abscissa == Approx(s.growth).epsilon(5e-3));
        CHECK(growth_rate(joint) == verdict.state_variable.spectral_abscissa);
    }
}
