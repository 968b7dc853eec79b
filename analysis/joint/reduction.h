// The reductions of the paper, Fig. 4 → 5 → 6 → 7, each with what it neglects. How good one is, is a matter of
// comparing boundaries on both sides (stability/reduction_error.h).
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "analysis/joint/joint.h"

namespace stickslip {

/// The friction of a body that has become part of another one, where both together have no single law. It acts beside
/// that body's own: f += turns · friction(turns · V), turns being its displacement per that of the body.
struct JoinedFriction {
    Friction friction;    ///< as on the body that it was on
    double turns = 1;     ///< its displacement per that of the body that it joined
    bool on_link = true;  ///< otherwise on the motor
};

/// A smaller joint that stands for a larger one.
struct Reduction {
    enum class Motor { stays, joins_link, ideal };

    Joint joint;                         ///< the smaller one
    std::string name;                    ///< "lever to three masses (Fig. 4 to 5)"
    std::string model;                   ///< what it leads to, short: "Fig. 5"
    std::vector<std::string> neglected;  ///< half sentences, mark-up; empty for an exact reduction
    std::vector<JoinedFriction> joined;  ///< beside the frictions of `joint`
    Motor motor = Motor::stays;          ///< what became of it
};

/// Where a transmission sits: which spring of Fig. 5 is so stiff that its bodies move as one.
enum class Placement { at_motor, at_joint };

/// Fig. 4 → 5 by the table of §3. Needs model lever; throws std::invalid_argument otherwise, as do the others.
Reduction lever_to_three_mass(const Joint& joint);

/// Fig. 5 → 6: the transmission's inertia and friction go to the motor or to the link. The frictions that meet on one
/// body become one law where one is zero, or coulomb-viscous and the other takes a level (coulomb-viscous, Stribeck;
/// without a viscous part kinetic-static, rate-and-state, ageing); others act side by side, see Reduction::joined.
/// Refused where their states are too many, or where both remember by delays or tables.
Reduction three_mass_to_two_mass(const Joint& joint, Placement placement);

/// Fig. 6 → 7: the motor is an ideal source. Position control (7a): it moves at V_0 whatever the force, and the
/// transmission becomes the loop, k_p = k_tr, k_v = its damping. Force control (7b, k_c ≪ k_tr): it gives its force
/// whatever the motion, and the finger on the link remains.
Reduction two_mass_to_single_mass(const Joint& joint);

/// Fig. 6 → one mass by the other limit, k_tr ≫ k_p: all bodies move as one, the loop stays.
Reduction rigid_transmission(const Joint& joint);

/// One after the other: what either neglects is neglected, and frictions that the first joined to the motor share its
/// fate in the second.
Reduction in_sequence(Reduction first, const std::function<Reduction(const Joint&)>& second);

}  // namespace stickslip
