// How far a nominal description is from the records, and how far the true one: what the best diagnosis could achieve.
#pragma once
#include "tests/blind/generate/loop.h"

#include <string>
#include <vector>

namespace blind {

/// One signal that a case logs and that a simulation of the closed loop predicts.
struct Signal {
    std::string name, unit;
    std::vector<double> Record::*values;
};

struct SignalGap {
    std::string name, unit;
    double before = 0, after = 0, floor = 0;  ///< RMS in the signal's unit
};

/// `before` and `after` in units of the floor: RMS over the signals, each scaled by its own floor.
struct Gap {
    double before = 0, after = 0;
    std::vector<SignalGap> signals;
    std::vector<double> before_by_record;
};

/// ensemble[r][i]: record r simulated with the i-th noise.
using Ensemble = std::vector<std::vector<Record>>;

/// Runs machine r under excitation r, `count` times with different noise.
Ensemble simulate_often(const std::vector<Machine>& machines, const std::vector<Excitation>& excitations, int count,
                        std::uint64_t seed, int stride);

/// The floor of a signal is what two noisy simulations of the nominal joint differ by; before and after are the mean
/// square difference between the records and the members of the ensembles.
Gap closed_loop_gap(const std::vector<Record>& records, const Ensemble& nominal, const Ensemble& truth,
                    const std::vector<Signal>& signals);

}  // namespace blind
