// The answer of `stickslip export` as JSON.
#pragma once
#include "sweep/study/export/effect_targets.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>

namespace stickslip {

/// `why` says a loss in words.
nlohmann::ordered_json export_json(const ExportAnswer& answer, const std::string& text,
                                   const std::function<std::string(const NotExpressible&)>& why);

/// What `export` can write of an effect for each simulator.
nlohmann::ordered_json effect_targets_json(const std::array<EffectTarget, std::size(simulators)>& targets);

}  // namespace stickslip
