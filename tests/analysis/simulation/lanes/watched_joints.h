// Random joints of the laws whose motions lanes watch turn by turn.
#pragma once
#include <cmath>
#include <random>
#include <vector>

#include "tests/analysis/simulation/joints.h"

namespace stickslip {

/// Numbers of equal likelihood on the way from a to b.
class Uniform {
  public:
    explicit Uniform(unsigned seed) : random_(seed) {}
    double operator()(double a, double b)
    {
        return a + (b - a) * std::ldexp(static_cast<double>(random_() >> 11), -53);
    }

  private:
    std::mt19937_64 random_;
};

/// Two states, the second one of slip distances 2 to 50 times as long, gains of a decade about the larger of the
/// critical gains that each has alone.
inline std::vector<Joint> random_two_state_joints(std::size_t count, unsigned seed)
{
    Uniform uniform(seed);
    std::vector<Joint> joints;
    while (joints.size() < count) {
        const double V0 = std::pow(10, uniform(-5, -2)), L = std::pow(10, uniform(-6, -4)),
                     A = std::pow(10, uniform(-1, 1)), m = std::pow(10, uniform(-1, 1));
        const double first = uniform(0.5, 2), second = uniform(0.2, 1.5), longer = std::pow(10, uniform(0.3, 1.7));
        const double c = uniform(0, 1) * std::max(0.0, first + second - 1), M = m * V0 * V0 / (L * A);
        const double K = std::max({first - 1 - c, (first + second - 1 - c) / longer, 0.05}) * (1 + M / (1 + c));
        Joint joint = example_joint(K * std::pow(10, uniform(-1, 0.5)) * A / L, c * A / V0, V0);
        joint.mechanism.inertia = m;
        auto& law = std::get<RateAndState>(joint.friction.law);
        law.A = A, law.B[0] = first * A, law.L[0] = L;
        law.B.push_back(second * A), law.L.push_back(longer * L);
        joints.push_back(joint);
    }
    return joints;
}

/// Bristles that ring up to twice damped, 1 to 30 times as stiff as the loop, at velocities from a tenth of the
/// Stribeck velocity to four of it.
inline std::vector<Joint> random_lugre_joints(std::size_t count, unsigned seed)
{
    Uniform uniform(seed);
    std::vector<Joint> joints;
    while (joints.size() < count) {
        LuGre law;
        law.sigma0 = std::pow(10, uniform(4, 6));
        const double m = std::pow(10, uniform(-1, 1));
        law.sigma1 = uniform(0.1, 2) * std::sqrt(law.sigma0 * m);
        law.coulomb = std::pow(10, uniform(-1, 1.5));
        law.breakaway = law.coulomb * uniform(1.05, 2);
        law.stribeck_velocity = std::pow(10, uniform(-4, -2));
        law.sigma2 = uniform(0, 0.6) * (law.breakaway - law.coulomb) / law.stribeck_velocity;
        const double V0 = law.stribeck_velocity * std::pow(10, uniform(-1, 0.6));
        const bool damped = uniform(0, 1) < 0.3;
        const double k_v = damped ? uniform(0, 0.7) * (law.breakaway - law.coulomb) / law.stribeck_velocity : 0;
        Joint joint = stribeck_joint(law.sigma0 * std::pow(10, uniform(-1.5, 0)), k_v, V0);
        joint.mechanism.inertia = m;
        joint.friction.law = law;
        joints.push_back(joint);
    }
    return joints;
}

}  // namespace stickslip
