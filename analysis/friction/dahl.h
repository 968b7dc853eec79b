// Dahl's law: Coulomb friction carried by bristles that bend before they slip.
#pragma once
#include "analysis/friction/response.h"
#include "analysis/friction/saturation.h"

namespace stickslip {

/// f = σ0 z,   ż = V (1 − (σ0 z/F_c) sgn V)^i;   f_ss = F_c sgn V.
/// Its steady-state curve is flat, so it can neither cause nor cure stick-slip of steady sliding; its transient lives
/// in reversals. For i = 1 the approach to F_c is exponential over the slip distance F_c/σ0, for i > 1 slower than any
/// exponential (no linear rate); i < 1 arrives in finite slip and has no linearisation at all, hence i ≥ 1.
/// Source: Dahl (1976); Dupont (1991), §2, [3], [12].
struct Dahl {
    double coulomb = not_set;
    double sigma0 = not_set;  ///< bristle stiffness
    double exponent = 1;

    static constexpr LawInfo info{
        .name = "dahl",
        .formula = "f = sigma0 z, z' = V (1 - (sigma0 z/coulomb) sgn V)^exponent",
        .source = "Dahl 1976; Dupont 1991, section 2",
        .validity = "all velocities; |sigma0 z| <= coulomb",
        .slip_distance = true,
        .odd = true,
    };

    int states() const { return 1; }
    double steady_force(double V) const { return V == 0 ? 0 : std::copysign(coulomb, V); }
    States steady_state(double V) const { return {steady_force(V) / sigma0}; }

    FrictionResponse respond(double V, const States& z) const
    {
        const double direction = std::copysign(1.0, V);
        const double reserve = unless_rounding(1 - sigma0 * z[0] / coulomb * direction);
        const double share = std::copysign(std::pow(std::abs(reserve), exponent), reserve);
        const double share_slope = exponent * std::pow(std::abs(reserve), exponent - 1);
        FrictionResponse r;
        r.force = sigma0 * z[0];
        r.by_state[0] = sigma0;
        r.rate[0] = V * share;
        r.rate_by_velocity[0] = share;
        r.rate_by_state[0] = -std::abs(V) * sigma0 / coulomb * share_slope;
        return r;
    }

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number(Field{"coulomb", Quantity::effort, positive, Need::required, "Coulomb friction"}.called(
                         "F_{c}", "Coulomb friction"),
                     self.coulomb);
        visit.number(Field{"sigma0", Quantity::stiffness, positive, Need::required, "bristle stiffness"}.called(
                         "σ_{0}", "bristle stiffness"),
                     self.sigma0);
        visit.number({"exponent", Quantity::number, Range{1, infinity, false, true}, Need::optional,
                      "shape of the approach to the Coulomb level", Role::label},
                     self.exponent);
    }
};

}  // namespace stickslip
