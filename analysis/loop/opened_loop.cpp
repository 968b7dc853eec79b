// In one file: one function of s, of every kind of late loop.
#include "analysis/loop/opened_loop.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <numbers>
#include <numeric>

#include "analysis/numerics/balance.h"

namespace stickslip {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

Eigen::VectorXcd eigenvalues_of(Eigen::MatrixXd matrix)
{
    if (!matrix.allFinite()) return {};
    balance(matrix);
    return matrix.eigenvalues();
}

/// The eigenvalues of A: integrators, states that no rate depends on, are at 0 to the last digit.
std::vector<Complex> poles_of(const Eigen::MatrixXd& A)
{
    std::vector<Eigen::Index> kept(static_cast<std::size_t>(A.rows()));
    std::iota(kept.begin(), kept.end(), 0);
    std::vector<Complex> poles;
    for (bool found = true; found;) {
        found = false;
        for (std::size_t i = 0; i < kept.size(); ++i) {
            const auto asks = [&](Eigen::Index k) { return A(k, kept[i]) != 0; };
            if (std::any_of(kept.begin(), kept.end(), asks)) continue;
            poles.push_back(0);
            kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
            found = true;
            break;
        }
    }
    if (kept.empty()) return poles;
    const auto others = eigenvalues_of(A(kept, kept));
    poles.insert(poles.end(), others.begin(), others.end());
    return poles;
}

/// ln(1 + v) with its digits.
Complex log_beyond_one(Complex v)
{
    return {0.5 * std::log1p(2 * v.real() + std::norm(v)), std::arg(1.0 + v)};
}

Eigen::MatrixXd both(const LateLoop& loop)
{
    Eigen::MatrixXd rows(2, loop.A.cols());
    rows << loop.output, loop.held;
    return rows;
}

Eigen::MatrixXd with_speeds(const Eigen::MatrixXd& rows, const std::vector<LateFriction>& friction)
{
    Eigen::MatrixXd all(rows.rows() + static_cast<Eigen::Index>(friction.size()), rows.cols());
    all.topRows(rows.rows()) = rows;
    for (std::size_t i = 0; i < friction.size(); ++i)
        all.row(rows.rows() + static_cast<Eigen::Index>(i)) = friction[i].speed;
    return all;
}

Eigen::MatrixXd readings_of(const LoopPlant& plant)
{
    Eigen::MatrixXd rows(2, plant.A.cols());
    rows << plant.C, plant.C_v;
    return rows;
}

constexpr std::size_t most_late = 4;  ///< bodies

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

Complex beyond_one(Complex x)
{
    const double half = std::sin(x.imag() / 2), grown = std::exp(x.real());
    return {std::expm1(x.real()) - 2 * grown * half * half, grown * std::sin(x.imag())};
}

LateShare::LateShare(const Eigen::MatrixXd& A, const Eigen::VectorXd& input, const Eigen::MatrixXd& rows,
                     const std::vector<LateFriction>& friction)
    : friction_(friction), rows_(rows.rows()), by_input_(A, input, with_speeds(rows, friction))
{
    for (const auto& f : friction_) by_push_.emplace_back(A, f.push, with_speeds(rows, friction_));
}

void LateShare::at(Complex s, bool once, Complex* added) const
{
    const auto m = static_cast<Eigen::Index>(friction_.size());
    std::array<Complex, 4 + most_late> values;
    by_input_.at(s, values.data());
    Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, 0, most_late, most_late> closed(m, m);
    Eigen::Matrix<Complex, Eigen::Dynamic, 1, 0, most_late, 1> force(m);
    Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, 0, 4, most_late> by_force(rows_, m);
    std::array<Complex, most_late> answer, first{};
    for (Eigen::Index i = 0; i < m; ++i) {
        answer[static_cast<std::size_t>(i)] = friction_[static_cast<std::size_t>(i)].answer(s);
        force[i] = answer[static_cast<std::size_t>(i)] * values[static_cast<std::size_t>(rows_ + i)];
        if (once) continue;
        Complex sum = 0;
        for (const auto& d : friction_[static_cast<std::size_t>(i)].delays) sum += d.weight * std::exp(-s * d.time);
        first[static_cast<std::size_t>(i)] = sum * values[static_cast<std::size_t>(rows_ + i)];
    }
    for (Eigen::Index k = 0; k < m; ++k) {
        by_push_[static_cast<std::size_t>(k)].at(s, values.data());
        for (Eigen::Index r = 0; r < rows_; ++r) by_force(r, k) = values[static_cast<std::size_t>(r)];
        for (Eigen::Index i = 0; i < m; ++i)
            closed(i, k) = (i == k ? 1.0 : 0.0) -
                           answer[static_cast<std::size_t>(i)] * values[static_cast<std::size_t>(rows_ + i)];
    }
    if (m == 1)
        force[0] /= closed(0, 0);
    else
        force = closed.partialPivLu().solve(force).eval();
    for (Eigen::Index i = 0; i < m; ++i) force[i] -= first[static_cast<std::size_t>(i)];
    for (Eigen::Index r = 0; r < rows_; ++r) added[r] = (by_force.row(r) * force)(0);
}

OpenedLoop::OpenedLoop(const LateLoop& loop)
    : delay_(loop.delay),
      period_(loop.period),
      end_(loop.period > 0 ? pi / loop.period : infinity),
      turns_in_(infinity),
      responses_(loop.A, loop.input, both(loop)),
      mechanism_right_of_(loop.mechanism_right_of),
      other_poles_(loop.other_poles),
      ticked_(loop.ticked)
{
    for (const Complex& v : poles_of(loop.A)) {
        constexpr double forgotten = 1e-6;   // a multiplier that is gone within a few ticks
        constexpr double integrates = 1e-9;  // a multiplier that only rounding moves off 1
        if (period_ == 0)
            poles_.push_back(v);
        else if (std::abs(1.0 + v) > forgotten)
            poles_.push_back(std::abs(v) < integrates * period_ ? 0.0 : log_beyond_one(v) / period_);
    }
    double late = delay_;
    for (const auto& f : loop.friction) late += f.memory;
    if (late > 0) turns_in_ = 1 / late;
    if (loop.friction.empty()) {
        exact_poles_ = poles_;
        return;
    }
    exact_poles_.push_back(0);  // nothing holds the position of a mechanism without its loop
    for (const double s : other_poles_) exact_poles_.push_back(s);
    if (!ticked_) {
        share_.emplace(loop.A, loop.input, both(loop), loop.friction);
        return;
    }
    share_.emplace(ticked_->plant.A, ticked_->plant.B, readings_of(ticked_->plant), loop.friction);
    constexpr double whole = 1e-12;  // as in sampled_loop()
    const double ticks = ticked_->timing.delay / period_, part = ticks - std::floor(ticks + whole);
    fraction_ = part > whole ? part * period_ : 0;
    take_answers(loop.friction);
    choose_aliases();
}

/// The mechanism behind itself, the speed of the first pushing the second.
void OpenedLoop::take_answers(const std::vector<LateFriction>& friction)
{
    const auto& plant = ticked_->plant;
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
void OpenedLoop::choose_aliases()
{
    constexpr double left = 1e-11;
    constexpr int fewest = 8, most = 4096;
    for (aliases_ = fewest; aliases_ < most; aliases_ *= 2) {
        bool enough = true;
        for (const double share : {0.03, 0.3, 0.9}) {  // at half the sampling rate a mass answers nothing
            const Complex s(0, share * end_);
            const Added fewer = answered_again(s, aliases_), more = answered_again(s, 2 * aliases_);
            const auto [K, K_v] = controller_at(ticked_->timing, ticked_->turned, std::exp(s * period_));
            std::array<Complex, 2> all;
            responses_.at(variable(s), all.data());
            enough &= std::abs(K * (more.reading - fewer.reading)) + std::abs(K_v * (more.rate - fewer.rate)) <
                      left * std::abs(all[0]);
        }
        if (enough) return;
    }
}

Complex OpenedLoop::variable(Complex s) const
{
    return period_ > 0 ? beyond_one(s * period_) : s;
}

OpenedLoop::Added OpenedLoop::answered_once(Complex s) const
{
    Added sum{};
    std::array<Complex, 2> values;
    for (const auto& a : answers_) {
        a.of_ticks.at(variable(s), values.data());
        const Complex late = std::exp(-s * (a.whole_ticks * period_));
        sum.reading += late * values[0];
        sum.rate += late * values[1];
    }
    return sum;
}

/// What the delays answer to their own answers, and tables to everything: the response of the mechanism to the hold,
/// sampled by its aliases, Σ P(s + 2πin/T) (1 − e^{−sT})/(T (s + 2πin/T)).
OpenedLoop::Added OpenedLoop::answered_again(Complex s, int aliases) const
{
    const double step = 2 * pi / period_;
    const Complex held = -beyond_one(-s * period_) / period_;
    Added sum{};
    std::array<Complex, 2> added;
    const auto take = [&](double shift) {
        const Complex at = s + Complex(0, shift);
        share_->at(at, false, added.data());
        const Complex hold = held / at * std::exp(-at * fraction_);
        sum.reading += hold * added[0];
        sum.rate += hold * added[1];
    };
    for (int n = aliases; n > 0; --n) take(n * step), take(-n * step);
    take(0);
    return sum;
}

std::pair<Complex, Complex> OpenedLoop::late_share(Complex s) const
{
    if (!ticked_) {
        std::array<Complex, 2> added;
        share_->at(s, true, added.data());
        return {added[0], added[1]};
    }
    const Added once = answered_once(s), again = answered_again(s, aliases_);
    const Complex reading = once.reading + again.reading, rate = once.rate + again.rate, z = std::exp(s * period_);
    const auto [K, K_v] = controller_at(ticked_->timing, ticked_->turned, z);
    const auto [B, B_v] = controller_at(ticked_->timing, ticked_->base, z);
    return {K * reading + K_v * rate, -(B * reading + B_v * rate)};
}

std::pair<Complex, Complex> OpenedLoop::prompt(Complex s) const
{
    std::array<Complex, 2> r;
    responses_.at(variable(s), r.data());
    if (!share_) return {r[0], r[1]};
    const auto more = late_share(s);
    return {r[0] + more.first, r[1] + more.second};
}

Response OpenedLoop::closing(double gain, Complex s) const
{
    if (share_) {
        constexpr double beside = 1e-5;
        const double h = beside * std::min(std::abs(s), turns_in_);
        const auto value = [&](Complex at) {
            const auto [out, held] = prompt(at);
            return 1.0 + (gain * out - held) * late(at);
        };
        return {value(s), (value(s + h) - value(s - h)) / (2 * h)};
    }
    std::array<Response, 2> r;
    responses_.at(variable(s), r.data());
    const Complex per_s = period_ > 0 ? period_ * std::exp(s * period_) : 1.0;
    const Complex value = gain * r[0].value - r[1].value, slope = per_s * (gain * r[0].slope - r[1].slope);
    return {1.0 + value * late(s), (slope - delay_ * value) * late(s)};
}

Complex OpenedLoop::towards(Complex s) const
{
    const Complex behind = late(s);
    const auto [out, held] = prompt(s);
    return -out * behind / (1.0 - held * behind);
}

std::optional<OpenedLoop::Right> OpenedLoop::right_of(double sigma) const
{
    constexpr double integrators = 1e-5;
    Right right;
    for (const Complex& s : poles_) right.size = std::max(right.size, std::abs(s));
    if (mechanism_right_of_) {
        const auto mechanism = mechanism_right_of_(sigma);
        if (!mechanism) return std::nullopt;
        right.poles = *mechanism;
        for (const double s : other_poles_) right.poles += s > sigma;
        return right;
    }
    for (const Complex& s : poles_) {
        const bool beside = sigma == 0 && std::abs(s) < integrators * right.size;
        right.at_zero |= beside;
        right.poles += !beside && s.real() > sigma;
    }
    return right;
}

double OpenedLoop::room(Complex s) const
{
    double least = infinity;
    for (const Complex& p : poles_) least = std::min(least, std::abs(s - p));
    return least;
}

}  // namespace stickslip
