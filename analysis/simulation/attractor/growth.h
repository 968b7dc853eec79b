// The growth rate of a small disturbance, measured by following it.
#pragma once
#include <cmath>

#include "analysis/simulation/flows/mode.h"

namespace stickslip {

/// How right a measured growth rate is, or it is not given.
inline constexpr double growth_precision = 1e-5;

/// Growth per time [1/s] of `probe`, a displacement from steady sliding whose size does not matter, along the mode:
/// the equations of motion are integrated over its window and what has become of l·(y − y_ss) is compared with what it
/// was. Not a number where rounding leaves less than growth_precision, as of a growth that is nearly none.
double measure_growth(const Flow& flow, const SlowMode& mode, const FlowVector& probe);

/// The same of an offset that may hardly excite the mode: it drowns where the mode itself, whose rate it is, still
/// shows.
template <class AnyFlow>
double growth_by_motion(const AnyFlow& flow, const SlowMode& mode, const FlowVector& offset)
{
    const double growth = measure_growth(flow, mode, offset);
    return std::isnan(growth) ? measure_growth(flow, mode, mode.right.real()) : growth;
}

/// The size of a small disturbance in units of the flow's scale: its own, or that of the mode that it excites, which
/// may be far larger, as a position that balances at V_0 starts without a change of speed and brings one about.
double size_of(const Flow& flow, const SlowMode& mode, const FlowVector& offset);

/// y moved on along its offset from steady sliding: a small disturbance that grows need not be watched while it is
/// linear, as its direction is known and its size does not matter.
FlowVector lifted(const Flow& flow, const SlowMode& mode, const FlowVector& y);

}  // namespace stickslip
