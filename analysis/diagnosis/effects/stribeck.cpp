#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {

Effect stribeck()
{
    Effect e;
    e.name = "stribeck";
    e.stage = Stage::friction;
    e.form = "c2 exp(-(|v|/c3)^c4) sgn v";
    e.source = "Dupont 1991, (7)";
    e.confusable = {"frictional-memory", "presliding", "coulomb-level"};
    {
        EffectForm f;
        f.name = "gaussian";
        f.parameters = {
            {"c2", Quantity::effort, Scale::friction_effort, false, 0, 3, 0.2, "static friction above Coulomb"},
            {"c3", Quantity::velocity, Scale::friction_velocity, true, 0.0001, 3, 0.1, "Stribeck velocity"},
        };
        f.apply = [](Joint& j, const double* p) { set_stribeck(main_friction(j), p[0], p[1], 2); };
        f.seeds = {{0.1, 0.03}, {0.1, 0.3}};
        // a peak that hardly falls over the speeds of the records
        f.parts = {{"coulomb-level", ""}};
        e.forms.push_back(f);
    }
    {
        EffectForm f;
        f.name = "exponential";
        f.parameters = {
            {"c2", Quantity::effort, Scale::friction_effort, false, 0, 3, 0.2, "static friction above Coulomb"},
            {"c3", Quantity::velocity, Scale::friction_velocity, true, 0.0001, 3, 0.1, "Stribeck velocity"},
        };
        f.apply = [](Joint& j, const double* p) { set_stribeck(main_friction(j), p[0], p[1], 1); };
        f.seeds = {{0.1, 0.1}};
        f.parts = {{"coulomb-level", ""}};
        e.forms.push_back(f);
    }
    {
        // peaks of other shapes: low exponents fall steeply and have long tails
        EffectForm f;
        f.name = "any-exponent";
        f.parameters = {
            {"c2", Quantity::effort, Scale::friction_effort, false, 0, 3, 0.2, "static friction above Coulomb"},
            {"c3", Quantity::velocity, Scale::friction_velocity, true, 0.0001, 3, 0.1, "Stribeck velocity"},
            {"c4", Quantity::number, Scale::one, true, 0.3, 4, 1, "exponent of the Stribeck curve"},
        };
        f.apply = [](Joint& j, const double* p) { set_stribeck(main_friction(j), p[0], p[1], p[2]); };
        f.seeds = {{0.1, 0.1, 0.7}};
        f.parts = {{"coulomb-level", ""}};
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
