#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {
namespace {

void remember(Joint& joint, const double* p, MemoryForm form)
{
    Memory& m = main_friction(joint).memory;
    m.A = p[0];
    m.B = p[1];
    m.L = p[2];
    m.V_star = p[3];
    m.form = form;
}

/// Rate-and-state friction; its forms differ in how the state evolves.
EffectForm rate_and_state(std::string_view name)
{
    EffectForm f;
    f.name = name;
    f.parameters = {
        {"A", Quantity::effort, Scale::friction_effort, true, 1e-05, 0.5, 0.02, "direct velocity effect"},
        {"B", Quantity::effort, Scale::friction_effort, true, 1e-05, 1, 0.04, "evolution effect"},
        {"L", Quantity::position, Scale::friction_position, true, 1e-06, 0.5, 0.01, "characteristic slip distance"},
        {"V_star", Quantity::velocity, Scale::friction_velocity, true, 0.0001, 10, 0.1, "reference velocity V*"},
    };
    f.seeds = {{0.02, 0.05, 0.01, 0.1}};
    return f;
}

}  // namespace

Effect frictional_memory()
{
    Effect e;
    e.name = "frictional-memory";
    e.stage = Stage::friction;
    e.form = "rate-and-state memory or a lag";
    e.source = "Dupont 1991, (4)-(5); Hess and Soom 1990";
    e.confusable = {"stribeck", "presliding", "actuator-lag"};
    {
        EffectForm f = rate_and_state("slip");
        f.apply = [](Joint& j, const double* p) { remember(j, p, MemoryForm::slip); };
        f.seeds.push_back({0.02, 0.05, 0.001, 0.5});
        e.forms.push_back(f);
    }
    {
        EffectForm f = rate_and_state("ageing");
        f.apply = [](Joint& j, const double* p) { remember(j, p, MemoryForm::ageing); };
        e.forms.push_back(f);
    }
    {
        EffectForm f;
        f.name = "lag";
        f.parameters = {
            {"c2", Quantity::effort, Scale::friction_effort, false, 0, 3, 0.2, "static friction above Coulomb"},
            {"c3", Quantity::velocity, Scale::friction_velocity, true, 0.0001, 3, 0.1, "Stribeck velocity"},
            {"lag", Quantity::time, Scale::tick, true, 0.5, 300, 10, "time lag of the velocity dependence"},
        };
        f.apply = [](Joint& j, const double* p) {
            set_stribeck(main_friction(j), p[0], p[1], 2);
            main_friction(j).memory.lag = p[2];
        };
        f.seeds = {{0.1, 0.1, 10}};
        // a falling curve that the document lacks, all of it followed late
        f.parts = {{"stribeck", "gaussian"}, {"frictional-memory", "lag-of-curve"}};
        e.forms.push_back(f);
    }
    {
        // the force follows its curve late, the viscous part included
        EffectForm f;
        f.name = "lag-of-curve";
        f.parameters = {
            {"lag", Quantity::time, Scale::tick, true, 0.5, 300, 10, "time lag of the whole curve"},
        };
        f.apply = [](Joint& j, const double* p) {
            main_friction(j).memory.lag = p[0];
            main_friction(j).memory.lag_viscous = true;
        };
        f.seeds = {{5}, {30}, {100}};
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
