// From joints to jobs of the lanes and back: the groups of a joint, one job for all joints of equal groups.
#pragma once
#include <optional>
#include <span>

#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/lanes/job.h"

namespace stickslip::lanes {

/// A joint in the units of its law.
struct Scaled {
    using Job = lanes::Job;
    using Answer = lanes::Answer;
    Groups groups;
    double length;      ///< L
    double velocity;    ///< V_0
    double deflection;  ///< δ_ss
};

/// Groups of a joint that the lanes can follow: one mass, the slip or the ageing law with one state and nothing
/// else, k_p > 0.
/// Each group is rounded to 44 bits, so that points which differ by roundoff only are one, whatever else is in the
/// sweep.
std::optional<Scaled> scaled(const Joint& joint);

/// Whether these options are answered by lanes: a disturbance of any kind and stated size, or the small one of kind
/// `position`, and acceleration.
bool covers(const NonlinearOptions& options);

/// The job of a set of groups: the slow eigenvalue, a small disturbance lifted along its mode, and the start from near
/// rest.
Job job(const Groups& groups, bool search);

/// Puts a disturbance of stated size in the place of the small one, as `disturbed` (mode.h) has it; false if the
/// reference must follow it.
bool state(const Disturbance& disturbance, const Joint& joint, const Scaled& scale, Job& job);

/// The fields of a row from an answer; false if the reference must decide.
bool write(const Answer& answer, const Scaled& scale, const Job& job, PointResult& point);

/// What `answer` says of a small disturbance that decays, without the search for other outcomes: it follows from the
/// linear theory and no motion is needed. False where lanes do not answer the joint or the disturbance does not decay.
bool decay(const Joint& joint, const NonlinearOptions& options, PointResult& point);

/// Answers the joints that lanes cover; the numbers of the others are appended to `left_over` in ascending order.
void answer(std::span<const Joint> joints, const NonlinearOptions& options, std::span<PointResult> points,
            std::vector<std::size_t>& left_over);

/// −1 where a disturbance of stated size decays, +1 where it does not, NaN where lanes do not tell. A motion that is
/// sure not to come back is not followed to its end. A search for coexisting outcomes (`region`) changes nothing.
void sides(std::span<const Joint> joints, const NonlinearOptions& options, std::span<double> sides);

}  // namespace stickslip::lanes
