// Motions that creep: the amplitude changes little from turn to turn, and by how much says where it would stop.
#pragma once
#include "analysis/results/point.h"

#include <limits>

namespace stickslip {

/// Amplitudes at which a motion was seen to grow and to shrink, and the logarithm of the change per turn there.
class Creep {
  public:
    void note(double size, double growth);
    /// Growth below and decay above: a cycle that attracts lies between.
    bool bracketed() const;
    /// Where between them a line in amplitude² vanishes, kept off the ends that it would creep along.
    double middle() const;
    /// Whether so little growth determines the amplitude of the cycle well enough.
    bool located(double size, double growth) const;
    /// The amplitude to look at next; `ahead` as below.
    double next(double size, double growth, double ahead) const;

  private:
    double grows_at_ = 0, shrinks_at_ = std::numeric_limits<double>::infinity(), grows_by_ = missing,
           shrinks_by_ = missing;
};

/// The amplitude in the direction of the motion at which its growth would vanish if it were a line in amplitude²; not a
/// number where none lies within reach.
double amplitude_ahead(double size, double growth, double last_growth);

}  // namespace stickslip
