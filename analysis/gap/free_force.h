// Forces without a name: what shape-free functions of position or velocity alone can explain. They belong to no effect
// of the catalogue, and to no joint file: where one explains the records clearly better than any cause, the cause is
// only the nearest in shape, and is not named.
#pragma once
#include "analysis/gap/attribute.h"

#include <string_view>

namespace stickslip::gap {

struct FreeFit {
    std::string_view of;  ///< "position" | "velocity"
    Attribution fit;
};

/// Both shapes, fitted at all levels; the better one first.
std::vector<FreeFit> fit_free_forces(const std::vector<Case>& cases, const Scales& scales, const Nominal& nominal,
                                     const ParallelFor& parallel);

/// Of mean log misfit: a better fit by less says nothing.
inline constexpr double least_of_free_force = 0.004;

/// Whether a shape-free force leaves clearly less of the misfit than a cause does. Its many parameters cost nothing
/// here: on tens of thousands of rows they fit next to no noise.
bool clearly_better(const FreeFit& free, const Attribution& cause);

}  // namespace stickslip::gap
