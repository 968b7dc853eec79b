// What delayed friction adds to a loop that knows nothing of it.
#pragma once
#include <complex>
#include <utility>
#include <vector>

#include "analysis/loop/delayed_loop.h"
#include "analysis/loop/resolvent.h"

namespace stickslip {

/// What delayed friction adds to the responses of a mechanism: with the force r of the delayed frictions,
/// r = G (W r + U), rows of the mechanism without them give Q r more.
class DelayedShare {
  public:
    DelayedShare(const Eigen::MatrixXd& A, const Eigen::VectorXd& input, const Eigen::MatrixXd& rows,
                 const std::vector<DelayedFriction>& friction);
    /// What friction i answers at s, and what its delays alone do.
    struct Answer {
        std::complex<double> all, delays;
    };
    static constexpr std::size_t most_delayed = 4;  ///< bodies
    /// Into `added`, one value a row.
    void at(std::complex<double> s, std::complex<double>* added) const;
    /// The same where the answers are known, one a friction, less the first `early` terms of what delays answer: to the
    /// mechanism that does not hear them, to that answer, and so on.
    void at(std::complex<double> s, int early, const Answer* answers, std::complex<double>* added) const;

  private:
    std::vector<DelayedFriction> friction_;
    Eigen::Index rows_;
    Resolvent by_input_;
    std::vector<Resolvent> by_push_;
};

}  // namespace stickslip
