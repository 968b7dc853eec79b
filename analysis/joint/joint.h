// THE description of a joint: one set of plain data for maps, simulation and diagnosis. A nominal joint leaves the
// terms of real ones at zero; an effect of the diagnosis is a named edit of this description. SI units;
// analysis/README.md has the signs.
#pragma once
#include <string>
#include <type_traits>

#include "analysis/base/field.h"
#include "analysis/friction/friction.h"

namespace stickslip {

enum class Model { single_mass, two_mass, three_mass, lever };
inline constexpr Choice<Motion> motions[] = {{"prismatic", Motion::prismatic}, {"revolute", Motion::revolute}};
inline constexpr Choice<Model> models[] = {{"single-mass", Model::single_mass},
                                           {"two-mass", Model::two_mass},
                                           {"three-mass", Model::three_mass},
                                           {"lever", Model::lever}};

/// A spring and damper between two bodies. `ratio` is N of Fig. 4: motor displacement per joint displacement.
struct Transmission {
    double stiffness = not_set, damping = 0, ratio = 1, backlash = 0;

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number({"stiffness", Quantity::stiffness, positive, Need::required,
                      "stiffness at the joint side (lever: motor_transmission at the motor side)"},
                     self.stiffness);
        visit.number(
            {"damping", Quantity::damping, not_negative, Need::optional, "damping, at the side of the stiffness"},
            self.damping);
        visit.number(
            {"ratio", Quantity::number, positive, Need::optional, "reduction N: motor motion per joint motion"},
            self.ratio);
        visit.number({"backlash", Quantity::position, not_negative, Need::optional, "total play at the joint side"},
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

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.choice("motion", "what the joint does; units follow", self.motion, motions);
        visit.choice("model", "lumped model of the paper", self.model, models);
        if (self.model == Model::single_mass) {
            visit.number({"inertia", Quantity::inertia, positive, Need::required, "moving inertia m"}, self.inertia);
            return;
        }
        visit.number({"motor_inertia", Quantity::inertia, positive, Need::required, "motor inertia at the motor side"},
                     self.motor_inertia);
        visit.number({"link_inertia", Quantity::inertia, positive, Need::required, "link inertia"}, self.link_inertia);
        if (self.model == Model::two_mass) {
            visit.table("transmission", "between motor and link", self.transmission);
            return;
        }
        const bool lever = self.model == Model::lever;
        visit.number({"transmission_inertia", lever ? Quantity::rotary_inertia : Quantity::inertia, positive,
                      Need::required, "transmission inertia (lever: J_tr about its pivot)"},
                     self.transmission_inertia);
        if (lever)
            visit.number({"lever_arm", Quantity::length, positive, Need::required, "joint-side lever arm d"},
                         self.lever_arm);
        visit.table("motor_transmission", "between motor and transmission", self.motor_transmission);
        visit.table("transmission_link", "between transmission and link", self.transmission_link);
    }
};

/// A force in time: amplitude · sin(frequency · t + phase), not locked to position.
struct PeriodicForce {
    double amplitude = 0, frequency = 1, phase = 0;

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number({"amplitude", Quantity::effort, any_finite, Need::optional, "amplitude"}, self.amplitude);
        visit.number({"frequency", Quantity::angular_frequency, positive, Need::optional, "angular frequency"},
                     self.frequency);
        visit.number({"phase", Quantity::angle, any_finite, Need::optional, "phase"}, self.phase);
    }
};

/// What acts on the link from outside, positive in the direction of positive motion.
struct Load {
    double constant = 0;
    double gravity_amplitude = 0, gravity_phase = 0;  ///< force −amplitude · sin(q + phase)
    PositionRipple cogging;                           ///< position-locked, does not flip with direction
    PeriodicForce disturbance;                        ///< time-locked

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number({"constant", Quantity::effort, any_finite, Need::optional, "constant load"}, self.constant);
        visit.number({"gravity_amplitude", Quantity::effort, any_finite, Need::optional, "m g l of a pendulum load"},
                     self.gravity_amplitude);
        visit.number(
            {"gravity_phase", Quantity::angle, any_finite, Need::optional, "q at which gravity pulls nothing, negated"},
            self.gravity_phase);
        visit.table("cogging", "position-locked force", self.cogging);
        visit.table("disturbance", "time-locked force", self.disturbance);
    }
};

