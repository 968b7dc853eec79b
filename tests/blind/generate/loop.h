// The sampled loop round the mechanism, and the record that it leaves.
#pragma once
#include "tests/blind/generate/excitation.h"
#include "tests/blind/generate/machine.h"

#include <cstdint>
#include <vector>

namespace blind {

/// One record, one entry a logged sample. `command` is in units of the drive signal, `effort` in N or N·m.
struct Record {
    std::vector<double> time, reference_position, reference_velocity, position, velocity, command, effort, current,
        supply, link_position;
    std::vector<double> true_position, true_velocity;  ///< for checks only; never written
    std::size_t size() const { return time.size(); }
};

/// Runs the loop for one record. `stride` = 2 logs every second sample. The noise is decided by `noise_seed` alone.
/// Throws std::runtime_error if the motion runs away.
Record run_loop(const Machine& machine, const Excitation& excitation, std::uint64_t noise_seed, int stride = 1);

}  // namespace blind
