#include "analysis/friction/steep_contact.h"

#include <cmath>

namespace stickslip {
namespace {

constexpr double narrow = 1e-8;  ///< core per velocity: the tolerance to which motions are followed

DirectContact contact_of(double A, double V_star, double level, double normal_load)
{
    return {A * normal_load, 2 * V_star * std::exp(-level / A)};
}

}  // namespace

DirectContact direct_contact(const Friction& f, double V)
{
    if (f.has_bristle() || f.has_lag()) return {};
    const double theta = f.has_memory() ? steady_state(f, V)[states(f.law)] : 0;
    if (f.has_memory()) {
        if (!(f.memory.A > 0) || !info(f.law).set_valued_at_rest) return {};
        return contact_of(f.memory.A, f.memory.V_star, std::abs(steady_force(f.law, V)) + theta, f.normal_load);
    }
    const auto* law = std::get_if<RateAndStateRegularised>(&f.law);
    if (!law || !(law->A > 0)) return {};
    double level = law->f0;
    for (const double state : law->steady_state(V)) level += state;
    return contact_of(law->A, law->V_star, level, f.normal_load);
}

bool is_steep(const DirectContact& contact, double V)
{
    return contact.core < narrow * std::abs(V);
}

bool is_steep_contact(const Friction& friction)
{
    constexpr double steep = 41;  // e to it, 1e18
    if (friction.has_bristle()) return false;
    if (friction.has_memory() && friction.memory.A > 0)
        return info(friction.law).set_valued_at_rest && static_force(friction.law) > steep * friction.memory.A;
    const auto* law = std::get_if<RateAndStateRegularised>(&friction.law);
    return law && law->A > 0 && law->f0 > steep * law->A;
}

States rested(const Friction& friction, const States& theta, double time)
{
    const auto still = respond(friction, 0, theta);
    States older = theta;
    // θ̇ = r e^{−(θ − θ_0)/B} of the ageing law, whose ∂θ̇/∂θ is −r/B; 0 of the slip law
    for (int i = 0; i < states(friction); ++i)
        if (still.rate_by_state[i] < 0)
            older[i] -= still.rate[i] / still.rate_by_state[i] * std::log1p(-still.rate_by_state[i] * time);
    return older;
}

}  // namespace stickslip