enum class ControlKind { position, force };
enum class Feedback { motor, link };
/// `unstated`: a difference of readings, but nobody said so; a sampled loop with damping wants it said.
enum class EstimateForm { unstated, backward_difference, exact };
enum class Structure { pid, cascade };
enum class AntiWindup { none, clamp, back_calculation, conditional };
inline constexpr Choice<ControlKind> control_kinds[] = {{"position", ControlKind::position},
                                                        {"force", ControlKind::force}};
inline constexpr Choice<Feedback> feedbacks[] = {{"motor", Feedback::motor}, {"link", Feedback::link}};
inline constexpr Choice<EstimateForm> estimate_forms[] = {{"backward-difference", EstimateForm::backward_difference},
                                                          {"exact", EstimateForm::exact}};
inline constexpr Choice<Structure> structures[] = {{"pid", Structure::pid}, {"cascade", Structure::cascade}};
inline constexpr Choice<AntiWindup> anti_windups[] = {{"none", AntiWindup::none},
                                                      {"clamp", AntiWindup::clamp},
                                                      {"back-calculation", AntiWindup::back_calculation},
                                                      {"conditional", AntiWindup::conditional}};
inline constexpr double most_dead_ticks = 1000;            ///< dead time that a sampled loop may remember
inline constexpr Range sample_times{0, 100, true, false};  ///< s

/// How a sampled controller gets its velocity: difference of an average over samples, then a first-order filter.
struct VelocityEstimate {
    EstimateForm form = EstimateForm::unstated;
    double tau = 0, average = 1;

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.choice("form", "how velocity is estimated", self.form, estimate_forms);
        visit.number({"tau", Quantity::time, not_negative, Need::optional,
                      "time constant of the first-order filter, 0 for none"},
                     self.tau);
        visit.number(
            {"average", Quantity::number, whole_positive, Need::optional, "positions averaged before the difference"},
            self.average);
    }
};

/// What the controller adds for the motion it is told to make; it depends on the reference r alone, so that it moves
/// no root: acceleration · r̈ + coulomb · tanh(ṙ/coulomb_speed) + the effort that holds gravity at r. `velocity` is the
/// share of ṙ in the velocity error velocity · ṙ − v.
struct FeedForward {
    double velocity = 1, acceleration = 0, coulomb = 0, coulomb_speed = 1e-3;
    bool gravity = false;

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number({"velocity", Quantity::number, any_finite, Need::optional,
                      "share of the reference velocity in the velocity error (with reference_velocity)"},
                     self.velocity);
        visit.number(
            {"acceleration", Quantity::inertia, any_finite, Need::optional, "effort per acceleration of the reference"},
            self.acceleration);
        visit.number({"coulomb", Quantity::effort, any_finite, Need::optional,
                      "effort in the direction of the reference velocity"},
                     self.coulomb);
        visit.number({"coulomb_speed", Quantity::velocity, positive, Need::optional,
                      "reference velocity over which that effort changes sign"},
                     self.coulomb_speed);
        visit.flag("gravity", "adds the effort that holds the documented gravity at the reference", self.gravity);
    }
};

