// The friction laws that compete for a table of outcomes, each with the numbers that a boundary depends on.
#pragma once
#include "analysis/joint/joint.h"

#include <span>
#include <string_view>
#include <vector>

namespace stickslip::gap {

/// What is usual in a table: numbers of laws are searched around it.
struct OutcomeScales {
    double stiffness = 1, velocity = 1, inertia = 1;
    double level = 1;  ///< friction of the nominal joint at that velocity

    double omega() const;    ///< of the mass on the spring
    double length() const;   ///< velocity/ω
    double damping() const;  ///< mω
};

struct RivalNumber {
    std::string_view name;
    Quantity quantity;
    double low, high;  ///< of the searched number of the same place: a natural logarithm around the scales
};

/// Levels that cancel in the boundary are those of the nominal joint.
struct RivalLaw {
    std::string_view law;     ///< of `list laws`
    std::string_view effect;  ///< of the catalogue, that a nominal joint without it would lack
    bool memory = false;
    std::vector<RivalNumber> numbers;
    FrictionLaw (*make)(const OutcomeScales& scales, const double* x);
    std::vector<double> (*values)(const FrictionLaw& law);  ///< SI, as `numbers` names them
    int scale = -1;     ///< the searched number that stretches motion alone, which only amplitudes show; −1: none
    double effort = 1;  ///< work allowed, in evaluations of the whole table relative to a cheap law
};

std::span<const RivalLaw> rival_laws();

}  // namespace stickslip::gap
