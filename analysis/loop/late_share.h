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
    /// What friction i answers at s, and what its delays alone do.
    struct Answer {
        std::complex<double> all, delays;
    };
    static constexpr std::size_t most_late = 4;  ///< bodies
    /// Into `added`, one value a row.
    void at(std::complex<double> s, std::complex<double>* added) const;
    /// The same where the answers are known, one a friction, less the first `early` terms of what delays answer: to the
    /// mechanism that does not hear them, to that answer, and so on.
    void at(std::complex<double> s, int early, const Answer* answers, std::complex<double>* added) const;

  private:
    std::vector<LateFriction> friction_;
    Eigen::Index rows_;
    Resolvent by_input_;
    std::vector<Resolvent> by_push_;
};

}  // namespace stickslip
