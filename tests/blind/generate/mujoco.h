// Records from MuJoCo instead of from this generator's own mechanism.
#pragma once
#include "tests/blind/generate/loop.h"

#include <filesystem>
#include <string>
#include <vector>

namespace blind {

/// Effects and outside causes for which the MuJoCo mechanism has no element.
bool mujoco_has(const std::string& cause);

/// Simulates record r of machine r under excitation r, with `seeds[r]`, by running node on `folder`/simulate.mjs.
/// Throws std::runtime_error if that fails.
std::vector<Record> run_mujoco(const std::filesystem::path& folder, const std::vector<Machine>& machines,
                               const std::vector<Excitation>& excitations, const std::vector<std::uint64_t>& seeds,
                               int stride);

}  // namespace blind
