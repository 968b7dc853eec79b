// Predictions cut into runs that need nothing of each other, and the kernels that take packs of them through.
#pragma once
#include "analysis/diagnosis/plant/mechanics.h"

namespace stickslip::gap {

/// One stretch of one prediction, from a start to the next restart.
struct Run {
    const Plant* plant;
    const Ticks* ticks;
    std::span<const double> command;
    double omega;
    std::size_t from, to;  ///< ticks
    Rest rest;
    double velocity;   ///< at the start
    double* position;  ///< what the prediction gets wrong, one entry a tick of the whole record
    double* effort;    ///< the same of the effort; null: not wanted
    double* predicted_velocity;
    double* predicted_effort;  ///< null: not wanted, nor the velocity
};

/// Predicts along runs of one kind, several at once. A run's bits depend on no other run and on no instruction set.
void run_baseline(std::span<const Run> runs, const Kind& kind);
void run_avx2(std::span<const Run> runs, const Kind& kind);
void run_avx512(std::span<const Run> runs, const Kind& kind);
/// One after the other.
void run_single(std::span<const Run> runs, const Kind& kind);

/// How the link of this record rests at its start.
Rest rest_at_start(const Plant& plant, const Ticks& ticks);

}  // namespace stickslip::gap
