// A measured impulse response: samples of g(t), straight lines between them, zero behind the last.
#pragma once
#include <complex>
#include <memory>
#include <string>
#include <vector>

namespace stickslip {

/// g(t) of (13) as samples. The first time is 0; between samples g is linear; after the last it is zero.
struct KernelTable {
    std::vector<double> time;   ///< s, ascending from 0
    std::vector<double> value;  ///< g, N/m | N·m/rad

    /// What forbids using it, or nothing.
    std::string problem() const;

    double duration() const { return time.back(); }
    double at(double t) const;

    /// ∫ (−t)^n g(t) e^{−st} dt, the n-th derivative of G: exact for the straight lines, n ≤ 1.
    std::complex<double> transform(std::complex<double> s) const;
    std::complex<double> transform_slope(std::complex<double> s) const;

    /// ∫ t^n |g(t)| e^{−σt} dt or more: bounds |d^n G/ds^n| for Re s ≥ σ.
    double moment(int n, double sigma = 0) const;
    /// |g(0)| + total variation + |g(end)|: |G(s)| ≤ this / |s| for Re s ≥ 0.
    double variation() const;
};

using KernelTablePtr = std::shared_ptr<const KernelTable>;

}  // namespace stickslip
