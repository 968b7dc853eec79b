// The directions in which a joint may differ from its description: logarithms of magnitudes, and of differences such as
// B − A on which stability hangs more plainly than on B.
#pragma once
#include "analysis/base/field.h"
#include "analysis/joint/parameters.h"
#include "analysis/results/boundary.h"
#include "analysis/results/point.h"

#include <string>
#include <vector>

namespace stickslip {

/// One direction: the number at `path`, or what it exceeds the number at `less` by.
struct Coordinate {
    std::string path, less;
    double scale = 1;  ///< the change of ln(value) that counts as one
};

/// The value of a coordinate; NaN where the joint lacks it, where a number is 0 and where a difference is not positive.
double value_of(const Joint& joint, const Coordinate& coordinate);

/// A joint and its coordinates, resolved once: the walk to a number by its path costs more than a linear verdict.
class MovableJoint {
  public:
    /// Throws std::invalid_argument where a coordinate has no value.
    MovableJoint(const Joint& joint, const std::vector<Coordinate>& coordinates);
    MovableJoint(const MovableJoint&) = delete;  // the numbers point into the joint

    /// The joint with each coordinate's value multiplied by e^{q_i · scale_i}, which keeps its sign: a velocity
    /// backwards stays one. Differences stand on moved numbers.
    /// Holds until the next call.
    const Joint& at(const std::vector<double>& q);
    /// Whether every moved number is one that a joint may have, at the last call of at().
    bool allowed() const;

  private:
    struct Number {
        JointNumber value;
        const double* less;  ///< null for a plain number
        double from, scale;
        Range range;
    };
    Joint joint_;
    std::vector<Number> numbers_;
};

/// One moved joint.
Joint moved(const Joint& joint, const std::vector<Coordinate>& coordinates, const std::vector<double>& q);

/// What nature may change: every friction number that the linear theory reads, inertias, transmission
/// stiffnesses and the commanded velocity. One state of a rate-and-state law: A, B − A and L.
std::vector<Coordinate> natural_coordinates(const Joint& joint);

/// The friction part of them.
std::vector<Coordinate> friction_coordinates(const Joint& joint);

}  // namespace stickslip
