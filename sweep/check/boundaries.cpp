#include "sweep/check/boundaries.h"

#include "analysis/boundary/locate.h"
#include "analysis/joint/parameters.h"
#include "sweep/report/maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace stickslip {
namespace {

constexpr int rays_per_chart = 9;

const Axis* axis_of(const Spec& spec, const std::string& path)
{
    for (const auto& axis : spec.axes)
        if (axis.path == path) return &axis;
    return nullptr;
}

void watch_ray(std::vector<WatchedBoundary>& watched, const Spec& spec, const Axis& along,
               const std::vector<Held>& held)
{
    const Joint joint = joint_at(design_joint(spec), held);
    for (const auto theory : {Curve::Kind::velocity_only, Curve::Kind::state_variable}) {
        int number = 0;
        for (const auto& point :
             locate_on_ray(joint, along.path, along.values.front(), along.values.back(), along.log, theory)) {
            WatchedBoundary w;
            w.theory = theory == Curve::Kind::velocity_only ? "velocity_only" : "state_variable";
            w.axis = along.path;
            w.unit = unit_of(along.quantity, spec.joint.mechanism.motion);
            for (const auto& h : held) w.at.emplace_back(h.axis.path, h.value);
            w.number = number++;
            w.point = point;
            w.tolerance = std::max(spec.check.tolerance, 4 * point.precision());
            watched.push_back(std::move(w));
        }
    }
}

}  // namespace

std::string WatchedBoundary::name() const
{
    std::string text = fmt::format("{} along {} [{}]", theory, axis, number);
    for (const auto& [path, value] : at)
        text += fmt::format("{}{} = {:.9g}", &path == &at.front().first ? " at " : ", ", path, value);
    return text;
}

std::vector<WatchedBoundary> watched_boundaries(const Spec& spec)
{
    std::vector<WatchedBoundary> watched;
    for (const auto& axis : spec.axes) watch_ray(watched, spec, axis, {});
    for (const auto& [x, y] : spec.report.charts) {
        const Axis *along = axis_of(spec, x), *across = axis_of(spec, y);
        if (!along || !across) continue;
        const int last = static_cast<int>(across->values.size()) - 1;
        std::set<int> places;
        for (int i = 0; i < rays_per_chart; ++i) places.insert(i * last / (rays_per_chart - 1));
        for (const int i : places)
            watch_ray(watched, spec, *along, {{*across, across->values[static_cast<std::size_t>(i)]}});
    }
    return watched;
}

std::vector<Deviation> compare(const std::vector<WatchedBoundary>& stored, const std::vector<WatchedBoundary>& now)
{
    std::map<std::string, const WatchedBoundary*> left;
    for (const auto& w : now) left[w.name()] = &w;
    std::vector<Deviation> deviations;
    for (const auto& s : stored) {
        Deviation d;
        d.stored = s;
        if (const auto it = left.find(s.name()); it == left.end()) {
            d.kind = Deviation::Kind::vanished;
        } else {
            d.now = *it->second;
            left.erase(it);
            d.relative = std::abs(d.now.point.value - s.point.value) / std::abs(s.point.value);
            if (!(d.relative <= s.tolerance)) d.kind = Deviation::Kind::moved;
        }
        deviations.push_back(std::move(d));
    }
    for (const auto& w : now)
        if (left.contains(w.name())) deviations.push_back({Deviation::Kind::appeared, {}, w, 0});
    return deviations;
}

}  // namespace stickslip
