// What friction that answers late adds to a loop that knows nothing of it.
#pragma once
#include <complex>
#include <utility>
#include <vector>

#include "analysis/loop/late_loop.h"
#include "analysis/loop/resolvent.h"

namespace stickslip {

/// What friction that answers late adds to the responses of a mechanism: with the force r of the late frictions,
/// r = G (W r + U), rows of the mechanism without them give Q r more.
class LateShare {
  public:
    LateShare(const Eigen::MatrixXd& A, const Eigen::VectorXd& input, const Eigen::MatrixXd& rows,
              const std::vector<LateFriction>& friction);
    /// Into `added`, one value a row. `once`: with what delays answer to the mechanism that does not hear them.
    void at(std::complex<double> s, bool once, std::complex<double>* added) const;

  private:
    std::vector<LateFriction> friction_;
    Eigen::Index rows_;
    Resolvent by_input_;
    std::vector<Resolvent> by_push_;
};

}  // namespace stickslip
