// The [control] table: the controller of a joint.
#pragma once
#include <numbers>
#include <string>

#include "analysis/joint/feed_forward.h"

namespace stickslip {

enum class ControlKind { position, force };
enum class Feedback { motor, link };
/// `unstated`: a difference of readings by default; a sampled loop with damping requires that it is stated.
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
        visit.number(Field{"tau", Quantity::time, not_negative, Need::optional,
                           "time constant of the first-order filter, 0 for none"}
                         .called("τ_{v}", "velocity filter time constant"),
                     self.tau);
        visit.number(
            {"average", Quantity::number, whole_positive, Need::optional, "positions averaged before the difference"},
            self.average);
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
    Dither dither;
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
        visit.number(Field{"V0", Quantity::velocity, any_finite, Need::optional, "commanded velocity (maps need it)",
                           Role::speed}
                         .called("V_{0}", "commanded velocity"),
                     self.V0);
        visit.number(Field{"force_rate", Quantity::effort_rate, any_finite, Need::optional,
                           "force control: rate of the contact force, in place of V0", Role::speed}
                         .called("Ḟ_{0}", "force rate"),
                     self.force_rate);
        visit.number({"contact_stiffness", Quantity::stiffness, not_negative, Need::optional,
                      "stiffness k_c between link and surroundings, beside k_p"},
                     self.contact_stiffness);
        visit.number({"force_gain", Quantity::number, not_negative, Need::optional,
                      "force control: share of the contact force that is fed back to the motor"},
                     self.force_gain);
        visit.number(Field{"period", Quantity::time, sample_times, Need::optional, "sample time of the loop"}.called(
                         "T", "sample time"),
                     self.period);
        visit.flag("reference_velocity", "velocity feedback acts on the velocity error, not on velocity alone",
                   self.reference_velocity);
        visit.number(Field{"effort_limit", Quantity::command, positive, Need::optional, "limit of the command"}.called(
                         "u_{max}", "controller limit"),
                     self.effort_limit);
        visit.number(
            Field{"delay", Quantity::time, not_negative, Need::optional, "dead time behind the command"}.called(
                "T_{d}", "dead time"),
            self.delay);
        visit.table("velocity_estimate", "how the loop estimates velocity", self.velocity_estimate);
        visit.table("feed_forward", "what the controller adds for the commanded motion", self.feed_forward);
        visit.table("dither", "a vibration that the controller adds to its command", self.dither);
    }

    /// What ranges cannot say.
    std::string problem() const
    {
        if (is_set(velocity_integral_gain) && is_set(velocity_reset_time))
            return "velocity_integral_gain and velocity_reset_time say the same thing, expected one of them";
        const bool integrates = k_i != 0 || is_set(velocity_integral_gain) || is_set(velocity_reset_time);
        if (anti_windup == AntiWindup::back_calculation && integrates && !is_set(tracking_time))
            return "anti_windup = \"back-calculation\" needs tracking_time";
        if (!is_set(period)) return "";
        // in force control k_v is the damper of the finger, which nobody estimates
        const bool damps = kind == ControlKind::position && (structure == Structure::cascade || k_v != 0);
        if (damps && velocity_estimate.form == EstimateForm::unstated)
            return "period is set and the loop feeds velocity back, but velocity_estimate.form is missing, expected "
                   "\"backward-difference\", \"exact\"";
        if (delay > most_dead_ticks * period) return "delay is more than 1000 periods, expected at most 1000";
        if (dither.amplitude > 0 && !(dither.frequency * period < std::numbers::pi))
            return "dither.frequency is not below half the sampling rate, expected less than pi/period";
        return "";
    }

  private:
    template <class Self, class Visitor>
    static void sum_fields(Self& self, Visitor& visit)
    {
        visit.number(Field{"k_p", Quantity::position_gain, any_finite, Need::required,
                           "position gain, command per position error"}
                         .called("k_{p}", "position gain"),
                     self.k_p);
        visit.number(Field{"k_v", Quantity::velocity_gain, any_finite, Need::optional,
                           "velocity gain, command per velocity error"}
                         .called("k_{v}", "velocity gain"),
                     self.k_v);
        visit.number(Field{"k_i", Quantity::integral_gain, any_finite, Need::optional,
                           "integral gain, command per integral of the position error"}
                         .called("k_{i}", "integral gain"),
                     self.k_i);
    }
    template <class Self, class Visitor>
    static void cascade_fields(Self& self, Visitor& visit)
    {
        visit.number(
            Field{"position_gain", Quantity::rate, any_finite, Need::required, "commanded velocity per position error"}
                .called("K_{pos}", "position gain of the cascade"),
            self.position_gain);
        visit.number(
            Field{"velocity_gain", Quantity::velocity_gain, any_finite, Need::required, "command per velocity error"}
                .called("K_{v}", "velocity gain of the cascade"),
            self.velocity_gain);
        visit.number(Field{"velocity_integral_gain", Quantity::position_gain, any_finite, Need::optional,
                           "command per integral of the velocity error"}
                         .called("K_{i}", "integral gain of the velocity loop"),
                     self.velocity_integral_gain);
        visit.number(Field{"velocity_reset_time", Quantity::time, positive, Need::optional,
                           "velocity_gain per velocity_integral_gain, instead of it"}
                         .called("T_{n}", "reset time of the velocity loop"),
                     self.velocity_reset_time);
    }
    template <class Self, class Visitor>
    static void integral_fields(Self& self, Visitor& visit)
    {
        visit.number(Field{"integral_limit", Quantity::command, positive, Need::optional,
                           "limit of the integral's share of the command"}
                         .called("u_{i,max}", "limit of the integral"),
                     self.integral_limit);
        visit.choice("anti_windup", "what the integral does while the command is at its limit", self.anti_windup,
                     anti_windups);
        visit.number(Field{"tracking_time", Quantity::time, positive, Need::optional,
                           "back-calculation: time constant with which the integral follows the limited command"}
                         .called("T_{t}", "tracking time"),
                     self.tracking_time);
        visit.number(Field{"integral_band", Quantity::position, positive, Need::optional,
                           "the integral grows only while the position error is within it"}
                         .called("e_{i}", "integral band"),
                     self.integral_band);
        visit.number(Field{"dead_zone", Quantity::position, not_negative, Need::optional,
                           "position errors within it count as none"}
                         .called("e_{0}", "dead zone"),
                     self.dead_zone);
    }
};

}  // namespace stickslip
