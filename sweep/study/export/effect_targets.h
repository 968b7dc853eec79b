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

/// One entry a simulator, in their order: the keys that an edit by the effect's first form changes in a joint that can
/// have it, held against what an export of that joint has to leave out.
std::array<EffectTarget, std::size(simulators)> targets_of(const gap::Effect& effect);

}  // namespace stickslip
