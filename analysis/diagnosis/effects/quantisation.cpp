#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {

Effect quantisation()
{
    Effect e;
    e.name = "quantisation";
    e.stage = Stage::sensor;
    e.read_off = true;  // off the grid on which the readings lie
    e.form = "floor(q/Delta) Delta";
    e.source = "Widrow and Kollar 2008";
    e.confusable = {"sensor-offset"};
    {
        EffectForm f;
        f.parameters = {
            {"quantum", Quantity::position, Scale::position, true, 1e-08, 0.2, 0.001, "true step of the encoder"},
        };
        f.apply = [](Joint& j, const double* p) { j.sensor.encoder_quantum = p[0]; };
        f.seeds = {{0.001}};
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
