// How the files of the catalogue hand their entries over.
#pragma once
#include "tests/blind/generate/effects.h"
#include "tests/blind/generate/nominal.h"
#include "tests/blind/generate/random.h"

#include <utility>

namespace blind {

struct EffectEntry {
    std::string name;
    std::vector<std::string> families;
    std::function<Edit(const Nominal&, double peak_command, Draw&)> draw;
};

std::vector<EffectEntry> friction_effects();
std::vector<EffectEntry> mechanism_effects();
std::vector<EffectEntry> loop_effects();

using Changed = std::vector<Parameter>;

/// Changes one number of a machine and reports it.
inline Parameter changed(std::string path, double& slot, double value)
{
    return {std::move(path), std::exchange(slot, value), value};
}
/// Where the joint file keeps the friction of the motor (or only body).
inline std::string friction_path(const Machine& m, const std::string& leaf)
{
    return (m.mechanism.bodies == 2 ? "friction.motor." : "friction.") + leaf;
}
inline DryFriction& friction(Machine& m)
{
    return m.mechanism.friction[0];
}
/// A ripple of some periods over the travel; whole numbers of periods a turn for a revolute joint.
Sine draw_ripple(const Nominal& n, Draw& draw);

}  // namespace blind
