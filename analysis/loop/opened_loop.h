// A late loop opened at its command, at any s: what every search over it asks.
#pragma once
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

class OpenedLoop {
  public:
    using Complex = std::complex<double>;
    explicit OpenedLoop(const LateLoop& loop);

    /// output (…)⁻¹ input and held (…)⁻¹ input, without dead time.
    std::pair<Complex, Complex> prompt(Complex s) const;
    Complex late(Complex s) const { return std::exp(-s * delay_); }
    /// 1 + L(s) and its derivative, all gains closed.
    Response closing(double gain, Complex s) const;
    /// −T of the turned gain, the base closed: a positive real number where a positive gain puts a root at s.
    Complex towards(Complex s) const;

    /// Up to where the imaginary axis is looked at: half the sampling rate, or without end.
    double end() const { return end_; }
    /// Over which the phase turns by one radian without anything else in the loop.
    double turns_in() const { return turns_in_; }
    /// The poles of what is no late friction.
    const std::vector<Complex>& poles() const { return poles_; }
    /// Those that are poles of the whole opened loop, too.
    const std::vector<Complex>& exact_poles() const { return exact_poles_; }
    /// How many poles of the opened loop lie right of Re s = σ. Those at 0, within rounding, count as `at_zero`.
    struct Right {
        int poles = 0;
        bool at_zero = false;
        double size = 0;
    };
    std::optional<Right> right_of(double sigma) const;
    /// How far s is from the nearest pole: no wider step sees what happens there.
    double room(Complex s) const;

  private:
    Complex variable(Complex s) const;
    /// What late friction adds to the sampled reading and its rate.
    struct Added {
        Complex reading, rate;
    };
    /// One delay's answer to the mechanism that does not hear it, from tick to tick.
    struct Answer {
        Resolvent of_ticks;
        int whole_ticks;
    };
    std::pair<Complex, Complex> late_share(Complex s) const;
    Added answered_once(Complex s) const;
    Added answered_again(Complex s, int aliases) const;
    void take_answers(const std::vector<LateFriction>& friction);
    void choose_aliases();

    double delay_, period_, end_, turns_in_;
    Resolvent responses_;
    std::vector<Complex> poles_, exact_poles_;
    std::function<std::optional<int>(double)> mechanism_right_of_;
    std::vector<double> other_poles_;
    std::shared_ptr<const TickedFriction> ticked_;
    std::optional<LateShare> share_;
    std::vector<Answer> answers_;
    double fraction_ = 0;  ///< s, of the dead time beyond whole ticks
    int aliases_ = 0;
};

/// e^x − 1 with its digits.
std::complex<double> beyond_one(std::complex<double> x);

}  // namespace stickslip
