#include "sweep/program/verbs/boundary_question.h"

#include "analysis/simulation/attractor/large_disturbance.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/program/verbs/parallel.h"

#include <fmt/format.h>

#include <algorithm>

namespace stickslip {
namespace {

std::vector<BoundaryKind> kinds_asked(const Asked& asked, const BoundaryOptions& options)
{
    std::vector<BoundaryKind> kinds;
    for (const auto& name : options.kinds)
        for (const auto kind : boundary_kinds)
            if (name_of(kind) == name) kinds.push_back(kind);
    if (kinds.empty() && asked.spec.boundary) kinds = asked.spec.boundary->kinds;
    if (kinds.empty()) kinds = {BoundaryKind::velocity_only, BoundaryKind::state_variable};
    return kinds;
}

Disturbance disturbance_asked(const Asked& asked, const BoundaryOptions& options)
{
    Disturbance d = asked.spec.nonlinear.disturbance.disturbance;
    for (const auto& k : DisturbanceSpec::kinds)
        if (k.name == options.disturbance) d = {k.value, missing};
    if (is_set(options.size)) d.size = options.size;
    if (options.disturbance.empty() && !is_set(d.size)) d = {DisturbanceKind::start, near_rest_start};
    if (is_set(d.size) && !(d.size >= 0))
        throw BadInput(fmt::format(
            "{}: got {:g}, expected {}", is_set(options.size) ? "--size" : "nonlinear.disturbance.size", d.size,
            d.kind == DisturbanceKind::start ? "a share of V0 to start from, ≥ 0"
                                             : "≥ 0: a boundary of outcomes asks how large a disturbance is"));
    return d;
}

/// Axes along and over which boundaries are wanted.
struct Places {
    std::vector<Axis> rays;
    std::vector<std::array<Axis, 2>> charts;
};

Places places_asked(const Asked& asked, const BoundaryOptions& options)
{
    const auto& spec = asked.spec;
    Places places;
    const auto add = [&](const std::vector<std::string>& along, const std::vector<std::string>& over,
                         const std::string& along_name, const std::string& over_name) {
        for (const auto& text : along) {
            auto axis = axis_from(asked, text, along_name);
            for (const auto& other : places.rays)
                if (other.path == axis.path)
                    throw BadInput(along_name + ": got " + axis.path + " twice, expected different axes");
            places.rays.push_back(std::move(axis));
        }
        if (over.empty()) return;
        places.charts.push_back({axis_from(asked, over[0], over_name), axis_from(asked, over[1], over_name)});
        if (places.charts[0][0].path == places.charts[0][1].path)
            throw BadInput(over_name + ": got " + places.charts[0][0].path + " twice, expected two different axes");
    };
    add(options.along, options.over, "--along", "--over");
    if (!places.rays.empty() || !places.charts.empty()) return places;
    if (spec.boundary) add(spec.boundary->along, spec.boundary->over, "boundary.along", "boundary.over");
    if (!places.rays.empty() || !places.charts.empty()) return places;
    if (spec.axes.empty()) places.rays.push_back(axis_from(asked, "control.k_p", "--along"));
    for (const auto& axis : spec.axes)
        if (axis.values.size() > 1) places.rays.push_back(axis_from(asked, axis.path, "--along"));
    for (const auto& [x, y] : spec.report.charts)
        places.charts.push_back({axis_from(asked, x, "--over"), axis_from(asked, y, "--over")});
    return places;
}

/// Whether the user named the places; otherwise they are what the spec suggests for all kinds.
bool named(const Asked& asked, const BoundaryOptions& options)
{
    if (!options.along.empty() || !options.over.empty()) return true;
    return asked.spec.boundary && !(asked.spec.boundary->along.empty() && asked.spec.boundary->over.empty());
}

void require_velocity(const std::vector<Axis>& axes)
{
    if (axes.back().path == "control.V0") return;
    if (axes.size() == 1)
        throw BadInput("--along " + axes[0].path +
                       ": the least velocity lies along control.V0; over another axis: --over " + axes[0].path +
                       " control.V0");
    throw BadInput("--over " + axes[0].path + " " + axes[1].path + ": the least velocity needs control.V0 as y axis");
}

}  // namespace

std::vector<Axis> linear_axes(const std::vector<BoundaryQuestion>& questions)
{
    std::vector<Axis> list;
    for (const auto& [request, axes] : questions) {
        if (!is_linear(request.kind)) continue;
        for (const auto& axis : axes)
            if (std::none_of(list.begin(), list.end(), [&](const Axis& a) { return a.path == axis.path; }))
                list.push_back(axis);
    }
    return list;
}

std::vector<BoundaryQuestion> boundary_questions(const Asked& asked, const BoundaryOptions& options)
{
    const auto places = places_asked(asked, options);
    const auto& table = asked.spec.boundary;
    BoundaryRequest request;
    request.parallel = parallel_for_each;
    request.disturbance = disturbance_asked(asked, options);
    request.following.guard = options.guard > 0               ? options.guard
                              : table && is_set(table->guard) ? static_cast<int>(table->guard)
                                                              : 0;
    const auto kinds = kinds_asked(asked, options);
    const bool by_name = named(asked, options);
    std::vector<BoundaryQuestion> rays, charts;
    for (const auto kind : kinds) {
        BoundaryRequest own = request;
        own.kind = kind;
        // of a precision for all kinds, each takes what it can reach
        own.precision = is_set(options.precision)           ? options.precision
                        : table && is_set(table->precision) ? std::max(table->precision, default_precision(kind))
                                                            : not_set;
        const bool least_velocity = kind == BoundaryKind::v_min;
        const auto ask = [&](std::vector<BoundaryQuestion>& list, std::vector<Axis> axes) {
            if (least_velocity && by_name) require_velocity(axes);
            if (!least_velocity || axes.back().path == "control.V0") list.push_back({own, std::move(axes)});
        };
        if (least_velocity && !by_name)
            rays.push_back({own, {axis_from(asked, "control.V0", "--along")}});
        else
            for (const auto& axis : places.rays) ask(rays, {axis});
        for (const auto& [x, y] : places.charts) ask(charts, {x, y});
    }
    // curves of one chart stand together
    std::stable_sort(charts.begin(), charts.end(), [&](const auto& a, const auto& b) {
        const auto index = [&](const BoundaryQuestion& q) {
            return std::find_if(places.charts.begin(), places.charts.end(), [&](const auto& c) {
                return c[0].path == q.axes[0].path && c[1].path == q.axes[1].path;
            });
        };
        return index(a) < index(b);
    });
    rays.insert(rays.end(), charts.begin(), charts.end());
    return rays;
}

std::string disturbance_text(const Disturbance& d, Units units)
{
    for (const auto& k : DisturbanceSpec::kinds) {
        if (k.value != d.kind) continue;
        if (!is_set(d.size)) return std::string(k.name) + " (small)";
        std::string_view unit;
        switch (d.kind) {
            case DisturbanceKind::position:
            case DisturbanceKind::offset:
                unit = unit_of(Quantity::position, units);
                break;
            case DisturbanceKind::velocity:
                unit = unit_of(Quantity::velocity, units);
                break;
            case DisturbanceKind::impulse:
                unit = unit_of(Quantity::impulse, units);
                break;
            case DisturbanceKind::state:
                unit = unit_of(Quantity::effort, units);
                break;
            case DisturbanceKind::start:
                return d.size > 0 ? fmt::format("start from {:g} V_{{0}}", d.size) : "start from rest";
        }
        return fmt::format("{} of {:g} {}", k.name, d.size, unit);
    }
    return "";
}

}  // namespace stickslip
