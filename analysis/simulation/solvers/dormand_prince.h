// RK5(4)7M of Dormand & Prince, Journal of Computational and Applied Mathematics 6 (1980), and its dense output.
#pragma once

namespace stickslip::dormand_prince {

inline constexpr int stages = 7;

inline constexpr double node[stages] = {0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1, 1};

/// The last row is the step itself.
inline constexpr double weight[stages][stages - 1] = {
    {},
    {1.0 / 5},
    {3.0 / 40, 9.0 / 40},
    {44.0 / 45, -56.0 / 15, 32.0 / 9},
    {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
    {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
    {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84},
};

/// Difference to the embedded method of order 4.
inline constexpr double error_weight[1][stages] = {
    {71.0 / 57600, 0, -71.0 / 16695, 71.0 / 1920, -17253.0 / 339200, 22.0 / 525, -1.0 / 40}};

/// Fifth coefficient of the dense output (Hairer, Nørsett & Wanner, Solving ODEs I, II.6, program DOPRI5).
inline constexpr double dense_weight[stages] = {-12715105075.0 / 11282082432,  0,
                                                87487479700.0 / 32700410799,   -10690763975.0 / 1880347072,
                                                701980252875.0 / 199316789632, -1453857185.0 / 822651844,
                                                69997945.0 / 29380423};

/// The continuous step of one component: coefficients from its values and its rates at the stages.
inline void fill_dense(double y0, double y1, const double* k, double h, double* c)
{
    const double difference = y1 - y0, bend = h * k[0] - difference;
    double last = 0;
    for (int i = 0; i < stages; ++i) last += dense_weight[i] * k[i];
    c[0] = y0, c[1] = difference, c[2] = bend, c[3] = difference - h * k[6] - bend, c[4] = h * last;
}

/// Its value at the share 0 ≤ f ≤ 1 of the step.
inline double dense(const double* c, double f)
{
    return c[0] + f * (c[1] + (1 - f) * (c[2] + f * (c[3] + (1 - f) * c[4])));
}

}  // namespace stickslip::dormand_prince
