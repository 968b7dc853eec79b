// The dense output of one component of a step (rodas5p_table.h), and where it takes a value.
#pragma once
#include <cmath>

namespace stickslip::lanes {

struct DenseOutput {
    double y0, y1, k[3];

    double operator()(double f) const
    {
        const double rest = 1 - f;
        return rest * y0 + f * (y1 + rest * (k[0] + f * (k[1] + f * k[2])));
    }
    double slope_at_start() const { return y1 - y0 + k[0]; }  ///< per step
    double slope_at_end() const { return y1 - y0 - k[0] - k[1] - k[2]; }
};

/// Where the component takes the value `level` within the step (Illinois on the dense output).
inline double crossing(const DenseOutput& y, double level)
{
    double left = 0, right = 1, at_left = y.y0 - level, at_right = y.y1 - level;
    int kept = 0;
    for (int i = 0; i < 50 && right - left > 1e-13; ++i) {
        const double middle = (left * at_right - right * at_left) / (at_right - at_left);
        const double value = y(middle) - level;
        if (std::abs(value) < 1e-15) return middle;
        if ((value > 0) == (at_right > 0)) {
            right = middle, at_right = value;
            if (kept == -1) at_left /= 2;
            kept = -1;
        } else {
            left = middle, at_left = value;
            if (kept == 1) at_right /= 2;
            kept = 1;
        }
    }
    return 0.5 * (left + right);
}

}  // namespace stickslip::lanes
