#include "analysis/loop/opened_loop.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <numbers>

#include "analysis/numerics/beyond_one.h"
#include "analysis/numerics/eigenvalues.h"

namespace stickslip {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

Eigen::MatrixXd both(const DelayedLoop& loop)
{
    Eigen::MatrixXd rows(2, loop.A.cols());
    rows << loop.output, loop.held;
    return rows;
}

}  // namespace

OpenedLoop::OpenedLoop(const DelayedLoop& loop)
    : delay_(loop.delay),
      period_(loop.period),
      end_(loop.period > 0 ? pi / loop.period : infinity),
      turns_in_(infinity),
      responses_(loop.A, loop.input, both(loop)),
      mechanism_right_of_(loop.mechanism_right_of),
      other_poles_(loop.other_poles)
{
    for (const Complex& v : eigenvalues_of(loop.A)) {
        constexpr double forgotten = 1e-6;   // a multiplier that is gone within a few ticks
        constexpr double integrates = 1e-9;  // a multiplier that only rounding moves off 1
        if (period_ == 0)
            poles_.push_back(v);
        else if (std::abs(1.0 + v) > forgotten)
            poles_.push_back(std::abs(v) < integrates * period_ ? 0.0 : log_beyond_one(v) / period_);
    }
    double behind = delay_;
    for (const auto& f : loop.friction) behind += f.memory;
    if (behind > 0) turns_in_ = 1 / behind;
    if (loop.friction.empty()) {
        exact_poles_ = poles_;
        return;
    }
    exact_poles_.push_back(0);  // nothing holds the position of a mechanism without its loop
    for (const double s : other_poles_) exact_poles_.push_back(s);
    if (!loop.ticked) {
        share_.emplace(loop.A, loop.input, both(loop), loop.friction);
        return;
    }
    ticked_share_.emplace(*loop.ticked, loop.friction, responses_);
}

Complex OpenedLoop::variable(Complex s) const
{
    return period_ > 0 ? beyond_one(s * period_) : s;
}

std::pair<Complex, Complex> OpenedLoop::delayed_share(Complex s) const
{
    if (ticked_share_) return ticked_share_->at(s);
    std::array<Complex, 2> added;
    share_->at(s, added.data());
    return {added[0], added[1]};
}

std::pair<Complex, Complex> OpenedLoop::prompt(Complex s) const
{
    std::array<Complex, 2> r;
    responses_.at(variable(s), r.data());
    if (!has_delayed_friction()) return {r[0], r[1]};
    const auto more = delayed_share(s);
    return {r[0] + more.first, r[1] + more.second};
}

Response OpenedLoop::closing(double gain, Complex s) const
{
    if (has_delayed_friction()) {
        constexpr double beside = 1e-5;
        const double h = beside * std::min(std::abs(s), turns_in_);
        const auto value = [&](Complex at) {
            const auto [out, held] = prompt(at);
            return 1.0 + (gain * out - held) * delayed(at);
        };
        return {value(s), (value(s + h) - value(s - h)) / (2 * h)};
    }
    std::array<Response, 2> r;
    responses_.at(variable(s), r.data());
    const Complex per_s = period_ > 0 ? period_ * std::exp(s * period_) : 1.0;
    const Complex value = gain * r[0].value - r[1].value, slope = per_s * (gain * r[0].slope - r[1].slope);
    return {1.0 + value * delayed(s), (slope - delay_ * value) * delayed(s)};
}

Complex OpenedLoop::towards(Complex s) const
{
    const Complex behind = delayed(s);
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
