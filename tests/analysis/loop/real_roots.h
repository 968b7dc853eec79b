// Whether every root that the linear verdict of a real loop names is one, and none lies right of its growth: held
// against the characteristic function of the mechanism with the controller written beside it, counted by the argument
// principle, and against a map written out tick by tick.
#pragma once
#include "analysis/stability/characteristic.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/stability/tick_by_tick.h"

#include <Eigen/LU>
#include <algorithm>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

namespace stickslip::samples {

/// What was looked at, for the figures of a campaign.
struct RootsSeen {
    long roots = 0, counts = 0, open = 0;  ///< `open`: counts that a line through a root left open
};

/// 1 for the mechanism under the controller, u = −(k_p + k_i/s + k_v s/(τs + 1)) e^{−sθ}/(lag s + 1) y.
struct LateLoop {
    LinearJoint mechanism;
    LoopGains g;
    double scale, push, tau, delay, lag;

    explicit LateLoop(const Joint& j)
        : mechanism(linear_joint(j, sliding_velocity(j))),
          g{j.control.k_p, j.control.k_v, j.control.k_i, 0},
          scale(j.sensor.position_scale),
          push(j.actuator.effort_gain),
          tau(j.control.velocity_estimate.tau),
          delay(j.dead_time()),
          lag(j.actuator.lag)
    {
        mechanism.k_p = mechanism.k_v = 0;
    }
    std::vector<double> poles() const
    {
        std::vector<double> all;
        for (int i = 0; i < mechanism.bodies; ++i)
            for (int k = 0; k < mechanism.friction[i].states; ++k) all.push_back(mechanism.friction[i].lambda[k]);
        if (g.integral != 0) all.push_back(0);
        if (tau > 0) all.push_back(-1 / tau);
        if (lag > 0) all.push_back(-1 / lag);
        return all;
    }
    /// F(s) and the sizes of what it is the sum of.
    struct Value {
        Complex F;
        double terms;
    };
    Value at(Complex s) const
    {
        const auto parts = characteristic_at(mechanism, s);
        const Complex command =
            (g.position + (g.integral != 0 ? g.integral / s : 0) + g.velocity * s / (tau * s + 1.0)) * scale * push *
            std::exp(-s * delay) / (lag * s + 1.0);
        const Complex pushed = command * parts.b.value;
        return {parts.a.value + pushed, std::abs(parts.a.value) + std::abs(pushed)};
    }
    /// F(s) times its poles, by a direction: a sum of logarithms does not overflow.
    double phase(Complex s) const
    {
        double sum = std::arg(at(s).F);
        for (const double p : poles()) sum += std::arg(s - p);
        return sum;
    }
    /// The step of Newton's method per |s|.
    double step(Complex s) const
    {
        const Complex h = 1e-6 * s, F = at(s).F;
        return std::abs(F / ((at(s + h).F - at(s - h).F) / (2.0 * h))) / std::abs(s);
    }
    /// Zeros right of Re s = σ: half the turns that a polynomial of this degree would take on that line less those
    /// that F takes. Nothing where a root lies on the line.
    std::optional<int> right_of(double sigma, double size) const
    {
        using std::numbers::pi;
        const auto degree = static_cast<int>(2 * mechanism.bodies + poles().size());
        double turned = 0, omega = 0, step = 1e-6 * size, here = phase(sigma);
        // up to where the highest power leads
        const double end = 100 * size * (1 + std::exp(-sigma * delay));
        for (long used = 0; omega < end; ++used) {
            if (used > 2'000'000 || step < 1e-14 * (omega + size)) return std::nullopt;
            const double next = omega + std::min(step, delay > 0 ? 0.3 / delay : infinity);
            const double middle = phase({sigma, 0.5 * (omega + next)}), there = phase({sigma, next});
            const double first = std::remainder(middle - here, 2 * pi), second = std::remainder(there - middle, 2 * pi);
            if (std::abs(first) > 0.3 || std::abs(second) > 0.3 || std::abs(first - second) > 0.1) {
                step = (next - omega) / 2;
                continue;
            }
            turned += first + second;
            step = 1.6 * (next - omega), omega = next, here = there;
        }
        const double left = std::remainder(degree * pi / 2 - here, 2 * pi);
        const double zeros = (degree * pi / 2 - turned - left) / pi;
        if (std::abs(zeros - std::round(zeros)) > 0.05) return std::nullopt;
        return static_cast<int>(std::lround(zeros));
    }
};

/// By how much the map would have to change, per its size, to have this multiplier.
inline double backward_error(const Matrix& map, Complex s, double T)
{
    using Long = std::complex<Real>;
    const Long z = std::exp(Long(s) * Real(T));
    Eigen::Matrix<Long, Eigen::Dynamic, Eigen::Dynamic> shifted = map.cast<Long>();
    for (Eigen::Index i = 0; i < shifted.rows(); ++i) shifted(i, i) -= z;
    return static_cast<double>(1 / (Eigen::PartialPivLU<decltype(shifted)>(shifted).inverse().norm() * map.norm()));
}

/// What is wrong, in words; empty where all is right, and where friction is delayed in a sampled loop, which no finite
/// map writes out.
inline std::string contradiction_of_roots(const Joint& joint, RootsSeen& seen)
{
    constexpr double same = 1e-8, beside = 1e-5, slow = 1e-12;
    const auto kind = loop_kind(joint);
    const auto verdict = linear_verdict(joint);
    const auto& memory = verdict.state_variable;
    if (kind == LoopKind::ideal || verdict.steady.reason != Reason::none || memory.eigenvalues.empty()) return "";
    const auto linear = linear_joint(joint, sliding_velocity(joint));
    const bool sampled = kind == LoopKind::sampled;
    if (sampled && !linear.rational()) return "";
    double size = 0;  // of the fastest: a slow root has the rounding of its size
    for (const auto& s : memory.eigenvalues) size = std::max(size, std::abs(s));
    const double line = memory.spectral_abscissa + beside * std::abs(memory.eigenvalues.front()) + slow * size;
    if (sampled) {
        const double T = joint.control.period;
        const Matrix map = written_out(joint).map();
        if (!map.allFinite()) return "";
        for (const auto& s : memory.eigenvalues) {
            ++seen.roots;
            if (!(backward_error(map, s, T) < same)) return "a multiplier is none of the map";
        }
        ++seen.counts;
        if (static_cast<double>(test::spectral_radius(map)) > std::exp(line * T) * (1 + slow))
            return "a multiplier outside the largest";
        return "";
    }
    const LateLoop loop(joint);
    // what decays without being noticed by the motion is an eigenvalue, and no root of F
    const auto poles = loop.poles();
    for (const auto& s : memory.eigenvalues) {
        if (std::abs(s) < slow * size) continue;
        if (std::ranges::any_of(poles, [&](double p) { return std::abs(s - p) < 1e-9 * std::abs(s); })) continue;
        const auto value = loop.at(s);
        ++seen.roots;
        if (!(std::abs(value.F) < same * value.terms || loop.step(s) < same)) return "an eigenvalue is no root";
    }
    const auto right = loop.right_of(line, size);
    ++(right ? seen.counts : seen.open);
    if (right && *right != 0) return "a root right of the growth";
    return "";
}

}  // namespace stickslip::samples