/// The controller: continuous without a period, sampled with one.
struct Control {
    ControlKind kind = ControlKind::position;
    Feedback feedback = Feedback::motor;
    Structure structure = Structure::pid;
    double k_p = not_set, k_v = 0, k_i = 0;                   ///< pid; gains.h has those that act, of either structure
    double position_gain = not_set, velocity_gain = not_set;  ///< cascade: K_pos, K_v
    double velocity_integral_gain = not_set, velocity_reset_time = not_set;  ///< cascade: K_i = K_v/T_n, not both
    double integral_limit = infinity, tracking_time = not_set, integral_band = infinity;
    AntiWindup anti_windup = AntiWindup::none;
    double dead_zone = 0;
    FeedForward feed_forward;
    double V0 = not_set;           ///< commanded velocity of the maps
    double force_rate = not_set;   ///< force control: rate of the contact force, instead of V0
    double contact_stiffness = 0;  ///< k_c of Fig. 4: between link and surroundings, beside k_p
    double force_gain = 0;         ///< force control: share of the contact force that is fed back to the motor
    double period = not_set;       ///< sampled loop; not set: continuous
    bool reference_velocity = true;
    double effort_limit = infinity;
    double delay = 0;
    VelocityEstimate velocity_estimate;

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.choice("kind", "what the loop controls", self.kind, control_kinds);
        visit.choice("feedback", "which body is measured (two and more inertias)", self.feedback, feedbacks);
        visit.choice("structure", "one sum of gains, or a velocity loop inside a position loop", self.structure,
                     structures);
        if (self.structure == Structure::pid)
            sum_fields(self, visit);
        else
            cascade_fields(self, visit);
        integral_fields(self, visit);
        visit.number({"V0", Quantity::velocity, any_finite, Need::optional, "commanded velocity (maps need it)"},
                     self.V0);
        visit.number({"force_rate", Quantity::effort_rate, any_finite, Need::optional,
                      "force control: rate of the contact force, in place of V0"},
                     self.force_rate);
        visit.number({"contact_stiffness", Quantity::stiffness, not_negative, Need::optional,
                      "stiffness k_c between link and surroundings, beside k_p"},
                     self.contact_stiffness);
        visit.number({"force_gain", Quantity::number, not_negative, Need::optional,
                      "force control: share of the contact force that is fed back to the motor"},
                     self.force_gain);
        visit.number({"period", Quantity::time, sample_times, Need::optional, "sample time of the loop"}, self.period);
        visit.flag("reference_velocity", "velocity feedback acts on the velocity error, not on velocity alone",
                   self.reference_velocity);
        visit.number({"effort_limit", Quantity::effort, positive, Need::optional, "limit of the controller's output"},
                     self.effort_limit);
        visit.number({"delay", Quantity::time, not_negative, Need::optional, "dead time behind the command"},
                     self.delay);
        visit.table("velocity_estimate", "how the loop estimates velocity", self.velocity_estimate);
        visit.table("feed_forward", "what the controller adds for the motion it is told to make", self.feed_forward);
    }

    /// What ranges cannot say.
    std::string problem() const
    {
        if (is_set(velocity_integral_gain) && is_set(velocity_reset_time))
            return "velocity_integral_gain and velocity_reset_time say the same thing, allowed is one of them";
        const bool integrates = k_i != 0 || is_set(velocity_integral_gain) || is_set(velocity_reset_time);
        if (anti_windup == AntiWindup::back_calculation && integrates && !is_set(tracking_time))
            return "anti_windup = \"back-calculation\" needs tracking_time";
        if (!is_set(period)) return "";
        const bool damps = structure == Structure::cascade || k_v != 0;
        if (damps && velocity_estimate.form == EstimateForm::unstated)
            return "period is set and the loop feeds velocity back, but velocity_estimate.form is missing, allowed are "
                   "\"backward-difference\", \"exact\"";
        if (delay > most_dead_ticks * period) return "delay is more than 1000 periods, allowed are at most 1000";
        return "";
    }

  private:
    template <class Self, class Visitor>
    static void sum_fields(Self& self, Visitor& visit)
    {
        visit.number({"k_p", Quantity::stiffness, any_finite, Need::required, "position gain"}, self.k_p);
        visit.number({"k_v", Quantity::damping, any_finite, Need::optional, "velocity gain"}, self.k_v);
        visit.number(
            {"k_i", Quantity::integral_gain, any_finite, Need::optional, "gain on the integral of the position error"},
            self.k_i);
    }
    template <class Self, class Visitor>
    static void cascade_fields(Self& self, Visitor& visit)
    {
        visit.number(
            {"position_gain", Quantity::rate, any_finite, Need::required, "commanded velocity per position error"},
            self.position_gain);
        visit.number({"velocity_gain", Quantity::damping, any_finite, Need::required, "effort per velocity error"},
                     self.velocity_gain);
        visit.number({"velocity_integral_gain", Quantity::stiffness, any_finite, Need::optional,
                      "effort per integral of the velocity error"},
                     self.velocity_integral_gain);
        visit.number({"velocity_reset_time", Quantity::time, positive, Need::optional,
                      "velocity_gain per velocity_integral_gain, instead of it"},
                     self.velocity_reset_time);
    }
    template <class Self, class Visitor>
    static void integral_fields(Self& self, Visitor& visit)
    {
        visit.number({"integral_limit", Quantity::effort, positive, Need::optional,
                      "limit of the integral's share of the output"},
                     self.integral_limit);
        visit.choice("anti_windup", "what the integral does while the output is at its limit", self.anti_windup,
                     anti_windups);
        visit.number({"tracking_time", Quantity::time, positive, Need::optional,
                      "back-calculation: time constant with which the integral follows the limited output"},
                     self.tracking_time);
        visit.number({"integral_band", Quantity::position, positive, Need::optional,
                      "the integral grows only while the position error is within it"},
                     self.integral_band);
        visit.number(
            {"dead_zone", Quantity::position, not_negative, Need::optional, "position errors within it count as none"},
            self.dead_zone);
    }
};

