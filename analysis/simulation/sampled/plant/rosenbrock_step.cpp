#include "analysis/simulation/sampled/plant/rosenbrock_step.h"

#include <cmath>

namespace stickslip {
namespace {

using rodas5p::stages;

/// P A = L U in place, Crout with row exchanges; false where a pivot vanishes.
bool factor(double* A, int n, int* row)
{
    for (int k = 0; k < n; ++k) {
        int best = k;
        for (int i = k + 1; i < n; ++i)
            if (std::abs(A[i * n + k]) > std::abs(A[best * n + k])) best = i;
        row[k] = best;
        if (best != k)
            for (int j = 0; j < n; ++j) std::swap(A[k * n + j], A[best * n + j]);
        const double pivot = A[k * n + k];
        if (!(std::abs(pivot) > 0) || !std::isfinite(pivot)) return false;
        const double per = 1 / pivot;
        for (int i = k + 1; i < n; ++i) {
            const double share = A[i * n + k] *= per;
            if (share == 0) continue;
            for (int j = k + 1; j < n; ++j) A[i * n + j] -= share * A[k * n + j];
        }
        A[k * n + k] = per;
    }
    return true;
}

void solve(const double* A, int n, const int* row, double* b)
{
    for (int k = 0; k < n; ++k)
        if (row[k] != k) std::swap(b[k], b[row[k]]);
    for (int i = 1; i < n; ++i)
        for (int j = 0; j < i; ++j) b[i] -= A[i * n + j] * b[j];
    for (int i = n - 1; i >= 0; --i) {
        for (int j = i + 1; j < n; ++j) b[i] -= A[i * n + j] * b[j];
        b[i] *= A[i * n + i];
    }
}

/// h |λ| beyond which an explicit step is bounded by stability, and below which it may be tried again.
constexpr double too_stiff = 2.5, mild = 1;

}  // namespace

bool RosenbrockStep::take_explicit(const DrivenJoint& joint)
{
    namespace dp = dormand_prince;
    const int n = size_;
    if (!carried_) joint.rate(y0.data(), k_[0].data());
    DrivenState before;
    for (int s = 1; s < dp::stages; ++s) {
        if (s == dp::stages - 1) std::copy_n(y1.data(), n, before.data());
        for (int i = 0; i < n; ++i) {
            double sum = 0;
            for (int j = 0; j < s; ++j) sum += dp::weight[s][j] * k_[j][i];
            y1[i] = y0[i] + h * sum;
        }
        joint.rate(y1.data(), k_[s].data());
    }
    // two stages at the end of the step, apart by a little: their rates tell the largest |λ| (Hairer & Wanner, IV.2)
    double apart = 0, rates = 0;
    bool finite = true;
    for (int i = 0; i < n; ++i) {
        const double per = 1 / joint.scale()[i];
        apart = std::max(apart, std::abs(y1[i] - before[i]) * per);
        rates = std::max(rates, std::abs(k_[6][i] - k_[5][i]) * per);
        finite &= std::isfinite(y1[i]) && std::isfinite(k_[6][i]);
    }
    stiffness_ = apart > 0 ? h * rates / apart : 0;
    explicit_ = true;
    return finite;
}

void RosenbrockStep::carry()
{
    carried_ = explicit_;
    if (explicit_) std::swap(k_[0], k_[dormand_prince::stages - 1]);
}

const double* RosenbrockStep::last_rate(const DrivenJoint& joint, DrivenState& room) const
{
    if (explicit_) return k_[dormand_prince::stages - 1].data();
    joint.rate(y1.data(), room.data());
    return room.data();
}

template <int fixed>
bool RosenbrockStep::take_sized(const DrivenJoint& joint)
{
    const int n = fixed > 0 ? fixed : joint.size();
    constexpr int room = fixed > 0 ? fixed : max_driven_size;
    std::array<double, room * room> matrix;
    std::array<int, room> row;
    joint.jacobian(y0.data(), matrix.data());
    double largest = 0;
    for (int i = 0; i < n; ++i) {
        double sum = 0;
        for (int j = 0; j < n; ++j) sum += std::abs(matrix[i * n + j]) * joint.scale()[j];
        largest = std::max(largest, sum / joint.scale()[i]);
    }
    stiff_ = h * largest > mild;
    for (int i = 0; i < n * n; ++i) matrix[i] = -matrix[i];
    for (int i = 0; i < n; ++i) matrix[i * n + i] += 1 / (h * rodas5p::gamma);
    if (!factor(matrix.data(), n, row.data())) return false;
    std::array<double, room> y, rate;
    for (int s = 0; s < stages; ++s) {
        for (int i = 0; i < n; ++i) y[i] = y0[i];
        for (int j = 0; j < s; ++j)
            if (const double a = rodas5p::a[s][j]; a != 0)
                for (int i = 0; i < n; ++i) y[i] += a * U_[j][i];
        joint.rate(y.data(), rate.data());
        if (s == 0) std::copy_n(rate.data(), n, k_[0].data());
        double* U = U_[s].data();
        for (int i = 0; i < n; ++i) U[i] = rate[i];
        for (int j = 0; j < s; ++j)
            if (const double c = rodas5p::c[s][j] / h; c != 0)
                for (int i = 0; i < n; ++i) U[i] += c * U_[j][i];
        solve(matrix.data(), n, row.data(), U);
    }
    bool finite = true;
    for (int i = 0; i < n; ++i) {
        double sum = y0[i] + U_[stages - 1][i];
        for (int j = 0; j + 1 < stages; ++j) sum += rodas5p::a[stages - 1][j] * U_[j][i];
        y1[i] = sum;
        finite &= std::isfinite(sum);
    }
    return finite;
}

bool RosenbrockStep::take(const DrivenJoint& joint)
{
    size_ = joint.size();
    if (!stiff_ && !implicit_only) {
        const bool finite = take_explicit(joint);
        if (finite && stiffness_ < too_stiff) return true;
        stiff_ = true;
    }
    explicit_ = carried_ = false;
    switch (size_) {
        case 2:
            return take_sized<2>(joint);
        case 3:
            return take_sized<3>(joint);
        case 4:
            return take_sized<4>(joint);
        case 5:
            return take_sized<5>(joint);
        case 6:
            return take_sized<6>(joint);
        default:
            return take_sized<0>(joint);
    }
}

double RosenbrockStep::error(const DrivenJoint& joint, double rtol) const
{
    double largest = 0;
    for (int i = 0; i < size_; ++i) {
        const double allowed = rtol * (joint.scale()[i] + std::max(std::abs(y0[i]), std::abs(y1[i])));
        double error = explicit_ ? 0 : U_[stages - 1][i];
        if (explicit_)
            for (int j = 0; j < dormand_prince::stages; ++j) error += h * dormand_prince::error_weight[0][j] * k_[j][i];
        largest = std::max(largest, std::abs(error) / allowed);
    }
    return largest;
}

void RosenbrockStep::dense(double fraction, double* y) const
{
    if (explicit_) {
        for (int i = 0; i < size_; ++i) {
            double rates[dormand_prince::stages], c[5];
            for (int j = 0; j < dormand_prince::stages; ++j) rates[j] = k_[j][i];
            dormand_prince::fill_dense(y0[i], y1[i], rates, h, c);
            y[i] = dormand_prince::dense(c, fraction);
        }
        return;
    }
    const double rest = 1 - fraction;
    for (int i = 0; i < size_; ++i) {
        double k[3] = {};
        for (int r = 0; r < 3; ++r)
            for (int j = 0; j < stages; ++j) k[r] += rodas5p::dense[r][j] * U_[j][i];
        y[i] = rest * y0[i] + fraction * (y1[i] + rest * (k[0] + fraction * (k[1] + fraction * k[2])));
    }
}

}  // namespace stickslip
