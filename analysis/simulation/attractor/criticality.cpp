#include "analysis/simulation/attractor/criticality.h"

#include "analysis/simulation/attractor/bifurcation.h"
#include "analysis/stability/verdict.h"

#include <cmath>

namespace stickslip {
namespace {

/// A first Lyapunov coefficient, per ω, that decides nothing.
constexpr double degenerate_lyapunov = 1e-6;

}  // namespace

void add_bifurcation(const Joint& joint, const Flow& flow, const FlowVector& cycle_start, NonlinearVerdict& verdict)
{
    const auto* single = dynamic_cast<const SlidingFlow*>(&flow);  // the branch of cycles is followed for one body

    const double k_cr = linear_verdict(joint).state_variable.k_cr;
    const CycleOptions options;
    if (std::isfinite(k_cr) && k_cr > 0) {
        const auto at_critical = flow.with_gain(k_cr);
        const auto hopf = hopf_point(*at_critical);
        verdict.lyapunov = hopf.lyapunov;
        const bool weak = !(std::abs(hopf.lyapunov) > degenerate_lyapunov * hopf.omega);
        verdict.criticality = weak                ? Criticality::degenerate
                              : hopf.lyapunov > 0 ? Criticality::subcritical
                                                  : Criticality::supercritical;
        if (!single) return;
        if (const auto fold = fold_of_cycles(*at_critical, hopf, options)) verdict.fold_k_p = fold->k_p;
    }
    const bool smooth = single && single->states > 0 && cycle_start.size() > 0 && verdict.velocity_min > 0;
    const bool may_reach_beyond =
        verdict.region == NonlinearRegion::bistable ||
        (verdict.region == NonlinearRegion::stick_slip && std::isfinite(k_cr) && single && single->k_p < k_cr);
    if (!std::isnan(verdict.fold_k_p) || !smooth || !may_reach_beyond) return;
    // through a degenerate Hopf point the branch of the own cycle may go on above k_cr
    const auto last = last_at_rising_gain(flow, {single->k_p, cycle_start}, options);
    if (std::isfinite(k_cr) && single->k_p < k_cr && last.k_p < k_cr) return;
    if (const auto fold = fold_of_cycles(flow, last, options)) verdict.fold_k_p = fold->k_p;
}

}  // namespace stickslip