enum class ActuatorKind { effort, dc_motor };
enum class DriveSignal { voltage, duty };
inline constexpr Choice<ActuatorKind> actuator_kinds[] = {{"effort", ActuatorKind::effort},
                                                          {"dc-motor", ActuatorKind::dc_motor}};
inline constexpr Choice<DriveSignal> drive_signals[] = {{"voltage", DriveSignal::voltage}, {"duty", DriveSignal::duty}};

/// From the command to the effort on the mechanism: dead time → lag → gain → saturation.
struct Actuator {
    ActuatorKind kind = ActuatorKind::effort;
    double effort_gain = 1, lag = 0, limit = infinity;
    double k_t = not_set, k_e = not_set, resistance = not_set, supply_voltage = not_set;
    double supply_resistance = 0;  ///< the supply sags by this times the magnitude of the motor current
    double sag_effort = infinity;  ///< effort source: the effort whose current would pull the supply down to nothing
    DriveSignal signal = DriveSignal::voltage;

    /// What ranges cannot say: a duty cycle means nothing without the supply that it switches.
    std::string problem() const
    {
        const bool blind = kind == ActuatorKind::dc_motor && signal == DriveSignal::duty && !is_set(supply_voltage);
        return blind ? "signal = \"duty\" needs supply_voltage" : "";
    }

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.choice("kind", "effort source or DC motor", self.kind, actuator_kinds);
        visit.number(
            {"effort_gain", Quantity::effort, any_finite, Need::optional, "effort per unit of the drive signal"},
            self.effort_gain);
        visit.number({"lag", Quantity::time, not_negative, Need::optional, "time constant of the actuator"}, self.lag);
        visit.number({"limit", Quantity::effort, positive, Need::optional, "limit of the effort"}, self.limit);
        if (self.kind == ActuatorKind::effort) {
            visit.number({"sag_effort", Quantity::effort, positive, Need::optional,
                          "effort is lost in the ratio |effort| / sag_effort"},
                         self.sag_effort);
            return;
        }
        visit.number({"k_t", Quantity::torque_constant, positive, Need::required, "torque constant"}, self.k_t);
        visit.number({"k_e", Quantity::back_emf, not_negative, Need::required, "back-EMF constant"}, self.k_e);
        visit.number({"resistance", Quantity::resistance, positive, Need::required, "winding resistance"},
                     self.resistance);
        visit.number({"supply_voltage", Quantity::voltage, positive, Need::optional, "supply voltage"},
                     self.supply_voltage);
        visit.number({"supply_resistance", Quantity::resistance, not_negative, Need::optional,
                      "source resistance of the supply"},
                     self.supply_resistance);
        visit.choice("signal", "what the drive signal is", self.signal, drive_signals);
    }
};

