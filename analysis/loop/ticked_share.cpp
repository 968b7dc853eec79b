#include "analysis/loop/ticked_share.h"

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>

#include "analysis/numerics/beyond_one.h"

namespace stickslip {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

Eigen::MatrixXd readings_of(const LoopPlant& plant)
{
    Eigen::MatrixXd rows(2, plant.A.cols());
    rows << plant.C, plant.C_v;
    return rows;
}

/// What the controller makes of a reading and of an exact velocity, at z: u = −(…).
std::pair<Complex, Complex> controller_at(const LoopTiming& t, const LoopGains& g, Complex z)
{
    const Complex change = (z - 1.0) / z;  // 1 − 1/z
    Complex of_reading = g.position, of_velocity = 0;
    if (g.integral != 0) of_reading += g.integral * t.period / change;
    if (!g.estimates()) return {of_reading, of_velocity};
    if (t.exact) {
        of_velocity = g.velocity;
        if (g.travelled != 0) of_velocity += g.travelled * t.period / change;
        return {of_reading, of_velocity};
    }
    Complex mean = 0, back = 1;
    for (int i = 0; i < t.average; ++i, back /= z) mean += back;
    const double share = t.period / (t.tau + t.period);
    const Complex smooth = share / (1.0 - (1 - share) / z) * mean / static_cast<double>(t.average);
    return {of_reading + (g.velocity * change / t.period + g.travelled) * smooth, of_velocity};
}

}  // namespace

TickedShare::TickedShare(const TickedFriction& ticked, const std::vector<LateFriction>& friction,
                         const Resolvent& responses)
    : ticked_(ticked),
      period_(ticked.timing.period),
      share_(ticked.plant.A, ticked.plant.B, readings_of(ticked.plant), friction)
{
    constexpr double whole = 1e-12;  // as in sampled_loop()
    const double ticks = ticked_.timing.delay / period_, part = ticks - std::floor(ticks + whole);
    fraction_ = part > whole ? part * period_ : 0;
    take_answers(friction);
    choose_aliases(responses);
}

/// The mechanism behind itself, the speed of the first pushing the second.
void TickedShare::take_answers(const std::vector<LateFriction>& friction)
{
    const auto& plant = ticked_.plant;
    const auto n = plant.A.rows();
    for (const auto& f : friction)
        for (const auto& d : f.delays) {
            LoopPlant twice;
            twice.A = Eigen::MatrixXd::Zero(2 * n, 2 * n);
            twice.A.topLeftCorner(n, n) = twice.A.bottomRightCorner(n, n) = plant.A;
            twice.A.bottomLeftCorner(n, n) = d.weight * f.push * f.speed;
            twice.B = Eigen::VectorXd::Zero(2 * n);
            twice.B.head(n) = plant.B;
            twice.C = twice.C_v = Eigen::RowVectorXd::Zero(2 * n);
            twice.C.tail(n) = plant.C;
            twice.C_v.tail(n) = plant.C_v;
            const LoopTiming timing{period_, fraction_ + d.time, 0, 1, true};
            const auto ticked = loop_without_whole_ticks(twice, timing, {}, {1, 0, 0, 0});
            Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(2, ticked->loop.input.size());
            rows.leftCols(2 * n) = readings_of(twice);
            answers_.push_back({Resolvent(ticked->loop.difference, ticked->loop.input, rows), ticked->whole_ticks});
        }
}

/// As many as leave less than the digits that matter; what is left falls with a high power of the frequency.
void TickedShare::choose_aliases(const Resolvent& responses)
{
    constexpr double left = 1e-11;
    constexpr int fewest = 8, most = 4096;
    for (aliases_ = fewest; aliases_ < most; aliases_ *= 2) {
        bool enough = true;
        for (const double share : {0.03, 0.3, 0.9}) {  // at half the sampling rate a mass answers nothing
            const Complex s(0, share * pi / period_);
            const Added fewer = answered_again(s, aliases_), more = answered_again(s, 2 * aliases_);
            const auto [K, K_v] = controller_at(ticked_.timing, ticked_.turned, std::exp(s * period_));
            std::array<Complex, 2> all;
            responses.at(beyond_one(s * period_), all.data());
            enough &= std::abs(K * (more.reading - fewer.reading)) + std::abs(K_v * (more.rate - fewer.rate)) <
                      left * std::abs(all[0]);
        }
        if (enough) return;
    }
}

TickedShare::Added TickedShare::answered_once(Complex s) const
{
    Added sum{};
    std::array<Complex, 2> values;
    for (const auto& a : answers_) {
        a.of_ticks.at(beyond_one(s * period_), values.data());
        const Complex late = std::exp(-s * (a.whole_ticks * period_));
        sum.reading += late * values[0];
        sum.rate += late * values[1];
    }
    return sum;
}

/// What the delays answer to their own answers, and tables to everything: the response of the mechanism to the hold,
/// sampled by its aliases, Σ P(s + 2πin/T) (1 − e^{−sT})/(T (s + 2πin/T)).
TickedShare::Added TickedShare::answered_again(Complex s, int aliases) const
{
    const double step = 2 * pi / period_;
    const Complex held = -beyond_one(-s * period_) / period_;
    Added sum{};
    std::array<Complex, 2> added;
    const auto take = [&](double shift) {
        const Complex at = s + Complex(0, shift);
        share_.at(at, false, added.data());
        const Complex hold = held / at * std::exp(-at * fraction_);
        sum.reading += hold * added[0];
        sum.rate += hold * added[1];
    };
    for (int n = aliases; n > 0; --n) take(n * step), take(-n * step);
    take(0);
    return sum;
}

std::pair<Complex, Complex> TickedShare::at(Complex s) const
{
    const Added once = answered_once(s), again = answered_again(s, aliases_);
    const Complex reading = once.reading + again.reading, rate = once.rate + again.rate, z = std::exp(s * period_);
    const auto [K, K_v] = controller_at(ticked_.timing, ticked_.turned, z);
    const auto [B, B_v] = controller_at(ticked_.timing, ticked_.base, z);
    return {K * reading + K_v * rate, -(B * reading + B_v * rate)};
}

}  // namespace stickslip
