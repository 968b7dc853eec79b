// Motions for an experiment that the machine survives: continuous, and within the stroke, speed and acceleration that
// it has shown.
#pragma once
#include "analysis/results/diagnosis.h"

#include <vector>

namespace stickslip::gap {

/// What a machine has been seen to do.
struct Reach {
    double low = 0, high = 0;  ///< m or rad
    double speed = 0, acceleration = 0;
    double start = 0;  ///< where a motion begins, at rest
};

/// From a sampled motion: speed and acceleration are those of straight lines and parabolas through a few hundredths of
/// a second, so that noise is neither.
Reach reach_of(const std::vector<double>& time, const std::vector<double>& position);
/// What both have shown; the start is that of the first.
Reach together(const Reach& one, const Reach& other);

struct SafeMotion {
    TestMotion kind = TestMotion::none;
    std::vector<double> time, position;
};

/// A small set of cheap motions with different strengths: slow over the whole stroke, small reversals, rising
/// frequency, steps with rests, steps of speed. Each begins and ends at rest at the start.
std::vector<SafeMotion> safe_motions(const Reach& reach, double duration, double period);

}  // namespace stickslip::gap
