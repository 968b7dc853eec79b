// Contacts with a direct effect that rest and turn round at speeds which no motion resolves.
#pragma once
#include "analysis/friction/friction.h"

namespace stickslip {

/// Of a body whose friction is f = A asinh(V/core), core = 2V* e^{−ψ/A} (regularised_force), in steady sliding; by
/// default no such contact. Within ± core the friction changes its sign: for ψ = 60 A that is 10⁻²⁶ V*. A mass that
/// is held creeps at core · sinh(f/A), which is rest to any tolerance until the last few A before it slips; and a
/// solver that looks for the balance of forces near V = 0 knows only its two sides, between which it goes to and fro.
struct DirectContact {
    double A = 0;  ///< at the joint's normal load
    double core = infinity;
};
DirectContact direct_contact(const Friction& friction, double V);

/// Whether the core is narrower than what a motion about V resolves.
bool is_steep(const DirectContact& contact, double V);

/// Whether the sinh of a contact with a direct effect is so steep that it turns round at speeds which no motion has,
/// however fast that is.
bool is_steep_contact(const Friction& friction);

/// The states of a contact after so long a rest: those of the slip law stay, contacts of the ageing law grow older,
/// θ = B ln(e^{θ/B} + V* t/L).
States rested(const Friction& friction, const States& theta, double time);

}  // namespace stickslip
