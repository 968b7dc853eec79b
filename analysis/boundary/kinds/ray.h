// Boundaries along one axis of a joint, between the nodes of a scan. Internal to analysis/boundary/kinds.
#pragma once
#include "analysis/boundary/kinds/boundary.h"

namespace stickslip {

/// With a request whose precision, scan and parallel are set. Throws std::invalid_argument for a path that the joint
/// lacks.
LocatedRay locate_on_ray(const Joint& joint, const Axis& axis, const BoundaryRequest& request);

/// Why a joint has no side; none where that is not known. Of a set point its own answer says it.
Reason reason_without_side(const Joint& joint, const BoundaryRequest& request);

}  // namespace stickslip
