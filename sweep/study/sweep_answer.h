// Everything that a sweep is answered with beside its points (results.nc): what answer.json holds and what its page is
// drawn from, without a solver.
#pragma once
#include "sweep/study/idle_axes.h"
#include "sweep/study/joint_answer.h"
#include "sweep/study/left_out_loop.h"
#include "sweep/study/map_answer.h"
#include "sweep/study/panels.h"
#include "sweep/study/sweep_summary.h"

#include <optional>
#include <string>
#include <vector>

namespace stickslip {

/// What is computed for the chart of a sweep along one axis.
struct ProfileAnswer {
    std::vector<double> velocity_only_abscissa;        ///< 1/s, at the axis' values
    std::vector<BoundaryPoint> memory, velocity_only;  ///< where stability changes
};

struct SweepAnswer {
    std::string plan_id, spec;  ///< of the sweep that it belongs to, and the question, TOML
    JointAnswer design;
    std::vector<Margin> margins;  ///< one an axis
    std::vector<MapAnswer> maps;  ///< one a slice of the summary
    std::optional<PanelsAnswer> panels;
    std::vector<ProfileAnswer> profiles;
    std::vector<GainSurface> surfaces;
    std::optional<LeftOut> left_out;  ///< with --ideal-loop
    std::vector<IdleAxis> idle;       ///< axes that no linear answer at the design depends on
};

/// Whether a stored answer has as many charts, layers, panels and profiles as its sweep.
bool fits(const SweepAnswer& answer, const SweepSummary& summary);

/// Minutes of work for a nonlinear sweep, seconds otherwise. Charts and surfaces are those of spec.report.
SweepAnswer answer_sweep(const Spec& spec, const SweepSummary& summary);

}  // namespace stickslip
