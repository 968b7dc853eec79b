// The Stribeck curve: friction that depends on the present velocity only.
#pragma once
#include <cmath>

#include "analysis/friction/response.h"

namespace stickslip {

/// f(V) = (c0 + c1 |V| + c2 exp(−(|V|/c3)^c4)) sgn V                                    (7); c4 = 2 gives (22).
/// At rest: any force within ±(c0 + c2). High speed: c0 + c1 |V|.
/// Source: Dupont (1991), eqs. (7), (22)-(26); exponential form after Tustin and Bo & Pavelescu.
struct Stribeck {
    double c0 = not_set;  ///< Coulomb level
    double c1 = not_set;  ///< viscous slope
    double c2 = not_set;  ///< static level above Coulomb; may be 0
    double c3 = not_set;  ///< Stribeck velocity
    double c4 = 2;        ///< exponent

    static constexpr LawInfo info{
        .name = "stribeck",
        .formula = "f = (c0 + c1 |V| + c2 exp(-(|V|/c3)^c4)) sgn V",
        .source = "Dupont 1991, (7) and (22)",
        .validity = "all velocities; at V = 0 any force within ±(c0 + c2)",
        .steady_state_dependence = true,
        .set_valued_at_rest = true,
        .odd = true,
        .dissipative = true,
    };

    int states() const { return 0; }
    States steady_state(double) const { return {}; }
    double static_force() const { return c0 + c2; }
    double steady_force(double V) const { return respond(V, {}).force; }
    FrictionResponse respond(double V, const States&) const { return slide(level(std::abs(V)), c1, V); }

    /// c0 + c2 exp(−u), u = (|V|/c3)^c4, and its slope −c2 c4 u exp(−u)/|V|: (23) for a general exponent
    Level level(double speed) const
    {
        const double power = std::pow(speed / c3, c4);
        const double bump = c2 * std::exp(-power);
        return {c0 + bump, speed == 0 ? -slope_at_rest() : -bump * c4 * power / speed};
    }

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number(Field{"c0", Quantity::effort, not_negative, Need::required, "Coulomb friction"}.called(
                         "c_{0}", "Coulomb friction"),
                     self.c0);
        visit.number(Field{"c1", Quantity::damping, not_negative, Need::required, "viscous friction"}.called(
                         "c_{1}", "viscous slope"),
                     self.c1);
        visit.number(
            Field{"c2", Quantity::effort, not_negative, Need::required, "static friction above Coulomb, 0 for none"}
                .called("c_{2}", "Stribeck peak"),
            self.c2);
        visit.number(Field{"c3", Quantity::velocity, positive, Need::required, "Stribeck velocity"}.called(
                         "c_{3}", "Stribeck velocity"),
                     self.c3);
        visit.number(
            Field{"c4", Quantity::number, positive, Need::optional, "exponent, 2 is the Gaussian form (22)"}.called(
                "c_{4}", "Stribeck exponent"),
            self.c4);
    }

  private:
    /// limit of −d/dV c2 exp(−(V/c3)^c4) as V → 0⁺
    double slope_at_rest() const { return c4 > 1 || c2 == 0 ? 0 : c4 == 1 ? c2 / c3 : infinity; }
};

}  // namespace stickslip
