#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {

Effect actuator_lag()
{
    Effect e;
    e.name = "actuator-lag";
    e.stage = Stage::actuator;
    e.form = "1/(1 + s tau)";
    e.source = "Franklin, Powell and Workman 1998";
    e.confusable = {"delay", "compliance"};
    {
        EffectForm f;
        f.parameters = {
            {"tau", Quantity::time, Scale::tick, true, 0.1, 100, 5, "true time constant of the actuator"},
        };
        f.apply = [](Joint& j, const double* p) { j.actuator.lag = p[0]; };
        f.seeds = {{2}, {8}};
        e.forms.push_back(f);
        // of more poles than one: what the smaller time constants add is a dead time to a slower motion
        f.name = "with-dead-time";
        f.parameters.push_back({"dead_time", Quantity::number, Scale::one, true, 0.02, 1.2, 0.3,
                                "dead time behind the command, in time constants"});
        f.apply = [](Joint& j, const double* p) { j.actuator.lag = p[0], j.control.delay += p[0] * p[1]; };
        f.seeds = {{2, 0.4}, {8, 0.4}};
        f.parts = {{"actuator-lag", ""}};
        f.mixed_with = "delay";
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
