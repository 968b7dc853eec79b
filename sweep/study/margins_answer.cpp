#include "sweep/study/margins_answer.h"

#include "analysis/stability/real_loop.h"
#include "analysis/stability/verdict.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// max Re s while one coordinate moves away from the joint, up to a little beyond its boundary.
Samples growth_line(const Joint& joint, const Coordinate& coordinate, double reach, double window)
{
    constexpr int steps = 240;
    MovableJoint movable(joint, {coordinate});
    Samples line;
    for (int i = -steps; i <= steps; ++i) {
        const double q = reach * i / steps;
        const double growth = linear_point(movable.at({q / coordinate.scale})).spectral_abscissa;
        line.x.push_back(std::exp(q));
        line.y.push_back(std::abs(growth) <= window ? growth : missing);
    }
    return line;
}

std::optional<std::size_t> shortest(const std::vector<NearestBoundary>& alone)
{
    std::optional<std::size_t> least;
    const auto length = [&](std::size_t i) {
        return std::abs(std::log(alone[i].moves[0].to / alone[i].moves[0].from));
    };
    for (std::size_t i = 0; i < alone.size(); ++i)
        if (alone[i].found && (!least || length(i) < length(*least))) least = i;
    return least;
}

}  // namespace

MarginsAnswer margins_of(const Joint& joint)
{
    MarginsAnswer answer;
    answer.joint = joint;
    answer.loop = verdict_loop(joint);
    auto coordinates = natural_coordinates(joint);
    answer.nearest = nearest_boundary(joint, coordinates, affordable_search(joint));
    if (!answer.nearest.decided) {
        answer.reason = possible_sliding(joint).reason;
        if (answer.reason == Reason::none) answer.reason = Reason::not_finite;
        return answer;
    }
    if (answer.nearest.found) answer.tolerance_each = tolerance_each(answer.nearest.distance, coordinates);
    // gains are chosen, not uncertain: in no direction does a joint differ from its file by them
    for (const char* gain : {"control.k_v", "control.k_p"})
        if (!std::isnan(value_of(joint, {gain, ""}))) coordinates.insert(coordinates.begin(), Coordinate{gain, ""});
    for (const auto& c : coordinates) {
        answer.alone_of.push_back(c);
        answer.alone.push_back(nearest_boundary(joint, {c}, affordable_search(joint)));
    }
    answer.shortest_alone = shortest(answer.alone);
    return answer;
}

std::optional<GrowthByParameter> growth_by_parameter(const MarginsAnswer& a)
{
    constexpr double beyond = 1.15;  // the logarithm of a change, past the farthest boundary
    const double window = shown_growth * std::abs(linear_point(a.joint).spectral_abscissa);
    GrowthByParameter growth;
    for (const auto& n : a.alone)
        if (n.found)
            growth.reach = std::max(growth.reach, beyond * std::abs(std::log(n.moves[0].to / n.moves[0].from)));
    if (growth.reach == 0) return {};
    for (std::size_t i = 0; i < a.alone.size(); ++i)
        growth.lines.push_back(a.alone[i].found ? growth_line(a.joint, a.alone_of[i], growth.reach, window)
                                                : Samples{});
    return growth;
}

}  // namespace stickslip
