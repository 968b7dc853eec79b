#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {

Effect dead_zone()
{
    Effect e;
    e.name = "dead-zone";
    e.stage = Stage::controller;
    e.in_command = true;
    e.form = "position errors within the zone count as none";
    e.source = "Armstrong-Helouvry, Dupont and Canudas de Wit 1994";
    e.confusable = {"gain-k_p", "backlash"};
    {
        EffectForm f;
        f.parameters = {
            factor_on_number(0.1, 10, 0.3, "true zone per documented", "width"),
        };
        f.apply = [](Joint& j, const double* p) { j.control.dead_zone *= p[0]; };
        f.seeds = {{1.2}, {0.8}};
        f.applies = [](const Joint& j) { return j.control.dead_zone > 0; };
        e.forms.push_back(f);
    }
    {
        EffectForm f;
        f.name = "undocumented";
        f.parameters = {
            {"zone", Quantity::position, Scale::position, true, 1e-4, 0.5, 0.02, "half the zone"},
        };
        f.apply = [](Joint& j, const double* p) { j.control.dead_zone = p[0]; };
        f.seeds = {{0.003}, {0.01}, {0.03}};
        f.applies = [](const Joint& j) { return !(j.control.dead_zone > 0); };
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
