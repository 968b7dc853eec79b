// What a reader sees first: the verdict in words, a few numbers with their limits, and what needs attention.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/boundary.h"
#include "analysis/results/report.h"
#include "analysis/stability/verdict.h"
#include "sweep/study/joint_answer.h"

namespace stickslip {

/// How a point of the design is judged, and in words.
struct DesignVerdict {
    Region region = Region::undecided;
    std::string text;  ///< mark-up
    Headline::Tone tone = Headline::Tone::neutral;
};

/// `region` is that of the results at the design where the sweep simulated its points.
DesignVerdict design_verdict(const Joint& joint, const LinearVerdict& linear, Region region,
                             const NonlinearVerdict& nonlinear);

/// Whether a boundary lies within `near_factor` of the design along one parameter.
bool near_boundary(const std::vector<Margin>& margins);

/// The nearest boundary of all parameters, by factor.
Headline nearest_boundary_headline(const std::vector<Margin>& margins, bool stable, Units units);

/// The stable velocities around the design, and the least stable one.
std::vector<Headline> velocity_headlines(const VelocitySearch& search, bool stable, Units units);

/// Every margin as a row.
Table margin_table(const std::vector<Margin>& margins, Units units);

}  // namespace stickslip
