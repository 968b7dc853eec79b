// The [normal] and [[neighbour]] tables: what the rest of a machine does to one joint.
#pragma once
#include "analysis/base/field.h"

namespace stickslip {

/// A normal force that moves with the joint: σ' = displacement x + velocity ẋ + acceleration ẍ, of friction μ σ, with
/// the Linker-Dieterich effect in the state of the law. Dupont & Bapna (1994); docs/theory.md, normal load
/// and neighbours.
struct NormalLoad {
    double displacement = 0, velocity = 0, acceleration = 0;
    double mu = not_set;   ///< not set: steady friction per friction.normal_load
    double alpha = 0;      ///< share of a load step that the state takes away at once
    double from_load = 0;  ///< several bodies: normal force per effort that the transmission carries

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number(Field{"displacement", Quantity::stiffness, any_finite, Need::optional,
                           "normal force per displacement of the link"}
                         .called("n_{0}", "normal force per displacement"),
                     self.displacement);
        visit.number(
            Field{"velocity", Quantity::damping, any_finite, Need::optional, "normal force per velocity"}.called(
                "n_{1}", "normal force per velocity"),
            self.velocity);
        visit.number(
            Field{"acceleration", Quantity::inertia, any_finite, Need::optional, "normal force per acceleration"}
                .called("n_{2}", "normal force per acceleration"),
            self.acceleration);
        visit.number(Field{"mu", Quantity::number, not_negative, Need::optional,
                           "friction per normal force in steady sliding; not set: friction per friction.normal_load"}
                         .called("μ", "friction coefficient"),
                     self.mu);
        visit.number(Field{"alpha", Quantity::number, not_negative, Need::optional,
                           "Linker-Dieterich coefficient: friction per normal force that a step takes out of the state"}
                         .called("α", "Linker-Dieterich coefficient"),
                     self.alpha);
        visit.number({"from_load", Quantity::number, any_finite, Need::optional,
                      "normal force on the link per effort that the transmission carries (several inertias)"},
                     self.from_load);
    }

    bool moves() const { return displacement != 0 || velocity != 0 || acceleration != 0 || from_load != 0; }
};

/// Another joint that the mass matrix couples to this one, under a continuous loop of its own, linearised:
/// inertia ẍ_k + k_v ẋ_k + k_p x_k + coupling ẍ = 0, and coupling ẍ_k acts on this joint's link.
struct Neighbour {
    double inertia = not_set, coupling = not_set, k_p = 0, k_v = 0;

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number({"inertia", Quantity::inertia, positive, Need::required, "its entry on the mass matrix' diagonal"},
                     self.inertia);
        visit.number({"coupling", Quantity::inertia, any_finite, Need::required,
                      "the entry of the mass matrix between it and this joint"},
                     self.coupling);
        visit.number({"k_p", Quantity::stiffness, not_negative, Need::optional, "its position gain"}, self.k_p);
        visit.number(
            {"k_v", Quantity::damping, not_negative, Need::optional, "its velocity gain and the slope of its friction"},
            self.k_v);
    }
};
inline constexpr int max_neighbours = 6;

}  // namespace stickslip
