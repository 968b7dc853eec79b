#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {
namespace {

/// On a straight guide gravity is a constant load: a sine of the position in metres is nothing that pulls there.
bool turns(const Joint& j)
{
    return j.mechanism.motion == Motion::revolute || j.load.gravity_amplitude != 0;
}

}  // namespace

Effect gravity()
{
    Effect e;
    e.name = "gravity";
    e.stage = Stage::mechanism;
    e.form = "m g l sin(q + phi)";
    e.source = "Newton 1687";
    e.confusable = {"sensor-offset", "constant-load", "cogging"};
    // a documented one of the wrong sign is off by twice its amplitude, of which a record near the bottom feels little
    constexpr double widest = 10;  // numerical: of the search; a parameter at its bound is implausible
    {
        EffectForm f;
        f.name = "amplitude";
        f.parameters = {
            {"amplitude", Quantity::effort, Scale::load_effort, false, -widest, widest, 0.3, "additional m g l"},
        };
        f.apply = [](Joint& j, const double* p) { add_wave(j.load.gravity_amplitude, j.load.gravity_phase, p[0], 0); };
        f.seeds = {{0}};
        f.applies = turns;
        e.forms.push_back(f);
    }
    {
        EffectForm f;
        f.name = "phase";
        f.parameters = {
            {"sine", Quantity::effort, Scale::load_effort, false, -widest, widest, 0.3, "additional m g l, sine part"},
            {"cosine", Quantity::effort, Scale::load_effort, false, -widest, widest, 0.3, "cosine part"},
        };
        f.apply = [](Joint& j, const double* p) {
            add_wave(j.load.gravity_amplitude, j.load.gravity_phase, p[0], p[1]);
        };
        f.seeds = {{0, 0}};
        f.same_motion = {"sensor-offset"};
        f.applies = turns;
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
