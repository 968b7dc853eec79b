#include "analysis/simulation/set_point/resting_friction.h"

namespace stickslip {

FrictionOrReason resting_friction(const Friction& friction)
{
    const double n = friction.normal_load;
    const auto bristles = [&](double coulomb, double breakaway, double viscous, double stiffness) {
        return RestingFriction{{n * coulomb, n * breakaway}, n * viscous, breakaway / stiffness, false};
    };
    if (friction.has_bristle() || friction.has_memory() || friction.has_lag() || friction.level_moves() ||
        friction.asymmetry.viscous != 0)
        return {{}, SetPointReason::friction_term};
    if (const auto* law = std::get_if<CoulombViscous>(&friction.law))
        return {{{n * law->coulomb, n * law->coulomb}, n * law->viscous, 0, true}};
    if (const auto* law = std::get_if<KineticStatic>(&friction.law))
        return {{{n * law->kinetic, n * law->breakaway}, 0, 0, true}};
    if (const auto* law = std::get_if<Stribeck>(&friction.law)) {
        // below one the curve leaves rest with a vertical tangent, which the solver does not step over
        if (law->c2 > 0 && law->c4 < 1) return {{}, SetPointReason::law_without_motion};
        return {{{n * law->c0, n * (law->c0 + law->c2)}, n * law->c1, 0, law->c2 == 0}};
    }
    if (const auto* law = std::get_if<LuGre>(&friction.law))
        return {bristles(law->coulomb, law->breakaway, law->sigma2, law->sigma0)};
    if (const auto* law = std::get_if<Dahl>(&friction.law))
        return {bristles(law->coulomb, law->coulomb, 0, law->sigma0)};
    return {{},
            info(friction.law).needs_motion ? SetPointReason::law_needs_motion : SetPointReason::law_without_motion};
}

}  // namespace stickslip
