// What located boundaries say, in words.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/boundary.h"
#include "analysis/results/report.h"
#include "sweep/study/idle_axes.h"

#include <string>
#include <vector>

namespace stickslip {

/// "stable above" of a direction as in BoundaryPoint.
std::string direction_text(int direction, BoundaryKind kind = BoundaryKind::state_variable);

/// What the search does not exclude, in words.
std::string could_be_missed(const LocatedRay& ray);
std::string could_be_missed(const FollowedBoundary& curve);

/// What the answer of a ray is, in a sentence, with the nearest boundary outside where there is none inside.
std::string ray_text(const Joint& design, const LocatedRay& ray, const std::vector<IdleAxis>& idle = {});

/// What a design of that region does, in a sentence, and how good that is.
std::string design_words(Region region);
Headline::Tone design_tone(Region region);

}  // namespace stickslip
