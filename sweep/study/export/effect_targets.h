// What a simulator can say of each effect of the catalogue.
#pragma once
#include "analysis/diagnosis/fit/effect.h"
#include "sweep/study/export/export.h"

#include <array>
#include <vector>

namespace stickslip {

struct EffectTarget {
    enum class Says { all, part, nothing } says = Says::nothing;
    std::vector<NotExpressible> lost;  ///< keys of the effect that the text cannot have
};

constexpr std::string_view name_of(EffectTarget::Says says)
{
    constexpr std::string_view names[] = {"all", "part", "nothing"};
    return names[static_cast<std::size_t>(says)];
}

/// What an effect does to a joint that can have it.
struct EffectEdit {
    Joint edited, larger;              ///< the effect at a usual size, and larger
    std::vector<std::string> changed;  ///< keys that differ from the joint without it
    /// Those of them that follow the effect's size. Behind compliance or backlash the others divide the mass and its
    /// friction, behind a Stribeck peak they state the level that was there before: a simulator that has these alone
    /// has nothing of the effect.
    std::vector<std::string> own;
};

/// By the effect's first form.
EffectEdit usual_edit(const gap::Effect& effect);

/// One entry a simulator, in their order: the keys that the usual edit changes, held against what an export of that
/// joint has to leave out.
std::array<EffectTarget, std::size(simulators)> targets_of(const gap::Effect& effect);

}  // namespace stickslip
