#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {

Effect periodic_disturbance()
{
    Effect e;
    e.name = "periodic-disturbance";
    e.stage = Stage::outside;
    e.form = "A sin(omega t + phi)";
    e.source = "Francis and Wonham 1976";
    e.confusable = {"cogging"};
    {
        EffectForm f;
        f.parameters = {
            {"sine", Quantity::effort, Scale::load_effort, false, -2, 2, 0.1, "sine part"},
            {"cosine", Quantity::effort, Scale::load_effort, false, -2, 2, 0.1, "cosine part"},
            {"frequency", Quantity::angular_frequency, Scale::angular_frequency, true, 0.3, 600, 20,
             "angular frequency", FrequencyGrid::time},
        };
        f.apply = [](Joint& j, const double* p) {
            PeriodicForce& d = j.load.disturbance;
            d.frequency = p[2];
            add_wave(d.amplitude, d.phase, p[0], p[1]);
        };
        f.seeds = {{0, 0, 0}};
        e.forms.push_back(f);
    }
    {
        // records rarely start in step with what disturbs them
        EffectForm f;
        f.name = "phase-of-each-record";
        f.parameters = {
            {"frequency", Quantity::angular_frequency, Scale::angular_frequency, true, 0.3, 600, 20,
             "angular frequency", FrequencyGrid::time},
            {"sine", Quantity::effort, Scale::load_effort, false, -2, 2, 0.1, "sine part"},
            {"cosine", Quantity::effort, Scale::load_effort, false, -2, 2, 0.1, "cosine part"},
        };
        f.own = 2;
        f.apply = [](Joint& j, const double* p) {
            PeriodicForce& d = j.load.disturbance;
            d.frequency = p[0];
            add_wave(d.amplitude, d.phase, p[1], p[2]);
        };
        f.seeds = {{0, 0, 0}};
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
