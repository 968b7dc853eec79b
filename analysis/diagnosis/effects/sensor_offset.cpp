#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {

Effect sensor_offset()
{
    Effect e;
    e.name = "sensor-offset";
    e.stage = Stage::sensor;
    e.form = "q + q_0, scale";
    e.source = "Fraden 2016";
    e.confusable = {"gravity", "inertia"};
    {
        EffectForm f;
        f.name = "offset";
        f.parameters = {
            {"offset", Quantity::position, Scale::one, false, -3.2, 3.2, 0.1, "reading minus true position"},
        };
        f.apply = [](Joint& j, const double* p) { j.sensor.position_offset += p[0]; };
        f.seeds = {{0.01}, {-0.01}};
        f.applies = [](const Joint& j) { return j.load.gravity_amplitude != 0 || j.load.cogging.acts(); };
        e.forms.push_back(f);
    }
    {
        EffectForm f;
        f.name = "scale";
        f.parameters = {
            factor_on_number(0.5, 2, 0.05, "reading per true position", "scale"),
        };
        f.apply = [](Joint& j, const double* p) { j.sensor.position_scale *= p[0]; };
        f.seeds = {{1.01}};
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
