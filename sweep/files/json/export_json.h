// The answer of `stickslip export` as JSON.
#pragma once
#include "sweep/study/export/export.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>

namespace stickslip {

/// `why` says a loss in words.
nlohmann::ordered_json export_json(const ExportAnswer& answer, const std::string& text,
                                   const std::function<std::string(const NotExpressible&)>& why);

}  // namespace stickslip
