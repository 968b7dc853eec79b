// One step of the Dormand–Prince 5(4) pair (J. R. Dormand & P. J. Prince, J. Comput. Appl. Math. 6 (1980) 19-26, table
// 2).
#pragma once
#include <array>
#include <cstddef>

namespace blind {

template <std::size_t n>
struct Step {
    std::array<double, n> end, error;  ///< fifth-order result, its difference from the fourth-order one
};

template <std::size_t n, class Rate>
Step<n> dormand_prince(Rate&& rate, double t, const std::array<double, n>& y, double h)
{
    static constexpr double c[] = {0, 1. / 5, 3. / 10, 4. / 5, 8. / 9, 1, 1};
    static constexpr double a[7][6] = {
        {},
        {1. / 5},
        {3. / 40, 9. / 40},
        {44. / 45, -56. / 15, 32. / 9},
        {19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729},
        {9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656},
        {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84},
    };
    static constexpr double e[] = {71. / 57600, 0, -71. / 16695, 71. / 1920, -17253. / 339200, 22. / 525, -1. / 40};
    std::array<std::array<double, n>, 7> k;
    Step<n> step{y, {}};
    for (int stage = 0; stage < 7; ++stage) {
        std::array<double, n> at = y;
        for (int j = 0; j < stage; ++j)
            for (std::size_t i = 0; i < n; ++i) at[i] += h * a[stage][j] * k[j][i];
        if (stage == 6) step.end = at;
        k[stage] = rate(t + c[stage] * h, at);
    }
    for (int stage = 0; stage < 7; ++stage)
        for (std::size_t i = 0; i < n; ++i) step.error[i] += h * e[stage] * k[stage][i];
    return step;
}

}  // namespace blind
