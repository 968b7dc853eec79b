#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {

Effect position_dependent_friction()
{
    Effect e;
    e.name = "position-dependent-friction";
    e.stage = Stage::friction;
    e.form = "F_c(q) sgn v";
    e.source = "Armstrong-Helouvry 1991";
    e.confusable = {"cogging"};
    {
        EffectForm f;
        f.parameters = {
            {"sine", Quantity::effort, Scale::friction_effort, false, -2, 2, 0.1,
             "sine part of the change of the Coulomb level"},
            {"cosine", Quantity::effort, Scale::friction_effort, false, -2, 2, 0.1, "cosine part"},
            {"periods", Quantity::per_position, Scale::friction_wave_number, true, 1, 2000, 20, "angular wave number n",
             FrequencyGrid::position_flipped},
        };
        f.apply = [](Joint& j, const double* p) {
            PositionRipple& r = main_friction(j).ripple;
            r.periods = p[2];
            add_wave(r.amplitude, r.phase, p[0], p[1]);
        };
        f.seeds = {{0, 0, 0}};
        e.forms.push_back(f);
        e.flexible = {
            with_second_harmonic(f, [](Joint& j, const double* p) { add_harmonics(main_friction(j).ripple, p); })};
    }
    return e;
}

}  // namespace stickslip::gap
