// The [joint] table of a joint file: bodies and what connects them.
#pragma once
#include "analysis/base/field.h"

namespace stickslip {

enum class Model { single_mass, two_mass, three_mass, lever };
inline constexpr Choice<Motion> motions[] = {{"prismatic", Motion::prismatic}, {"revolute", Motion::revolute}};
inline constexpr Choice<Model> models[] = {{"single-mass", Model::single_mass},
                                           {"two-mass", Model::two_mass},
                                           {"three-mass", Model::three_mass},
                                           {"lever", Model::lever}};

/// A spring and damper between two bodies. `ratio` is N of Fig. 4: motor displacement per joint displacement. The
/// spring gives stiffness x + cubic_stiffness x³ (Kirćanski & Goldenberg 1997 of strain wave gears).
struct Transmission {
    double stiffness = not_set, damping = 0, ratio = 1, backlash = 0, cubic_stiffness = 0;

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number(Field{"stiffness", Quantity::stiffness, positive, Need::required,
                           "stiffness at the joint side (lever: motor_transmission at the motor side)", Role::stiffness}
                         .called("k_{#}", "# stiffness"),
                     self.stiffness);
        visit.number(Field{"cubic_stiffness", Quantity::cubic_stiffness, not_negative, Need::optional,
                           "of a spring that hardens: effort per cube of its deflection, beside the stiffness"}
                         .called("k_{3,#}", "# cubic stiffness"),
                     self.cubic_stiffness);
        visit.number(
            Field{"damping", Quantity::damping, not_negative, Need::optional, "damping, at the side of the stiffness"}
                .called("c_{#}", "# damping"),
            self.damping);
        visit.number(
            Field{"ratio", Quantity::number, positive, Need::optional, "reduction N: motor motion per joint motion"}
                .called("N", "transmission ratio"),
            self.ratio);
        visit.number(
            Field{"backlash", Quantity::position, not_negative, Need::optional, "total clearance at the joint side"}
                .called("β", "backlash"),
            self.backlash);
    }
};

/// The [joint] table: bodies and what connects them. Which inertias it has depends on the model.
struct Mechanism {
    Motion motion = Motion::prismatic;
    Model model = Model::single_mass;
    double inertia = not_set;  ///< single-mass, Fig. 7
    double motor_inertia = not_set, transmission_inertia = not_set, link_inertia = not_set;
    double lever_arm = not_set;                          ///< lever, Fig. 4: d of J_tr/d²
    Transmission transmission;                           ///< two-mass, Fig. 6
    Transmission motor_transmission, transmission_link;  ///< three-mass and lever, Figs. 5 and 4

    /// Whether a spring of this model gives more than in proportion.
    bool hardens() const
    {
        if (model == Model::single_mass) return false;
        if (model == Model::two_mass) return transmission.cubic_stiffness > 0;
        return motor_transmission.cubic_stiffness > 0 || transmission_link.cubic_stiffness > 0;
    }

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.choice("motion", "what the joint does; units follow", self.motion, motions);
        visit.choice("model", "how many masses move, and what connects them", self.model, models);
        if (self.model == Model::single_mass) {
            visit.number(
                Field{"inertia", Quantity::inertia, positive, Need::required, "moving inertia m", Role::inertia}.called(
                    "m", "inertia"),
                self.inertia);
            return;
        }
        visit.number(Field{"motor_inertia", Quantity::inertia, positive, Need::required,
                           "motor inertia at the motor side", Role::inertia}
                         .called("m_{mot}", "motor inertia"),
                     self.motor_inertia);
        visit.number(
            Field{"link_inertia", Quantity::inertia, positive, Need::required, "link inertia", Role::inertia}.called(
                "m_{link}", "link inertia"),
            self.link_inertia);
        if (self.model == Model::two_mass) {
            visit.table("transmission", "between motor and link", self.transmission);
            return;
        }
        const bool lever = self.model == Model::lever;
        visit.number(Field{"transmission_inertia", lever ? Quantity::rotary_inertia : Quantity::inertia, positive,
                           Need::required, "transmission inertia (lever: J_tr about its pivot)", Role::inertia}
                         .called("m_{tr}", "transmission inertia"),
                     self.transmission_inertia);
        if (lever)
            visit.number(
                Field{"lever_arm", Quantity::length, positive, Need::required, "joint-side lever arm d"}.called(
                    "d", "lever arm"),
                self.lever_arm);
        visit.table("motor_transmission", "between motor and transmission", self.motor_transmission);
        visit.table("transmission_link", "between transmission and link", self.transmission_link);
    }
};

}  // namespace stickslip
