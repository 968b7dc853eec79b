// answer.json beside results.nc: everything that a page of the sweep is drawn from and that its points do not say.
#pragma once
#include "sweep/study/sweep_answer.h"

#include <filesystem>
#include <optional>
#include <string_view>

namespace stickslip {

inline constexpr char sweep_answer_name[] = "answer.json";
inline constexpr char sweep_answer_format[] = "stickslip-sweep/6";

/// Whole or not at all. Throws as write_whole does.
void write_sweep_answer(const SweepAnswer& answer, const std::filesystem::path& directory);

/// Nothing where there is no such file, or one of another sweep (`plan_id`) or of another format: it is computed again
/// then. Throws BadInput for a file that is none of ours.
std::optional<SweepAnswer> read_sweep_answer(const std::filesystem::path& directory, std::string_view plan_id);

}  // namespace stickslip
