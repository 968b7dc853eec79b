// Coulomb and viscous friction: the nominal law of most machine models.
#pragma once
#include "analysis/friction/response.h"

namespace stickslip {

/// f(V) = (F_c + F_v |V|) sgn V; at rest any force within ±F_c. Its slope is never negative: it cannot stick-slip by
/// itself.
struct CoulombViscous {
    double coulomb = not_set;
    double viscous = not_set;

    static constexpr LawInfo info{
        .name = "coulomb-viscous",
        .formula = "f = (coulomb + viscous |V|) sgn V",
        .source = "Dupont 1991, (7) with c2 = 0",
        .validity = "all velocities; at V = 0 any force within ±coulomb",
        .steady_state_dependence = true,
        .direct_effect = true,
        .set_valued_at_rest = true,
        .odd = true,
        .dissipative = true,
    };

    int states() const { return 0; }
    States steady_state(double) const { return {}; }
    double static_force() const { return coulomb; }
    Level level(double) const { return {coulomb, 0}; }
    double steady_force(double V) const { return respond(V, {}).force; }
    FrictionResponse respond(double V, const States&) const { return slide(level(std::abs(V)), viscous, V); }

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number(Field{"coulomb", Quantity::effort, not_negative, Need::required, "Coulomb friction"}.called(
                         "F_{c}", "Coulomb friction"),
                     self.coulomb);
        visit.number(Field{"viscous", Quantity::damping, not_negative, Need::required, "viscous friction"}.called(
                         "F_{v}", "viscous friction"),
                     self.viscous);
    }
};

}  // namespace stickslip
