// Noise of a joint with memory against its sampled loop in time: the covariance of a discrete system by another method
// (doubling of the discrete Lyapunov equation), and a seeded simulation sample by sample.
#include "analysis/design/noise.h"
#include "analysis/stability/steady.h"
#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>

#include <Eigen/Dense>
#include <cmath>
#include <random>

using namespace stickslip;

namespace {

using Matrix = Eigen::MatrixXd;

/// e^{A}, by Taylor's series of a halved matrix.
Matrix exponential(const Matrix& A)
{
    const int halvings = std::max(0, static_cast<int>(std::ceil(std::log2(A.norm() + 1e-300))) + 4);
    const Matrix B = A / std::pow(2.0, halvings);
    Matrix sum = Matrix::Identity(A.rows(), A.cols()), term = sum;
    for (int k = 1; k < 18; ++k) term = term * B / k, sum += term;
    for (int k = 0; k < halvings; ++k) sum = sum * sum;
    return sum;
}

/// The slip law of the example about steady sliding, (27): states x, v, δθ; a force held over T.
struct Plant {
    Matrix A = Matrix::Zero(3, 3), map;
    Eigen::Vector3d input;

    /// `k_p`, `k_v`: what acts without pause; 0 where a sampled controller does.
    Plant(double m, double V0, double k_p, double k_v, double T)
    {
        constexpr double a = 1, b = 1.5, L = 1e-5;
        A << 0, 1, 0,                               //
            -k_p / m, -(k_v + a / V0) / m, -1 / m,  //
            0, -b / L, -V0 / L;
        Matrix both = Matrix::Zero(4, 4);
        both.topLeftCorner(3, 3) = A * T;
        both(1, 3) = T / m;
        const Matrix e = exponential(both);
        map = e.topLeftCorner(3, 3), input = e.topRightCorner(3, 1);
    }
};

/// Covariance of z' = F z + g n, n white with variance 1: P = Σ F^k g gᵀ F^kᵀ.
Matrix covariance(Matrix F, const Eigen::VectorXd& g)
{
    Matrix P = g * g.transpose();
    for (int k = 0; k < 60; ++k) P = (P + F * P * F.transpose()).eval(), F = (F * F).eval();
    return P;
}

struct Loop {
    double m = 1, V0 = 1e-3, k_p = 6e4, k_v = 40, T = 1e-4, tau = 3e-4, sigma = 2e-7;

    LinearJoint linear() const { return linear_joint(example_joint(k_p, k_v, V0), V0); }
    SensorNoise noise() const
    {
        SensorNoise n;
        n.position = sigma, n.period = T, n.filter = tau;
        return n;
    }
};

}  // namespace

TEST_CASE("noise through a joint with memory is the covariance of its discrete system", "[design][noise]")
{
    for (const double k_v : {0.0, 40.0, 700.0}) {
        Loop l;
        l.k_v = k_v;
        const Plant plant(l.m, l.V0, l.k_p, l.k_v, l.T);
        const double a = l.T / (l.tau + l.T);
        // z = (x, v, θ, last noise, last estimate); the estimate is (1 − a) e + a (n − n₋)/T
        Matrix F = Matrix::Zero(5, 5);
        Eigen::VectorXd g = Eigen::VectorXd::Zero(5);
        F.topLeftCorner(3, 3) = plant.map;
        const double from_last = -a / l.T, from_estimate = 1 - a, from_new = a / l.T;
        F.col(3).head(3) = -l.k_v * from_last * plant.input;
        F.col(4).head(3) = -l.k_v * from_estimate * plant.input;
        g.head(3) = -(l.k_p + l.k_v * from_new) * plant.input;
        g[3] = 1;
        F(4, 3) = from_last, F(4, 4) = from_estimate, g[4] = from_new;
        const Matrix P = covariance(F, g);
        CHECK(motion_noise(l.linear(), l.noise()) == Approx(l.sigma * std::sqrt(P(0, 0))).epsilon(3e-3));
        // the command: k_p n + k_v e
        const double effort = l.k_p * l.k_p + 2 * l.k_p * l.k_v * g[4] + l.k_v * l.k_v * P(4, 4);
        CHECK(effort_noise(l.linear(), l.noise()) == Approx(l.sigma * std::sqrt(effort)).epsilon(1e-4));
    }
}

TEST_CASE("a seeded simulation of the sampled loop moves as much as foretold", "[design][noise]")
{
    constexpr unsigned seed = 20261121;
    INFO("seed " << seed);
    const Loop l;
    const Plant plant(l.m, l.V0, 0, 0, l.T);  // the controller acts on samples only
    const double a = l.T / (l.tau + l.T);
    std::mt19937_64 chance(seed);
    std::normal_distribution<double> normal(0, l.sigma);
    Eigen::Vector3d z = Eigen::Vector3d::Zero();
    double last = 0, estimate = 0, sum = 0;
    constexpr int settle = 20000, samples = 1000000;
    for (int k = 0; k < settle + samples; ++k) {
        const double y = z[0] + normal(chance);
        estimate = (1 - a) * estimate + a * (y - last) / l.T;
        last = y;
        z = plant.map * z - (l.k_p * y + l.k_v * estimate) * plant.input;
        if (k >= settle) sum += z[0] * z[0];
    }
    // the loop is judged as continuous: sampling costs it some damping
    CHECK(motion_noise(l.linear(), l.noise()) == Approx(std::sqrt(sum / samples)).epsilon(0.1));
}
