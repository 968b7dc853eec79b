// Maxwell slip: elements in parallel, each a spring that slips at its own yield force.
#pragma once
#include <algorithm>
#include <string>

#include "analysis/friction/stribeck.h"

namespace stickslip {

/// One element: it carries at most its yield force.
struct SlipElement {
    double stiffness = not_set, yield = not_set;

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number({"stiffness", Quantity::stiffness, positive, Need::required, "stiffness of the element"},
                     self.stiffness);
        visit.number({"yield", Quantity::effort, positive, Need::required, "force at which the element slips"},
                     self.yield);
    }
};

/// f = Σ F_i + F_v V. An element sticks as a spring, Ḟ_i = k_i V, and slips towards its level W_i r(V), W_i its yield
/// force:
///   Ḟ_i = sgn V · min(k_i |V|, C (W_i − F_i sgn V / r(V)) / ΣW),   r(V) = 1 + (static_ratio − 1) exp(−(V/v_s)²)
/// Without a finite attraction C the slipping element stays at W_i: the classical model, rate-independent but for F_v.
/// With it this is the generalised Maxwell slip, whose slip level follows a Stribeck curve with a lag; the published
/// form switches from sticking to slipping when |F_i| reaches the yield force, here where both rates agree, so that no
/// hidden mode is needed. Source: Iwan (1966); Lampaert, Al-Bender & Swevers (2003).
struct MaxwellSlip {
    ShortList<SlipElement, max_states> elements{};
    double viscous = 0;
    double attraction = infinity;  ///< C, force per time
    double static_ratio = 1;       ///< slip level at rest over slip level in fast sliding
    double stribeck_velocity = 1;  ///< v_s

    static constexpr LawInfo info{
        .name = "maxwell-slip",
        .formula = "f = sum F_i + viscous V, F_i' = k_i V while sticking, slipping at yield_i",
        .source = "Iwan 1966; Lampaert, Al-Bender & Swevers 2003",
        .validity = "all velocities; hysteresis without drift",
        .steady_state_dependence = true,
        .direct_effect = true,
        .odd = true,
    };

    int states() const { return elements.size; }
    double steady_force(double V) const
    {
        return V == 0 ? 0 : std::copysign(total_yield() * ratio(V).value, V) + viscous * V;
    }
    States steady_state(double V) const
    {
        States forces{};
        for (int i = 0; i < elements.size; ++i)
            forces[i] = V == 0 ? 0 : std::copysign(elements[i].yield * ratio(V).value, V);
        return forces;
    }

    FrictionResponse respond(double V, const States& forces) const
    {
        const double direction = std::copysign(1.0, V), total = total_yield();
        const auto level = ratio(V);
        FrictionResponse r;
        r.force = viscous * V;
        r.by_velocity = viscous;
        for (int i = 0; i < elements.size; ++i) {
            const auto& e = elements[i];
            const double carried = forces[i] * direction;
            const double reserve = (e.yield - carried / level.value) / total;
            const double sticking = e.stiffness * std::abs(V);
            r.force += forces[i];
            r.by_state[i] = 1;
            if (reserve > 0 && sticking <= attraction * reserve) {
                r.rate[i] = direction * sticking;
                r.rate_by_velocity[i] = e.stiffness;
            } else if (attraction < infinity) {
                r.rate[i] = direction * attraction * reserve;
                r.rate_by_velocity[i] = attraction * carried * level.slope / (level.value * level.value * total);
                r.rate_by_state[i] = -attraction / (level.value * total);
            }
        }
        return r;
    }

    std::string problem() const
    {
        if (elements.size == 0) return "elements needs at least one { stiffness, yield }";
        return static_ratio != 1 && attraction == infinity ? "static_ratio needs a finite attraction" : "";
    }

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.rows("elements", "springs that slip at their yield force", self.elements);
        visit.number(Field{"viscous", Quantity::damping, not_negative, Need::optional, "viscous friction"}.called(
                         "F_{v}", "viscous friction"),
                     self.viscous);
        visit.number({"attraction", Quantity::effort_rate, positive, Need::optional,
                      "generalised form: how fast a slipping element approaches its level"},
                     self.attraction);
        visit.number({"static_ratio", Quantity::number, Range{1, infinity, false, true}, Need::optional,
                      "slip level at rest over slip level in fast sliding"},
                     self.static_ratio);
        visit.number(
            Field{"stribeck_velocity", Quantity::velocity, positive, Need::optional, "Stribeck velocity"}.called(
                "v_{s}", "Stribeck velocity"),
            self.stribeck_velocity);
    }

  private:
    double total_yield() const
    {
        double sum = 0;
        for (const auto& e : elements) sum += e.yield;
        return sum;
    }
    Level ratio(double V) const { return Stribeck{1, 0, static_ratio - 1, stribeck_velocity, 2}.level(std::abs(V)); }
};

}  // namespace stickslip
