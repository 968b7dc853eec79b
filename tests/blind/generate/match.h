// How well the MuJoCo mechanism and the own one agree when nothing is noisy: what the blind test cases of both rest on.
#pragma once
#include "tests/blind/generate/nominal.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace blind {

struct Match {
    std::string family, excitation;
    double rms = 0, largest = 0;  ///< position difference, in standard deviations of the joint's own reading noise
};

/// Draws `count` nominal joints, one record each, and simulates them twice without noise.
std::vector<Match> match_mujoco(const std::filesystem::path& folder, std::uint64_t seed, int count);

}  // namespace blind
