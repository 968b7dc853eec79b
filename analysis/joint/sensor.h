// The [sensor] table: what the encoder and the log add.
#pragma once
#include "analysis/base/field.h"

namespace stickslip {

struct Sensor {
    double encoder_quantum = 0, position_noise = 0, effort_noise = 0;  ///< noises are standard deviations
    double position_offset = 0, position_scale = 1;
    double effort_scale = 1;
    double delay = 0;  ///< s, by which a reading is older than the tick that takes it

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number(Field{"encoder_quantum", Quantity::position, not_negative, Need::optional,
                           "step of the encoder, 0 for none"}
                         .called("Δ_{q}", "encoder quantum"),
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
        visit.number({"effort_scale", Quantity::number, positive, Need::optional,
                      "measured effort per true effort: a current that is logged times a torque constant that is off"},
                     self.effort_scale);
        visit.number(Field{"delay", Quantity::time, not_negative, Need::optional,
                           "dead time of the reading: how long it is on its way to the controller and the log"}
                         .called("T_{s}", "dead time of the reading"),
                     self.delay);
    }
};

}  // namespace stickslip
