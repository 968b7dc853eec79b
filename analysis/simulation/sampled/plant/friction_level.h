// The level of a friction law, which place, time and load add to. Internal to
// analysis/simulation/sampled/plant.
#pragma once
#include "analysis/friction/friction.h"

#include <algorithm>
#include <variant>

namespace stickslip {

/// The numbers of a law that place, time and load add to.
template <class Take>
bool with_levels(FrictionLaw& law, Take&& take)
{
    return std::visit(
        [&](auto& l) {
            if constexpr (requires { l.c0; })
                return take(l.c0), true;
            else if constexpr (requires { l.kinetic; })
                return take(l.kinetic), take(l.breakaway), true;
            else if constexpr (requires { l.breakaway; })
                return take(l.coulomb), take(l.breakaway), true;
            else if constexpr (requires { l.coulomb; })
                return take(l.coulomb), true;
            else if constexpr (requires { l.f0; })
                return take(l.f0), true;
            else
                return false;
        },
        law);
}

/// No law has a level below zero.
inline void raise(FrictionLaw& law, double by)
{
    with_levels(law, [by](double& level) { level = std::max(0.0, level + by); });
}

/// Whether a contact's sinh is so steep that it turns round at speeds which no motion has.
inline bool is_steep_contact(const Friction& f)
{
    constexpr double steep = 41;  // e to it, 1e18
    if (f.has_bristle()) return false;
    if (f.has_memory() && f.memory.A > 0)
        return info(f.law).set_valued_at_rest && static_force(f.law) > steep * f.memory.A;
    const auto* law = std::get_if<RateAndStateRegularised>(&f.law);
    return law && law->A > 0 && law->f0 > steep * law->A;
}

}  // namespace stickslip
