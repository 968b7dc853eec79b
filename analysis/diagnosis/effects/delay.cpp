#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {

Effect delay()
{
    Effect e;
    e.name = "delay";
    e.stage = Stage::controller;
    e.form = "u(t - T)";
    e.source = "Franklin, Powell and Workman 1998";
    e.confusable = {"actuator-lag", "velocity-filter", "compliance"};
    {
        EffectForm f;
        f.parameters = {
            {"time", Quantity::time, Scale::tick, false, 0, 60, 2, "additional dead time between command and effort"},
        };
        f.apply = [](Joint& j, const double* p) { j.control.delay += p[0]; };
        f.parameters[0].jumps = true;
        for (int ticks = 0; ticks < 25; ++ticks) f.seeds.push_back({ticks + 0.5});
        e.forms.push_back(f);
        // round the loop the two are one: what tells them apart is whether the logged effort is late, too
        f.name = "of-the-reading";
        f.parameters[0].help = "additional dead time of the position's reading";
        f.parameters[0].jumps = false;
        f.apply = [](Joint& j, const double* p) { j.sensor.delay += p[0]; };
        e.forms.push_back(f);
        // on a bus, behind a filter: a dead time that is smeared
        f = e.forms[0];
        f.name = "with-lag";
        f.parameters.push_back({"lag", Quantity::number, Scale::one, true, 0.02, 1.2, 0.3,
                                "time constant of the actuator, in dead times"});
        f.apply = [](Joint& j, const double* p) { j.control.delay += p[0], j.actuator.lag += p[0] * p[1]; };
        f.seeds = {{2.5, 0.4}, {8.5, 0.4}};
        f.parts = {{"delay", ""}};
        f.mixed_with = "actuator-lag";
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
