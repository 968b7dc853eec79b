#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {
namespace {

void scale_viscous(Friction& friction, double factor)
{
    shift_viscous(friction, (factor - 1) * viscous_slope(friction));
}

}  // namespace

Effect viscous()
{
    Effect e;
    e.name = "viscous";
    e.stage = Stage::friction;
    e.form = "F_v v";
    e.source = "Reynolds 1886";
    e.confusable = {"actuator-lag", "effort-gain"};
    {
        EffectForm f;
        f.parameters = {
            {"change", Quantity::damping, Scale::friction_damping, false, -5, 5, 0.2, "change of the viscous slope"},
        };
        f.parameters[0].vanishes = true;
        f.apply = [](Joint& j, const double* p) { shift_viscous(main_friction(j), p[0]); };
        f.seeds = {{0.1}, {-0.1}};
        e.forms.push_back(f);
    }
    {
        EffectForm f;
        f.name = "link";
        f.own_number = true;
        f.parameters = {
            factor_on_number(0.05, 20, 0.3, "true viscous slope on the link per nominal"),
        };
        f.apply = [](Joint& j, const double* p) { scale_viscous(j.frictions.link, p[0]); };
        f.applies = [](const Joint& j) { return main_friction_on_motor(j) && viscous_slope(j.frictions.link) > 0; };
        f.seeds = {{1.5}, {0.7}};
        e.forms.push_back(f);
        f.name = "motor";
        f.parameters[0].help = "true viscous slope on the motor per nominal";
        f.apply = [](Joint& j, const double* p) { scale_viscous(j.frictions.motor, p[0]); };
        f.applies = [](const Joint& j) { return main_friction_on_link(j) && viscous_slope(j.frictions.motor) > 0; };
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
