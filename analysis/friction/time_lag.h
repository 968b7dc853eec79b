// Time lag: a steady-state curve that is delayed.
#pragma once
#include "analysis/friction/ageing.h"
#include "analysis/friction/any_law.h"
#include "analysis/friction/coulomb_viscous.h"
#include "analysis/friction/dahl.h"
#include "analysis/friction/kinetic_static.h"
#include "analysis/friction/lugre.h"
#include "analysis/friction/maxwell_slip.h"
#include "analysis/friction/rate_and_state_regularised.h"

namespace stickslip {

/// Every law whose steady-state curve may stand in for the curve of another law.
using CurveLaw = std::variant<CoulombViscous, Stribeck, KineticStatic, RateAndState, Ageing, RateAndStateRegularised,
                              Dahl, LuGre, MaxwellSlip>;

/// The friction-velocity curve of a law, whatever transients the law itself may have.
struct SteadyCurve {
    CurveLaw law = Stribeck{};

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.law(self.law);
    }
};

/// f(t) = f_ss(V(t − τ)).
/// Linearised: f_v = 0 and g(t) = −f_ss'(V_0) δ(t − τ), so that G(s) = −f_ss' e^{−sτ}. The premises of (17) and (28),
/// f_v > 0 and g a function, do not hold: stable windows in k_p without end, rather than one critical gain.
/// Source: Hess & Soom (1990); Dupont (1991), §2, [6].
struct TimeLag {
    double lag = not_set;
    SteadyCurve curve;

    static constexpr LawInfo info{
        .name = "time-lag",
        .formula = "f(t) = f_ss(V(t - lag))",
        .source = "Hess & Soom 1990; Dupont 1991, section 2",
        .validity = "where the curve is valid; through reversal the level is late, the direction is not",
        .steady_state_dependence = true,
        .set_valued_at_rest = true,
        .odd = true,
        .needs_history = true,
    };

    int states() const { return 0; }
    States steady_state(double) const { return {}; }
    double steady_force(double V) const { return stickslip::steady_force(curve.law, V); }
    double static_force() const { return stickslip::static_force(curve.law); }

    /// The force after V has been held for longer than the lag; a change of V shows only after the lag.
    FrictionResponse respond(double V, const States&) const
    {
        FrictionResponse r;
        r.force = steady_force(V);
        return r;
    }

    DelayList delays(double V) const
    {
        DelayList list;
        list.push_back({-steady_slope(curve.law, V), lag});
        return list;
    }

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number(
            Field{"lag", Quantity::time, positive, Need::required, "by how much friction follows velocity"}.called(
                "τ", "time lag"),
            self.lag);
        visit.table("curve", "friction-velocity curve of steady sliding", self.curve);
    }
};

}  // namespace stickslip
