#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {

Effect load_dependent_friction()
{
    Effect e;
    e.name = "load-dependent-friction";
    e.stage = Stage::friction;
    e.form = "mu |transmitted effort| sgn v";
    e.source = "Amontons 1699";
    e.confusable = {"effort-gain", "coulomb-level", "stribeck"};
    {
        EffectForm f;
        f.parameters = {
            {"coefficient", Quantity::number, Scale::one, false, 0, 0.9, 0.1, "friction per transmitted effort"},
        };
        f.apply = [](Joint& j, const double* p) { main_friction(j).load_coefficient += p[0]; };
        f.seeds = {{0.05}};
        e.forms.push_back(f);
    }
    {
        EffectForm f;
        f.name = "gear";
        f.parameters = {
            {"forward", Quantity::number, Scale::one, false, 0, 0.9, 0.1,
             "friction per effort at the load, driving it"},
            {"backward", Quantity::number, Scale::one, false, 0, 0.95, 0.3, "the same, driven by it"},
            {"beyond", Quantity::number, Scale::one, false, 0, 1, 0.5, "part of the inertia on the side of the load"},
        };
        f.apply = [](Joint& j, const double* p) {
            auto& gear = j.friction.gear;
            gear.forward += p[0], gear.backward += p[1], gear.beyond = p[2];
        };
        f.applies = [](const Joint& j) { return j.mechanism.model == Model::single_mass; };
        f.seeds = {{0.05, 0.3, 0.7}};
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
