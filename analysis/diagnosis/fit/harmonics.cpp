// The flexible member of waves over the position: a short Fourier series.
#include "analysis/diagnosis/fit/effect.h"

namespace stickslip::gap {

EffectForm with_second_harmonic(EffectForm form, void (*apply)(Joint& joint, const double* p))
{
    form.name = "two-harmonics";
    form.apply = apply;
    EffectParameter sine = form.parameters[0], cosine = form.parameters[1];
    sine.name = "second_sine", sine.help = "sine part of the second harmonic";
    cosine.name = "second_cosine", cosine.help = "cosine part of the second harmonic";
    form.parameters.push_back(sine), form.parameters.push_back(cosine);
    for (auto& seed : form.seeds) seed.resize(form.parameters.size(), 0);
    return form;
}

void add_harmonics(PositionRipple& ripple, const double* p)
{
    ripple.periods = p[2];
    add_wave(ripple.amplitude, ripple.phase, p[0], p[1]);
    add_wave(ripple.second_amplitude, ripple.second_phase, p[3], p[4]);
}

}  // namespace stickslip::gap
