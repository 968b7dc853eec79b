#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {

Effect cogging()
{
    Effect e;
    e.name = "cogging";
    e.stage = Stage::mechanism;
    e.form = "A sin(n q + phi)";
    e.source = "Hanselman 2006";
    e.confusable = {"position-dependent-friction", "periodic-disturbance"};
    {
        EffectForm f;
        f.parameters = {
            {"sine", Quantity::effort, Scale::load_effort, false, -2, 2, 0.1, "sine part"},
            {"cosine", Quantity::effort, Scale::load_effort, false, -2, 2, 0.1, "cosine part"},
            {"periods", Quantity::per_position, Scale::load_wave_number, true, 1, 2000, 20, "angular wave number n",
             FrequencyGrid::position},
        };
        f.apply = [](Joint& j, const double* p) {
            PositionRipple& r = j.load.cogging;
            r.periods = p[2];
            add_wave(r.amplitude, r.phase, p[0], p[1]);
        };
        f.seeds = {{0, 0, 0}};
        e.forms.push_back(f);
        // slots and poles of a motor make series, not sines
        e.flexible = {with_second_harmonic(f, [](Joint& j, const double* p) { add_harmonics(j.load.cogging, p); })};
    }
    return e;
}

}  // namespace stickslip::gap
