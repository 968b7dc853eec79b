// THE description of a joint: one set of plain data for maps, simulation and diagnosis. A nominal joint leaves the
// terms of real ones at zero; an effect of the diagnosis is a named edit of this description. SI units;
// analysis/README.md has the signs.
#pragma once
#include <string>
#include <type_traits>

#include "analysis/joint/actuator.h"
#include "analysis/joint/control.h"
#include "analysis/joint/coupling.h"
#include "analysis/joint/load.h"
#include "analysis/joint/mechanism.h"
#include "analysis/joint/pose.h"
#include "analysis/joint/sensor.h"

namespace stickslip {

/// One friction a body, for the models with several.
struct BodyFrictions {
    Friction motor, transmission, link;  ///< each at its own body's velocity
    bool has_transmission = false;       ///< set by the model: only three-mass and lever have a middle body

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.table("motor", "friction on the motor, at the motor side", self.motor);
        if (self.has_transmission) visit.table("transmission", "friction on the transmission", self.transmission);
        visit.table("link", "friction on the link", self.link);
    }
};

/// One joint: mechanism, loop, friction and what acts on it, in SI.
struct Joint {
    Mechanism mechanism;                             ///< bodies and what connects them
    Load load;                                       ///< what acts on the link
    Control control;                                 ///< the loop
    OneMassFriction friction;                        ///< single-mass
    BodyFrictions frictions;                         ///< the other models
    Actuator actuator;                               ///< from the command to the effort
    Sensor sensor;                                   ///< what the encoder adds
    NormalLoad normal;                               ///< a normal force that moves with the joint
    ShortList<Neighbour, max_neighbours> neighbour;  ///< joints that the mass matrix couples to this one
    Pose pose;                                       ///< of the robot that the joint is part of

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.table("joint", "bodies and what connects them", self.mechanism);
        visit.table("load", "what acts on the link", self.load);
        visit.table("control", "the loop", self.control);
        if (self.mechanism.model == Model::single_mass) {
            visit.table("friction", "friction on the moving body", self.friction);
        } else {
            if constexpr (!std::is_const_v<Self>)
                self.frictions.has_transmission = self.mechanism.model != Model::two_mass;
            visit.table("friction", "friction on each body", self.frictions);
        }
        visit.table("actuator", "from the command to the effort", self.actuator);
        visit.table("sensor", "what the encoder adds", self.sensor);
        visit.table("normal", "a normal force that moves with the joint", self.normal);
        visit.rows("neighbour", "joints that the mass matrix couples to this one", self.neighbour);
        if (self.pose.of) visit.table("pose", "where the other joints of the robot stand", self.pose);
    }

    /// Dead time of the whole loop [s]: what goes round it is late by all delays together, wherever they arise.
    double dead_time() const { return control.delay + sensor.delay; }

    /// The dead time is one that a sampled loop can remember, springs that harden carry a steady effort, a normal
    /// load follows the transmitted effort of a transmission and without the state's own share (that has no form here),
    /// and the mass matrix of the link and its neighbours is positive definite: Σ m_jk²/m_kk < m_jj.
    std::string problem() const
    {
        if (is_set(control.period) && sensor.delay > 0 && dead_time() > most_dead_ticks * control.period)
            return "sensor.delay and control.delay are more than 1000 periods, expected at most 1000";
        const bool single = mechanism.model == Model::single_mass;
        if (normal.from_load != 0 && single)
            return "normal.from_load is of the effort that a transmission carries, and a single mass has none; "
                   "friction.load_coefficient is of the effort of the loop";
        if (normal.from_load != 0 && normal.alpha != 0)
            return "normal.alpha and normal.from_load: a state that follows the transmitted effort is not computed, "
                   "expected one of them";
        const bool stretched = control.kind == ControlKind::force || control.contact_stiffness > 0;
        if (mechanism.hardens() && stretched)
            return "cubic_stiffness: a spring to the surroundings stretches the transmission ever more, so that its "
                   "stiffness is not steady; expected 0 with control.kind \"force\" or control.contact_stiffness";
        double carried = 0;
        for (const auto& n : neighbour) carried += n.coupling * n.coupling / n.inertia;
        return carried < (single ? mechanism.inertia : mechanism.link_inertia) || neighbour.size == 0
                   ? ""
                   : "neighbour: coupling² / inertia, summed, is not less than the inertia of this joint's link";
    }
};

/// Gains of a position loop turn positions into what the drive takes. Force loops have springs in their place.
inline Units units_of(const Joint& joint)
{
    const auto& a = joint.actuator;
    const bool efforts = a.kind == ActuatorKind::effort || joint.control.kind == ControlKind::force;
    const Command signal = a.signal == DriveSignal::voltage ? Command::voltage : Command::duty;
    return Units(joint.mechanism.motion, efforts ? Command::effort : signal);
}

/// The friction on the body that a normal load presses.
inline Friction& link_friction(Joint& joint)
{
    return joint.mechanism.model == Model::single_mass ? joint.friction : joint.frictions.link;
}

}  // namespace stickslip
