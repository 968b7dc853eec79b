// The paper's question: what velocity-only friction demands, and what friction with memory demands, of the same joint.
#pragma once
#include <optional>
#include <vector>

#include "analysis/joint/joint.h"
#include "analysis/stability/resolution.h"
#include "analysis/stability/verdict.h"

namespace stickslip {

struct StableGains;

/// Both theories about one joint. Gains of a stable set are open intervals of positive numbers.
struct Comparison {
    std::vector<Interval> k_v_velocity_only, k_v_memory;  ///< stable k_v at the joint's own k_p
    std::vector<Interval> k_p_velocity_only, k_p_memory;  ///< stable k_p at the joint's own k_v
    /// k_p that velocity-only forbids although memory allows them: the paper's second regime, Armstrong's stiff springs
    std::vector<Interval> forbidden_needlessly;
    /// k_p that velocity-only allows although memory forbids them: lag, LuGre, several masses
    std::vector<Interval> allowed_wrongly;
    double searched_to = infinity;  ///< k_p up to which the sets are complete
    bool known = true;  ///< false: the joint's own loop has not both gains to turn alone; every set is empty then

    /// The least k_v, to be exceeded, by either theory; NaN if none is enough.
    double k_v_demanded_velocity_only() const { return least(k_v_velocity_only); }
    double k_v_demanded_memory() const { return least(k_v_memory); }

  private:
    static double least(const std::vector<Interval>& set) { return set.empty() ? missing : set.front().low; }
};

/// Compares at the joint's commanded velocity. Without steady sliding every set is empty. Sets in k_v: complete without
/// delays and tables; with them by a scan of 60 logarithmic steps over nine decades, ends bisected to 1e-6.
Comparison compare_theories(const Joint& joint);
/// The same where the stable gains of the joint as it is given are known already. `joint` has the sum of gains of its
/// cascade, for sets in k_v; those in k_p turn what a user does, of a cascade in a real loop the position gain.
Comparison compare_theories(const Joint& joint, const Joint& as_given, const StableGains& gains);

/// The stable k_v at the joint's own k_p alone, by one theory; nothing where its loop has no k_v to turn alone.
std::optional<std::vector<Interval>> stable_velocity_gains(const Joint& joint, Theory theory);

/// A pair of gains on the boundary of stability (to be exceeded), chosen for its noise.
struct GainMix {
    double k_p = missing, k_v = missing;
    double noise = missing;  ///< √(k_p² + (ρ k_v)²): effort noise per position noise
};

/// The optimal mix of §5: of all pairs on the boundary with memory, that with the least effort noise
/// σ_u/σ_x = √(k_p² + (ρ k_v)²), ρ = σ_v/σ_x [1/s]. A velocity differenced from positions at the sample time T has
/// ρ = √2/T. The boundary is the lower end of the first stable interval in k_p; NaN where there is none for any k_v.
/// Nothing where the search for crossings is given up, as for delays far beyond the joint's own times.
GainMix optimal_mix(const Joint& joint, double velocity_noise);

/// The least k_p, to be exceeded, with which the joint is stable at its k_v by memory; NaN if none is, 0 if any is.
double least_position_gain(const Joint& joint);

}  // namespace stickslip
