// The [actuator] table: from the command to the effort.
#pragma once
#include <string>

#include "analysis/base/field.h"

namespace stickslip {

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
            Field{"effort_gain", Quantity::effort, any_finite, Need::optional, "effort per unit of the drive signal"}
                .called("k_{a}", "effort gain"),
            self.effort_gain);
        visit.number(Field{"lag", Quantity::time, not_negative, Need::optional, "time constant of the actuator"}.called(
                         "τ", "time lag"),
                     self.lag);
        visit.number({"limit", Quantity::effort, positive, Need::optional, "limit of the effort that arrives"},
                     self.limit);
        if (self.kind == ActuatorKind::effort) {
            visit.number({"sag_effort", Quantity::effort, positive, Need::optional,
                          "effort is lost in the ratio |effort| / sag_effort"},
                         self.sag_effort);
            return;
        }
        visit.number(Field{"k_t", Quantity::torque_constant, positive, Need::required, "torque constant"}.called(
                         "k_{t}", "torque constant"),
                     self.k_t);
        visit.number(Field{"k_e", Quantity::back_emf, not_negative, Need::required, "back-EMF constant"}.called(
                         "k_{e}", "back-EMF constant"),
                     self.k_e);
        visit.number(Field{"resistance", Quantity::resistance, positive, Need::required, "winding resistance"}.called(
                         "R", "winding resistance"),
                     self.resistance);
        visit.number(Field{"supply_voltage", Quantity::voltage, positive, Need::optional, "supply voltage"}.called(
                         "U_{0}", "supply voltage"),
                     self.supply_voltage);
        visit.number({"supply_resistance", Quantity::resistance, not_negative, Need::optional,
                      "source resistance of the supply"},
                     self.supply_resistance);
        visit.choice("signal", "what the drive signal is", self.signal, drive_signals);
    }
};

}  // namespace stickslip
