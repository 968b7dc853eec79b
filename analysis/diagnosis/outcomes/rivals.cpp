#include "analysis/diagnosis/outcomes/rivals.h"

#include <cmath>

namespace stickslip::gap {
namespace {

/// k_cr ≈ (B − A)/L at low velocity: that stiffness, the length L, and A in B − A are searched, in this order.
template <class Law>
FrictionLaw rate_and_state(const OutcomeScales& s, const double* x)
{
    Law law;
    const double length = s.length() * std::exp(x[1]);
    const double weakening = s.stiffness * length * std::exp(x[0]);
    law.f0 = s.level;
    law.A = weakening * std::exp(x[2]);
    law.B.push_back(law.A + weakening);
    law.L.push_back(length);
    law.V_star = s.velocity;
    return law;
}

template <class Law>
std::vector<double> rate_and_state_values(const FrictionLaw& law)
{
    const auto& l = std::get<Law>(law);
    return {l.A, l.B[0], l.L[0]};
}

Stribeck stribeck_of(const OutcomeScales& s, const double* x)
{
    Stribeck law;
    law.c3 = s.velocity * std::exp(x[0]);
    law.c2 = s.damping() * law.c3 * std::exp(x[1]);
    law.c1 = s.damping() * std::exp(x[2]);
    law.c0 = s.level;
    law.c4 = 2;
    return law;
}

std::vector<double> stribeck_values(const Stribeck& l)
{
    return {l.c2, l.c3, l.c1};
}

FrictionLaw lugre(const OutcomeScales& s, const double* x)
{
    LuGre law;
    law.stribeck_velocity = s.velocity * std::exp(x[0]);
    law.coulomb = s.level;
    law.breakaway = s.level + s.damping() * law.stribeck_velocity * std::exp(x[1]);
    law.sigma2 = s.damping() * std::exp(x[2]);
    law.sigma0 = s.stiffness * std::exp(x[3]);
    law.sigma1 = std::sqrt(law.sigma0 * s.inertia) * std::exp(x[4]);
    return law;
}

const std::vector<RivalNumber> memory_numbers{
    {"A", Quantity::effort, -5, 5}, {"B", Quantity::effort, -6, 6}, {"L", Quantity::position, -4, 4}};

const std::vector<RivalLaw> laws_in_order{
    {"coulomb-viscous",
     "viscous",
     false,
     {{"viscous", Quantity::damping, -6, 4}},
     [](const OutcomeScales& s, const double* x) -> FrictionLaw {
         return CoulombViscous{s.level, s.damping() * std::exp(x[0])};
     },
     [](const FrictionLaw& l) { return std::vector<double>{std::get<CoulombViscous>(l).viscous}; },
     -1,
     0.3},
    {"kinetic-static",
     "coulomb-level",
     false,
     {{"static_above_kinetic", Quantity::effort, -6, 6}},
     [](const OutcomeScales& s, const double* x) -> FrictionLaw {
         return KineticStatic{s.level, s.level + s.damping() * s.velocity * std::exp(x[0])};
     },
     [](const FrictionLaw& l) {
         return std::vector<double>{std::get<KineticStatic>(l).breakaway - std::get<KineticStatic>(l).kinetic};
     },
     -1,
     0.1},
    {"stribeck",
     "stribeck",
     false,
     {{"c2", Quantity::effort, -5, 4}, {"c3", Quantity::velocity, -5, 4}, {"c1", Quantity::damping, -9, 3}},
     [](const OutcomeScales& s, const double* x) -> FrictionLaw { return stribeck_of(s, x); },
     [](const FrictionLaw& l) { return stribeck_values(std::get<Stribeck>(l)); },
     -1,
     0.1},
    {"rate-and-state", "frictional-memory", true, memory_numbers, rate_and_state<RateAndState>,
     rate_and_state_values<RateAndState>, 1, 1},
    {"ageing", "frictional-memory", true, memory_numbers, rate_and_state<Ageing>, rate_and_state_values<Ageing>, 1, 1},
    {"time-lag",
     "frictional-memory",
     true,
     {{"c2", Quantity::effort, -5, 4},
      {"c3", Quantity::velocity, -5, 4},
      {"c1", Quantity::damping, -9, 3},
      {"lag", Quantity::time, -5, 3}},
     [](const OutcomeScales& s, const double* x) -> FrictionLaw {
         return TimeLag{std::exp(x[3]) / s.omega(), {stribeck_of(s, x)}};
     },
     [](const FrictionLaw& l) {
         auto values = stribeck_values(std::get<Stribeck>(std::get<TimeLag>(l).curve.law));
         values.push_back(std::get<TimeLag>(l).lag);
         return values;
     },
     -1,
     0.02},
    {"lugre",
     "presliding",
     true,
     {{"static_above_coulomb", Quantity::effort, -5, 4},
      {"stribeck_velocity", Quantity::velocity, -5, 4},
      {"sigma2", Quantity::damping, -9, 3},
      {"sigma0", Quantity::stiffness, -3, 6},
      {"sigma1", Quantity::damping, -5, 2}},
     lugre,
     [](const FrictionLaw& law) {
         const auto& l = std::get<LuGre>(law);
         return std::vector<double>{l.breakaway - l.coulomb, l.stribeck_velocity, l.sigma2, l.sigma0, l.sigma1};
     },
     -1,
     1},
};

}  // namespace

double OutcomeScales::omega() const
{
    return std::sqrt(stiffness / inertia);
}
double OutcomeScales::length() const
{
    return velocity / omega();
}
double OutcomeScales::damping() const
{
    return std::sqrt(stiffness * inertia);
}

std::span<const RivalLaw> rival_laws()
{
    return laws_in_order;
}

}  // namespace stickslip::gap
