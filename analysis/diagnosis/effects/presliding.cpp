#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {

Effect presliding()
{
    Effect e;
    e.name = "presliding";
    e.stage = Stage::friction;
    e.form = "bristles: Dahl or LuGre";
    e.source = "Dahl 1968; Canudas de Wit et al. 1995";
    e.confusable = {"compliance", "backlash", "stribeck"};
    {
        EffectForm f;
        f.name = "dahl";
        f.parameters = {
            {"stiffness", Quantity::stiffness, Scale::friction_stiffness, true, 1, 10000000.0, 1000.0,
             "bristle stiffness"},
        };
        f.apply = [](Joint& j, const double* p) { main_friction(j).bristle = {p[0], 0}; };
        f.seeds = {{30}, {1000}};
        e.forms.push_back(f);
    }
    {
        EffectForm f;
        f.name = "lugre";
        f.parameters = {
            {"stiffness", Quantity::stiffness, Scale::friction_stiffness, true, 1, 10000000.0, 1000.0,
             "bristle stiffness"},
            {"damping", Quantity::damping, Scale::friction_damping, true, 0.001, 1000.0, 1, "bristle damping"},
        };
        f.apply = [](Joint& j, const double* p) { main_friction(j).bristle = {p[0], p[1]}; };
        f.seeds = {{30, 0.3}, {1000, 1}};
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