struct Sensor {
    double encoder_quantum = 0, position_noise = 0, effort_noise = 0;  ///< noises are standard deviations
    double position_offset = 0, position_scale = 1;
    double delay = 0;  ///< s, by which a reading is older than the tick that takes it

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number(
            {"encoder_quantum", Quantity::position, not_negative, Need::optional, "step of the encoder, 0 for none"},
            self.encoder_quantum);
        visit.number({"position_noise", Quantity::position, not_negative, Need::optional,
                      "standard deviation of the position noise"},
                     self.position_noise);
        visit.number(
            {"effort_noise", Quantity::effort, not_negative, Need::optional, "standard deviation of the effort noise"},
            self.effort_noise);
        visit.number({"position_offset", Quantity::position, any_finite, Need::optional, "reading minus true position"},
                     self.position_offset);
        visit.number({"position_scale", Quantity::number, positive, Need::optional, "reading per true position"},
                     self.position_scale);
        visit.number({"delay", Quantity::time, not_negative, Need::optional,
                      "dead time of the reading: how long it is on its way to the controller and the log"},
                     self.delay);
    }
};

/// One friction a body, for the models with several.
struct BodyFrictions {
    Friction motor, transmission, link;
    bool has_transmission = false;  ///< set by the model: only three-mass and lever have a middle body

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.table("motor", "friction on the motor, at the motor side", self.motor);
        if (self.has_transmission) visit.table("transmission", "friction on the transmission", self.transmission);
        visit.table("link", "friction on the link", self.link);
    }
};

/// A normal force that moves with the joint: σ' = displacement x + velocity ẋ + acceleration ẍ, of friction μ σ, with
/// the Linker-Dieterich effect in the state of the law. Dupont & Bapna (1994); PHYSICS of the coupling in
/// analysis/README.
struct NormalLoad {
    double displacement = 0, velocity = 0, acceleration = 0;
    double mu = not_set;   ///< not set: steady friction per friction.normal_load
    double alpha = 0;      ///< share of a load step that the state takes away at once
    double from_load = 0;  ///< several bodies: normal force per effort that the transmission carries

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number({"displacement", Quantity::stiffness, any_finite, Need::optional,
                      "normal force per displacement of the link"},
                     self.displacement);
        visit.number({"velocity", Quantity::damping, any_finite, Need::optional, "normal force per velocity"},
                     self.velocity);
        visit.number({"acceleration", Quantity::inertia, any_finite, Need::optional, "normal force per acceleration"},
                     self.acceleration);
        visit.number({"mu", Quantity::number, not_negative, Need::optional,
                      "friction per normal force in steady sliding; not set: friction per friction.normal_load"},
                     self.mu);
        visit.number({"alpha", Quantity::number, not_negative, Need::optional,
                      "Linker-Dieterich coefficient: friction per normal force that a step takes out of the state"},
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

struct Joint {
    Mechanism mechanism;
    Load load;
    Control control;
    Friction friction;        ///< single-mass
    BodyFrictions frictions;  ///< the other models
    Actuator actuator;
    Sensor sensor;
    NormalLoad normal;
    ShortList<Neighbour, max_neighbours> neighbour;

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
    }

    /// Of the whole loop: what goes round it is late by all delays together, wherever they arise.
    double dead_time() const { return control.delay + sensor.delay; }

    /// The dead time is one that a sampled loop can remember, and the mass matrix of the link and its neighbours is
    /// positive definite: Σ m_jk²/m_kk < m_jj.
    std::string problem() const
    {
        if (is_set(control.period) && sensor.delay > 0 && dead_time() > most_dead_ticks * control.period)
            return "sensor.delay and control.delay are more than 1000 periods, allowed are at most 1000";
        const bool single = mechanism.model == Model::single_mass;
        double carried = 0;
        for (const auto& n : neighbour) carried += n.coupling * n.coupling / n.inertia;
        return carried < (single ? mechanism.inertia : mechanism.link_inertia) || neighbour.size == 0
                   ? ""
                   : "neighbour: coupling² / inertia, summed, is not less than the inertia of this joint's link";
    }
};

/// The friction on the body that a normal load presses.
inline Friction& link_friction(Joint& joint)
{
    return joint.mechanism.model == Model::single_mass ? joint.friction : joint.frictions.link;
}

}  // namespace stickslip
