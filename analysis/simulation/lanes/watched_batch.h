// From joints with two states or bristles to jobs of the lanes and back.
#pragma once
#include <optional>

#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/lanes/watched_job.h"

namespace stickslip::lanes {

/// A joint in the units of its law.
struct WatchedScaled {
    using Job = WatchedJob;
    using Answer = WatchedAnswer;
    WatchedGroups groups;
    double length;      ///< L_1, g/σ0, L
    double velocity;    ///< V_0
    double force;       ///< A, g: with the load
    double deflection;  ///< δ_ss
};

/// Groups of a joint that the lanes can follow, k_p > 0: one mass, the slip or the ageing law with two states or LuGre
/// with nothing beside it; two masses as two_masses (two_mass_joint.h) has them.
std::optional<WatchedScaled> watched_scaled(const Joint& joint);

bool less(const WatchedGroups& a, const WatchedGroups& b);

/// As for the slip law (batch.h); starts are those of the reference.
WatchedJob job(const WatchedGroups& groups, bool search);
bool state(const Disturbance& disturbance, const Joint& joint, const WatchedScaled& scale, WatchedJob& job);

/// The fields of a row from an answer; false if the reference must decide.
bool write(const WatchedAnswer& answer, const WatchedScaled& scale, const WatchedJob& job, PointResult& point);

}  // namespace stickslip::lanes
