// One accepted step of a lane under Rodas5P, as its program sees it.
#pragma once
#include "analysis/numerics/hermite.h"
#include "analysis/simulation/lanes/dense_output.h"
#include "analysis/simulation/lanes/job.h"
#include "analysis/simulation/solvers/rodas5p_table.h"

namespace stickslip::lanes {

struct StepView {
    double t, h;  ///< start and length, in the time of the present phase
    double y0[most_unknowns], y1[most_unknowns];
    double U[rodas5p::stages][most_unknowns];
    double w_before, h_before;  ///< the step before: w at its start, its length
    double steps;               ///< of the job so far
};

/// The course of one component.
struct DenseComponent : DenseOutput {
    DenseComponent(const StepView& s, int component) : DenseOutput{s.y0[component], s.y1[component], {0, 0, 0}}
    {
        for (int r = 0; r < 3; ++r)
            for (int j = 0; j < rodas5p::stages; ++j) k[r] += rodas5p::dense[r][j] * s.U[j][component];
    }
};

/// Where y turned in the step before: on the cubic through its start, both ends of this step and the slope between
/// them.
inline double turned_before(const StepView& s, const DenseComponent& y)
{
    const double slope = y.slope_at_start() / s.h, back = s.h_before;
    const double ahead = (y.y1 - y.y0 - slope * s.h) / (s.h * s.h);
    const double behind = (s.w_before - y.y0 + slope * back) / (back * back);
    const double c = (ahead - behind) / (s.h + back), b = ahead - c * s.h;
    const double t = -slope / (b + std::copysign(std::sqrt(b * b - 3 * c * slope), b));
    return t < 0 && t > -back ? y.y0 + t * (slope + t * (b + t * c)) : y.y0;
}

/// The extremum of the speed about a step that is flagged `turning`, by slopes of the dense output: rates of a stiff
/// motion are no better than its tolerance times its stiffness.
inline double extreme_speed(const StepView& s)
{
    const DenseComponent w(s, 1);
    const auto within = hermite_turning(w.y0, w.y1, w.slope_at_start(), w.slope_at_end(), 1);
    return within ? w(*within) : turned_before(s, w);
}

}  // namespace stickslip::lanes
