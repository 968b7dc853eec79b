#include "analysis/simulation/sampled/rosenbrock.h"

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

}  // namespace

template <int fixed>
bool RosenbrockStep::take_sized(const DrivenJoint& joint)
{
    const int n = fixed > 0 ? fixed : joint.size();
    constexpr int room = fixed > 0 ? fixed : max_driven_size;
    std::array<double, room * room> matrix;
    std::array<int, room> row;
    joint.jacobian(y0.data(), matrix.data());
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
        if (s == 0) std::copy_n(rate.data(), n, first_rate_.data());
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
    switch (size_) {
        case 2: return take_sized<2>(joint);
        case 3: return take_sized<3>(joint);
        case 4: return take_sized<4>(joint);
        case 5: return take_sized<5>(joint);
        case 6: return take_sized<6>(joint);
        default: return take_sized<0>(joint);
    }
}

double RosenbrockStep::error(const DrivenJoint& joint, double rtol) const
{
    double largest = 0;
    for (int i = 0; i < size_; ++i) {
        const double allowed = rtol * (joint.scale()[i] + std::max(std::abs(y0[i]), std::abs(y1[i])));
        largest = std::max(largest, std::abs(U_[stages - 1][i]) / allowed);
    }
    return largest;
}

void RosenbrockStep::dense(double fraction, double* y) const
{
    const double rest = 1 - fraction;
    for (int i = 0; i < size_; ++i) {
        double k[3] = {};
        for (int r = 0; r < 3; ++r)
            for (int j = 0; j < stages; ++j) k[r] += rodas5p::dense[r][j] * U_[j][i];
        y[i] = rest * y0[i] + fraction * (y1[i] + rest * (k[0] + fraction * (k[1] + fraction * k[2])));
    }
}

}  // namespace stickslip
