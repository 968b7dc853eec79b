// LuGre: bristles whose slip level follows the Stribeck curve.
#pragma once
#include <string>

#include "analysis/friction/saturation.h"
#include "analysis/friction/stribeck.h"

namespace stickslip {

/// Stiffness and damping of bristles.
struct BristleParameters {
    double stiffness, damping;
};

/// ż = V − σ0 |V| z/g(|V|),   f = σ0 z + σ1 ż + F_v V;   in steady sliding z = (g/σ0) sgn V and f = (g + F_v |V|) sgn
/// V. The state is z, the mean deflection of the bristles. Source: Canudas de Wit, Olsson, Åström & Lischinsky (1995).
inline FrictionResponse bristle_response(const BristleParameters& bristle, const Level& g, double viscous, double V,
                                         double z)
{
    const double speed = std::abs(V), direction = std::copysign(1.0, V);
    const double computed = bristle.stiffness * z / g.value;  // ±1 in steady sliding
    const double slipping = unless_rounding(1 - direction * computed) == 0 ? direction : computed;
    FrictionResponse r;
    r.rate[0] = V - speed * slipping;
    r.rate_by_velocity[0] = 1 - direction * slipping * (1 - speed * g.slope / g.value);
    r.rate_by_state[0] = -bristle.stiffness * speed / g.value;
    r.force = bristle.stiffness * z + bristle.damping * r.rate[0] + viscous * V;
    r.by_velocity = bristle.damping * r.rate_by_velocity[0] + viscous;
    r.by_state[0] = bristle.stiffness + bristle.damping * r.rate_by_state[0];
    return r;
}

/// g(V) = F_c + (F_s − F_c) exp(−(V/v_s)²) in bristle_response. About steady sliding at V: λ = −σ0|V|/g,
/// f_v = σ1 V g'/g + σ2, which can be negative: bristle damping breaks the paper's premise of a positive direct effect.
struct LuGre {
    double sigma0 = not_set;  ///< bristle stiffness
    double sigma1 = not_set;  ///< bristle damping
    double sigma2 = not_set;  ///< viscous friction
    double coulomb = not_set;
    double breakaway = not_set;  ///< F_s, "static" in files
    double stribeck_velocity = not_set;

    static constexpr LawInfo info{
        .name = "lugre",
        .formula =
            "f = sigma0 z + sigma1 z' + sigma2 V, z' = V - sigma0 |V| z/g(V), "
            "g = coulomb + (static - coulomb) exp(-(V/stribeck_velocity)^2)",
        .source = "Canudas de Wit, Olsson, Astrom & Lischinsky 1995",
        .validity = "all velocities; passive only for small sigma1",
        .steady_state_dependence = true,
        .slip_distance = true,
        .odd = true,
    };

    int states() const { return 1; }
    Level level(double speed) const
    {
        return Stribeck{coulomb, 0, breakaway - coulomb, stribeck_velocity, 2}.level(speed);
    }
    double steady_force(double V) const { return slide(level(std::abs(V)), sigma2, V).force; }
    States steady_state(double V) const { return {slide(level(std::abs(V)), 0, V).force / sigma0}; }
    FrictionResponse respond(double V, const States& z) const
    {
        return bristle_response({sigma0, sigma1}, level(std::abs(V)), sigma2, V, z[0]);
    }

    std::string problem() const { return breakaway < coulomb ? "static friction is less than Coulomb friction" : ""; }

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number(Field{"sigma0", Quantity::stiffness, positive, Need::required, "bristle stiffness"}.called(
                         "σ_{0}", "bristle stiffness"),
                     self.sigma0);
        visit.number(Field{"sigma1", Quantity::damping, not_negative, Need::required, "bristle damping"}.called(
                         "σ_{1}", "bristle damping"),
                     self.sigma1);
        visit.number(Field{"sigma2", Quantity::damping, not_negative, Need::required, "viscous friction"}.called(
                         "σ_{2}", "viscous friction"),
                     self.sigma2);
        visit.number(Field{"coulomb", Quantity::effort, positive, Need::required, "Coulomb friction"}.called(
                         "F_{c}", "Coulomb friction"),
                     self.coulomb);
        visit.number(Field{"static", Quantity::effort, positive, Need::required, "static friction"}.called(
                         "F_{s}", "static friction"),
                     self.breakaway);
        visit.number(
            Field{"stribeck_velocity", Quantity::velocity, positive, Need::required, "Stribeck velocity"}.called(
                "v_{s}", "Stribeck velocity"),
            self.stribeck_velocity);
    }
};

}  // namespace stickslip
