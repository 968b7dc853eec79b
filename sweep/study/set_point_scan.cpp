#include "sweep/study/set_point_scan.h"

#include "analysis/simulation/set_point/regulator.h"
#include "analysis/simulation/set_point/set_point.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr int pushes = 40;
constexpr double beyond_static = 1.3;  ///< of the static friction: how far pushes are looked at
constexpr int starts_per_decade = 8;   ///< a picture is no proof
constexpr double widest_margin = 0.3;
constexpr int margins = 13;

/// The joint with this push as effort and the integral of the ways that integrate.
Joint pushed(Joint joint, const SetPointRequirements& asked, double k_i, double effort)
{
    auto& c = joint.control;
    const double per_signal = regulator_of(joint).k_p / c.k_p;
    c.k_i = k_i;
    c.dead_zone = 0;
    c.dither.amplitude = 0;
    c.feed_forward.coulomb = effort / per_signal;
    c.feed_forward.coulomb_from = CoulombFrom::error;
    c.feed_forward.coulomb_width = 0;
    if (is_set(asked.push_speed)) c.feed_forward.coulomb_speed = asked.push_speed;
    return joint;
}

double stops_at(const Joint& joint)
{
    const auto s = set_point(joint, {starts_per_decade, false});
    if (s.hunting == Hunting::undecided) return missing;
    return s.hunting == Hunting::yes ? s.amplitude : s.rest_error;
}

/// From a distance of twice what hunting reaches, for three of its periods.
ReleasedMotion released(const Joint& joint, double distance, double duration)
{
    constexpr int rows = 1500;
    ReferenceMotion reference;
    for (int i = 0; i < rows; ++i) {
        reference.time.push_back(duration * i / (rows - 1));
        reference.position.push_back(i == 0 ? -distance : 0);  // begins at its first row, at rest
        reference.velocity.push_back(0);
    }
    const auto record = record_along(joint, reference, 0);
    ReleasedMotion motion;
    for (std::size_t i = 0; i < record.time.size(); ++i) {
        motion.time.push_back(record.time[i]);
        motion.error.push_back(-record.position[i]);
    }
    return motion;
}

}  // namespace

SetPointScan set_point_scan(const Joint& joint, const SetPointRequirements& asked, const SetPointDesign& design,
                            const ParallelFor& parallel)
{
    SetPointScan scan;
    const auto hunting = set_point(pushed(joint, asked, design.k_i_used, 0));
    const double level = hunting.own_level;
    if (asked.over_push && level > 0) {
        for (int i = 0; i < pushes; ++i) scan.push.push_back(beyond_static * level * i / (pushes - 1));
        scan.amplitude.resize(scan.push.size(), missing);
        parallel(scan.push.size(), [&](std::size_t i) {
            scan.amplitude[i] = stops_at(pushed(joint, asked, design.k_i_used, scan.push[i]));
        });
    }
    for (int i = 0; i < margins; ++i) scan.margins.push_back(widest_margin * i / (margins - 1));
    for (const double margin : scan.margins) {
        auto r = asked;
        r.friction_margin = margin;
        r.over_dead_zone = false;
        r.k_i = design.k_i_used;
        r.starts_per_decade = starts_per_decade;
        scan.designs.push_back(design_set_point(joint, r, parallel));
    }
    if (design.best < 0) return scan;
    const auto& best = design.choices[static_cast<std::size_t>(design.best)];
    const double reach = is_set(hunting.amplitude) ? hunting.amplitude : level / joint.control.k_p;
    const double spring = std::sqrt(joint.mechanism.inertia / std::abs(regulator_of(joint).k_p));
    const double duration = is_set(hunting.period) ? 3 * hunting.period : 200 * spring;
    scan.before = released(pushed(joint, asked, design.k_i_used, 0), 2 * reach, duration);
    scan.after = released(with_choice(joint, best), 2 * reach, duration);
    return scan;
}

}  // namespace stickslip
