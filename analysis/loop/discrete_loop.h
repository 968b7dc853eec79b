// A linear mechanism under a controller that reads, computes and holds tick by tick: the exact map from one sample to
// the next, with one gain left open.
#pragma once
#include <Eigen/Core>
#include <optional>

namespace stickslip {

/// The mechanism and what stands between the arriving command and it: ẋ = A x + B w, reading y = C x, its rate C_v x.
struct LoopPlant {
    Eigen::MatrixXd A;
    Eigen::VectorXd B;
    Eigen::RowVectorXd C, C_v;
};

/// u = −(position y + velocity v + integral Σ T y + travelled Σ T v), v the estimate. The last term is that of a
/// cascade whose estimate does not sum to the position.
struct LoopGains {
    double position = 0, velocity = 0, integral = 0, travelled = 0;

    bool estimates() const { return velocity != 0 || travelled != 0; }
};

/// Estimate (docs/theory.md, real loops): ȳ the mean of the last `average` readings, d = (ȳ_k − ȳ_{k−1})/T,
/// v_k = v_{k−1} + T/(τ + T)(d − v_{k−1}); `exact`: v = C_v x.
struct LoopTiming {
    double period = 0, delay = 0, tau = 0;
    int average = 1;
    bool exact = false;
};

/// X_{k+1} = (I + difference − g input output) X_k: `difference` is M − I, which keeps what M loses in short periods.
struct DiscreteLoop {
    Eigen::MatrixXd difference;
    Eigen::VectorXd input;
    Eigen::RowVectorXd output;
    double period = 0;

    /// M − I with the gain closed.
    Eigen::MatrixXd closed(double gain) const { return difference - gain * (input * output); }
};

/// The loop from sample to sample: the mechanism, past readings, the filter, the integral, and the commands that dead
/// time still holds back, whole ticks and a fraction. `base` acts, `turned` acts g times.
DiscreteLoop discrete_loop(const LoopPlant& plant, const LoopTiming& timing, const LoopGains& base,
                           const LoopGains& turned);

/// The same with the whole ticks of its dead time left aside: X_{k+1} = (1 + difference) X_k + input w_{k −
/// whole_ticks}, w = held X − g output X. Nothing where what is turned acts in two places of the loop.
struct LoopOfTicks {
    DiscreteLoop loop;
    Eigen::RowVectorXd held;
    int whole_ticks = 0;
    bool acts_twice = false;
};
std::optional<LoopOfTicks> loop_without_whole_ticks(const LoopPlant& plant, const LoopTiming& timing,
                                                    const LoopGains& base, const LoopGains& turned);

/// ∫ e^{As} ds from 0 to h, by doubling a short step, so that e^{Ah} − 1 = A ∫ keeps its digits.
Eigen::MatrixXd integral_of_exponential(const Eigen::MatrixXd& A, double h);

}  // namespace stickslip
