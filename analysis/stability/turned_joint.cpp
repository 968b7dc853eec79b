#include "analysis/stability/turned_joint.h"

#include <algorithm>
#include <cmath>

#include "analysis/stability/characteristic.h"
#include "analysis/stability/delay_spectrum.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/spectrum.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/winding.h"

namespace stickslip {
namespace {

constexpr double probe = 1e-6;          // of ln k_p: half the step of a difference
constexpr std::size_t near_roots = 12;  // of a delayed joint, from where the phase turns fastest

/// Roots right of the axis. No real root crosses it at k_p > 0, as springs hold the joint: their number is even, and
/// where it is not, rounding has moved the smallest to the other side.
int right_of_axis(const std::vector<Complex>& roots)
{
    int right = 0, real = 0;
    const Complex* smallest = nullptr;
    for (const Complex& s : roots) {
        right += s.real() > 0;
        if (s.imag() != 0) continue;
        real += s.real() > 0;
        if (!smallest || std::abs(s) < std::abs(*smallest)) smallest = &s;
    }
    if (real % 2 != 0) right += smallest->real() > 0 ? -1 : 1;
    return right;
}

}  // namespace

TurnedJoint::TurnedJoint(const Joint& joint, Theory theory) : joint_(joint), theory_(theory)
{
    const auto linear = at(joint.control.k_p);
    delayed_ = linear && !linear->rational();
}

std::optional<LinearJoint> TurnedJoint::at(double k_p)
{
    joint_.control.k_p = k_p;
    const auto steady = steady_sliding(joint_);
    if (steady.reason != Reason::none) return std::nullopt;
    auto linear = linear_joint(joint_, steady.slides_at);
    return theory_ == Theory::velocity_only ? velocity_only(std::move(linear)) : linear;
}

std::optional<RootsAtGain> TurnedJoint::look(double k_p, const RootsAtGain* near)
{
    const auto linear = at(k_p);
    if (!linear) return std::nullopt;
    RootsAtGain here;
    here.k_p = k_p;
    std::vector<Complex> roots;
    if (delayed_) {
        const auto count = count_right_of(*linear, 0);
        if (!count) return std::nullopt;
        work_ += static_cast<long>(count->nodes.size());
        here.right = count->roots;
        std::vector<Complex> expected;
        if (near)
            for (const auto& root : near->roots) expected.push_back(root.s + std::log(k_p / near->k_p) * root.slope);
        roots = roots_near(*linear, *count, near_roots, expected);
    } else {
        const bool plain = is_plain_mass(joint_) && theory_ == Theory::state_variable;
        roots = plain ? spectrum(linear_mass(joint_, sliding_velocity(joint_))) : spectrum(*linear);
        work_ += static_cast<long>(roots.size());
        if (roots.empty()) return std::nullopt;
        here.right = right_of_axis(roots);
        if (!std::all_of(roots.begin(), roots.end(), [](Complex s) { return std::isfinite(s.real()); }))
            return std::nullopt;
    }
    for (const Complex& s : roots)
        if (s.imag() > 0) here.roots.push_back({s, missing});
    add_slopes(here);
    return here;
}

void TurnedJoint::add_slopes(RootsAtGain& here)
{
    const double up = std::exp(probe);
    const auto middle = at(here.k_p), above = at(here.k_p * up), below = at(here.k_p / up);
    if (!middle || !above || !below) return;
    for (auto& root : here.roots) {
        const auto by_gain = (closed_loop(*above, root.s).value - closed_loop(*below, root.s).value) / (2 * probe);
        root.slope = -by_gain / closed_loop(*middle, root.s).slope;
    }
}

std::optional<RootsAtGain::Root> TurnedJoint::root_near(double k_p, Complex start)
{
    const auto linear = at(k_p);
    if (!linear || !std::isfinite(std::abs(start))) return std::nullopt;
    const auto found = roots_near(*linear, {}, 0, {start});
    if (found.empty() || !(found.front().imag() > 0)) return std::nullopt;
    RootsAtGain here;
    here.k_p = k_p;
    here.roots = {{found.front(), missing}};
    add_slopes(here);
    return here.roots.front();
}

std::optional<Crossing> TurnedJoint::polished(Crossing near)
{
    constexpr double exact = 1e-13, furthest = 0.1;
    const double start = std::log(near.k_p);
    double log_k = start, omega = near.omega;
    for (int i = 0; i < 12; ++i) {
        const auto here = at(std::exp(log_k)), above = at(std::exp(log_k + probe)), below = at(std::exp(log_k - probe));
        if (!here || !above || !below) return std::nullopt;
        const Complex s(0, omega);
        const auto F = closed_loop(*here, s);
        const Complex by_omega = Complex(0, 1) * F.slope;
        const Complex by_gain = (closed_loop(*above, s).value - closed_loop(*below, s).value) / (2 * probe);
        const double det = (std::conj(by_omega) * by_gain).imag();
        const double d_omega = -(std::conj(F.value) * by_gain).imag() / det;
        const double d_log = -(std::conj(by_omega) * F.value).imag() / det;
        if (!std::isfinite(d_omega) || !std::isfinite(d_log)) return std::nullopt;
        omega += d_omega;
        log_k += d_log;
        if (std::abs(log_k - start) > furthest || !(omega > 0)) return std::nullopt;
        if (std::abs(d_omega) < exact * omega && std::abs(d_log) < exact) break;
    }
    return Crossing{std::exp(log_k), omega, near.direction};
}

}  // namespace stickslip
