// What an effect of the catalogue is called in a sentence or a table.
#pragma once
#include <string>
#include <string_view>

namespace stickslip {

/// "frictional-memory" → "frictional memory", "gain-k_p" → "position gain"; a path of a joint file stays as it is.
std::string effect_words(std::string_view name);

}  // namespace stickslip
