// What the memory of rate-and-state friction is after a step at constant speed, exactly. For one number and for packs
// of them (base/select.h): whoever steps brings the exponential and the logarithm of its kind of number.
#pragma once
#include "analysis/base/select.h"

namespace stickslip {

/// Added to the speed inside the logarithms of the memory, as a part of V*: what keeps them finite at rest.
inline constexpr double memory_floor = 1e-3;

/// Slip law: θ approaches its steady state θ_ss = −B ln(|v|/V*) over the slip: θ_ss + (θ − θ_ss) e^{−|v| h/L}.
template <class P, class Exponential>
P after_slip(const P& theta, const P& steady, const P& slip_per_L, const Exponential& exponential)
{
    return steady + (theta - steady) * exponential(-slip_per_L);
}

/// Ageing law, in terms of the age Θ: θ = B ln(Θ V*/L), Θ̇ = 1 − |v| Θ/L, of a body at `speed` for h.
template <class P, class Exponential, class Logarithm>
P after_ageing(const P& theta, const P& B, const P& L, const P& V_star, const P& speed, const P& h, const P& slip_per_L,
               const Exponential& exponential, const Logarithm& logarithm)
{
    constexpr double least_slip = 1e-12;  // below, the age is all that grows
    const P age = L / V_star * exponential(theta / B), lasts = L / speed;
    const P next = select(P(least_slip) < slip_per_L, lasts + (age - lasts) * exponential(-slip_per_L), age + h);
    return B * logarithm(next * V_star / L);
}

}  // namespace stickslip
