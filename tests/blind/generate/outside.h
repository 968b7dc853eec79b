// Causes that the catalogue does not have. The right answer to them is "unknown".
#pragma once
#include "tests/blind/generate/machine.h"

#include <string>
#include <utility>
#include <vector>

namespace blind {

/// The force of an outside cause and its factor on inertia. Random ones are fixed by their seed.
class OutsideForce {
  public:
    explicit OutsideForce(const Outside& outside);
    double force(double t, double q, double v) const;
    double inertia_factor(double t) const;
    /// Tells the force where the motion has got to: a hysteretic load remembers it.
    void arrive(double q) { follower_ = followed(q); }
    void start(double q) { follower_ = q; }

  private:
    double followed(double q) const;

    Outside outside_;
    double follower_ = 0;          ///< hysteretic load: what the spring sees behind its play
    std::vector<double> samples_;  ///< random force: values at knots; bumps: signs
};

/// Every outside cause with its name.
const std::vector<std::pair<std::string, Outside::Kind>>& outside_kinds();

}  // namespace blind
