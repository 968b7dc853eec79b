#include "analysis/boundary/kinds/linear_side.h"

#include "analysis/boundary/kinds/ray.h"
#include "analysis/boundary/trace/locate.h"
#include "analysis/loop/opened_loop.h"
#include "analysis/stability/linear_joint.h"
#include "analysis/stability/real_loop.h"

#include <cmath>

namespace stickslip {

Curve::Kind theory_of(BoundaryKind kind)
{
    return kind == BoundaryKind::velocity_only ? Curve::Kind::velocity_only : Curve::Kind::state_variable;
}

bool is_told_by_count(const Joint& joint, BoundaryKind kind)
{
    constexpr double slow = 50;  // of a place: its root takes seconds
    // friction of velocity alone is not delayed
    if (!is_linear(kind) || theory_of(kind) == Curve::Kind::velocity_only) return false;
    if (loop_kind(joint) == LoopKind::ideal) return false;
    const auto sliding = possible_sliding(joint);
    if (sliding.reason != Reason::none) return false;
    const auto linear = linear_joint(joint, sliding.slides_at);
    if (linear.rational()) return false;
    const auto loop = real_loop(joint, linear, sliding.slides_at, TurnedGain::all);
    const auto* delayed = loop ? std::get_if<DelayedLoop>(&loop->loop) : nullptr;
    return delayed && delayed->A.allFinite() && OpenedLoop(*delayed).cost() > slow;
}

double linear_side(const Joint& joint, BoundaryKind kind)
{
    const bool counted = is_told_by_count(joint, kind);
    const double growth = counted ? missing : instability(joint, theory_of(kind));
    if (!std::isnan(growth) || loop_kind(joint) == LoopKind::ideal) return growth;
    // a root that could not be located has a side all the same
    const auto sliding = possible_sliding(joint);
    if (sliding.reason != Reason::none) return missing;
    return real_side(joint, theory_of(kind) == Curve::Kind::velocity_only);
}

Region linear_region(const Joint& joint)
{
    if (!is_told_by_count(joint, BoundaryKind::state_variable)) return linear_point(joint).region;
    const double memory = linear_side(joint, BoundaryKind::state_variable);
    const bool simple = linear_side(joint, BoundaryKind::velocity_only) < 0;
    if (std::isnan(memory)) return PointResult{}.region;
    if (memory == 0) return Region::neutral;
    if (memory < 0) return simple ? Region::stable : Region::memory_only;
    return simple ? Region::velocity_only : Region::unstable;
}

}  // namespace stickslip
