// Static and kinetic friction: the model of introductory physics.
#pragma once
#include <string>

#include "analysis/friction/response.h"

namespace stickslip {

/// f = F_k sgn V in motion; at rest any force within ±F_s.                                          Fig. 1a
/// The drop from F_s to F_k has no width in velocity, so the slope at every V ≠ 0 is zero: the linear theories see
/// nothing of it, stick-slip after a stop is a matter of the nonlinear simulation.
struct KineticStatic {
    double kinetic = not_set;
    double breakaway = not_set;  ///< F_s, "static" in files

    static constexpr LawInfo info{
        .name = "kinetic-static",
        .formula = "f = kinetic sgn V, at rest within ±static",
        .source = "Dupont 1991, Fig. 1a",
        .validity = "all velocities; at V = 0 any force within ±static",
        .set_valued_at_rest = true,
        .odd = true,
        .dissipative = true,
    };

    int states() const { return 0; }
    States steady_state(double) const { return {}; }
    double static_force() const { return breakaway; }
    Level level(double) const { return {kinetic, 0}; }
    double steady_force(double V) const { return respond(V, {}).force; }
    FrictionResponse respond(double V, const States&) const { return slide(level(std::abs(V)), 0, V); }

    std::string problem() const { return breakaway < kinetic ? "static friction is less than kinetic" : ""; }

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number(Field{"kinetic", Quantity::effort, not_negative, Need::required, "friction in motion"}.called(
                         "F_{k}", "kinetic friction"),
                     self.kinetic);
        visit.number(
            Field{"static", Quantity::effort, not_negative, Need::required, "friction to break away from rest"}.called(
                "F_{s}", "static friction"),
            self.breakaway);
    }
};

}  // namespace stickslip
