#include "sweep/report/boundary_report.h"

#include "analysis/joint/parameters.h"
#include "analysis/results/text.h"
#include "analysis/stability/verdict.h"
#include "sweep/files/spec_file.h"
#include "sweep/report/verdict_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

using Tone = Headline::Tone;
constexpr int map_nodes = 81;
constexpr double widened = 1e3;  ///< how far beyond its axis a boundary is looked for, to either side

std::string scientific(double value)
{
    if (!(value > 0)) return "0";
    const int exponent = static_cast<int>(std::floor(std::log10(value)));
    return fmt::format("{:.1f}×10^{{{}{}}}", value / std::pow(10, exponent), exponent < 0 ? "−" : "",
                       std::abs(exponent));
}

std::string direction_text(int direction)
{
    return direction > 0 ? "unstable above" : direction < 0 ? "stable above" : "–";
}

Table ray_table(const Joint& design, const LocatedRay& ray)
{
    const auto motion = design.mechanism.motion;
    Table table;
    table.title = std::string(name_of(ray.kind)) + " boundaries along " + ray.axis.symbol;
    table.columns = {
        ray.axis.name + " " + ray.axis.symbol, "side", "relative bracket", "status", "method", "evaluations"};
    for (const auto& p : ray.points)
        table.rows.push_back({with_unit(p.value, ray.axis.quantity, motion, 10), direction_text(p.direction),
                              scientific(p.precision()), p.converged ? "located" : "coarse",
                              std::string(name_of(p.method)), std::to_string(p.evaluations)});
    return table;
}

Table guard_table(const std::vector<FollowedBoundary>& curves)
{
    Table table;
    table.title = "How each curve was followed";
    table.columns = {"kind", "pieces", "points", "coarsest bracket", "evaluations", "ends", "what could be missed"};
    for (const auto& c : curves) {
        std::string ends;
        for (const auto& piece : c.pieces) {
            ends += ends.empty() ? "" : "; ";
            ends += piece.last == CurveEnd::closed
                        ? std::string("closed")
                        : std::string(name_of(piece.first)) + " – " + std::string(name_of(piece.last));
        }
        table.rows.push_back({std::string(name_of(c.kind)), std::to_string(c.pieces.size()), std::to_string(c.points()),
                              scientific(c.precision()), std::to_string(c.evaluations), ends.empty() ? "–" : ends,
                              could_be_missed(c)});
    }
    return table;
}

bool same_axes(const FollowedBoundary& a, const FollowedBoundary& b)
{
    return a.x.path == b.x.path && a.y.path == b.y.path && a.x.values == b.x.values && a.y.values == b.y.values;
}

Figure curve_figure(const BoundaryAnswer& answer, const std::vector<FollowedBoundary>& curves,
                    const ParallelFor& parallel)
{
    const auto& first = curves.front();
    auto map = map_under(answer.design, first.x, first.y, parallel);
    std::string kinds;
    for (const auto& c : curves) {
        if (!c.pieces.empty()) map.curves.push_back(curve_of(c));
        kinds += (kinds.empty() ? "" : ", ") + std::string(name_of(c.kind)) + " (" + std::to_string(c.points()) +
                 " points, brackets ≤ " + scientific(c.precision()) + ")";
    }
    Figure figure;
    figure.id = "boundaries";
    for (const auto* axis : {&first.x, &first.y}) {
        figure.id += '-';
        for (const char c : axis->path.substr(axis->path.rfind('.') + 1))
            figure.id += std::isalnum(static_cast<unsigned char>(c)) ? static_cast<char>(std::tolower(c)) : '-';
    }
    figure.finding = "Boundaries over " + first.x.name + " and " + first.y.name + ": " + kinds + ".";
    figure.caption =
        "Located curves: " + kinds +
        ". Each point is bracketed; the brackets are far narrower than the lines. Field: largest real part "
        "of the spectrum, with memory.";
    figure.picture = std::move(map);
    return figure;
}

std::string kind_words(BoundaryKind kind)
{
    switch (kind) {
        case BoundaryKind::velocity_only:
            return "velocity-only boundary";
        case BoundaryKind::state_variable:
            return "linear boundary with memory";
        case BoundaryKind::fold:
            return "fold of limit cycles";
        case BoundaryKind::v_min:
            return "least stable velocity";
        case BoundaryKind::outcome:
            break;
    }
    return "boundary of the outcome";
}

/// Where a curve meets the design's own line along one of its axes, the other number held: the meeting nearest to the
/// design, interpolated between located points; NaN where it does not.
double meeting(const FollowedBoundary& c, const Joint& given, bool along_x)
{
    const Axis &along = along_x ? c.x : c.y, &across = along_x ? c.y : c.x;
    Joint joint = given;
    const auto drawn = [](const Axis& axis, double v) { return axis.log ? std::log(v) : v; };
    const double own = drawn(along, *find_parameter(joint, along.path)),
                 held = drawn(across, *find_parameter(joint, across.path));
    double found = missing;
    for (const auto& piece : c.pieces)
        for (std::size_t i = 0; i + 1 < piece.points.size(); ++i) {
            const auto &p = piece.points[i], &q = piece.points[i + 1];
            const double a = drawn(across, along_x ? p.y : p.x) - held, b = drawn(across, along_x ? q.y : q.x) - held;
            if (a * b > 0 || a == b) continue;
            const double from = drawn(along, along_x ? p.x : p.y), to = drawn(along, along_x ? q.x : q.y);
            const double at = from + (to - from) * a / (a - b);
            if (std::isnan(found) || std::abs(at - own) < std::abs(found - own)) found = at;
        }
    return along.log ? std::exp(found) : found;
}

/// One number for each curve and axis on which it lies before or behind the design.
std::vector<Headline> meeting_headlines(const BoundaryAnswer& answer)
{
    constexpr std::size_t most = 5;
    std::vector<Headline> list;
    Joint joint = answer.design;
    const auto motion = joint.mechanism.motion;
    for (const auto& c : answer.curves)
        for (const bool along_x : {true, false}) {
            const Axis& axis = along_x ? c.x : c.y;
            const double own = *find_parameter(joint, axis.path), at = meeting(c, joint, along_x);
            if (std::isnan(at) || own == 0 || list.size() == most) continue;
            const double change = at / own - 1;
            list.push_back(
                {Tone::neutral, axis.symbol + (change < 0 ? " −" : " +") + plain_number(100 * std::abs(change)) + " %",
                 "from the design to the " + kind_words(c.kind) + ": " + with_unit(own, axis.quantity, motion, 4) +
                     " to " + with_unit(at, axis.quantity, motion, 4)});
        }
    return list;
}

/// "Through the design along k_{p}: linear boundary with memory at 19.45 kN/m, fold of limit cycles at 24.85 kN/m."
std::string meeting_text(const BoundaryAnswer& answer)
{
    const auto motion = answer.design.mechanism.motion;
    for (const bool along_x : {true, false}) {
        std::string text;
        for (const auto& c : answer.curves)
            if (const double at = meeting(c, answer.design, along_x); !std::isnan(at)) {
                const Axis& axis = along_x ? c.x : c.y;
                text += (text.empty() ? "Through the design along " + axis.symbol + ": " : ", ") + kind_words(c.kind) +
                        " at " + with_unit(at, axis.quantity, motion, 4);
            }
        if (!text.empty()) return text + ".";
    }
    return "No followed curve meets the design's own lines through the chart.";
}

/// The nearest linear boundary outside the range of a ray that has none.
std::string outside_text(const Joint& design, const LocatedRay& ray)
{
    if (ray.kind == BoundaryKind::fold || ray.kind == BoundaryKind::outcome || !(ray.axis.values.front() > 0))
        return "";
    Axis wider = ray.axis;
    wider.log = true;
    wider.values = {ray.axis.values.front() / widened, ray.axis.values.back() * widened};
    BoundaryRequest request;
    request.kind = ray.kind;
    const auto motion = design.mechanism.motion;
    const auto found = locate_boundaries(design, wider, request).points;
    if (found.empty())
        return " None lies within " + with_unit(wider.values[0], wider.quantity, motion) + " … " +
               with_unit(wider.values[1], wider.quantity, motion) + " either.";
    const auto away = [&](const BoundaryPoint& p) {
        return std::max(ray.axis.values.front() / p.value, p.value / ray.axis.values.back());
    };
    const auto nearest =
        *std::min_element(found.begin(), found.end(), [&](const auto& a, const auto& b) { return away(a) < away(b); });
    return " The nearest one outside lies at " + ray.axis.symbol + " = " +
           with_unit(nearest.value, wider.quantity, motion, 8) + ".";
}

}  // namespace

std::string could_be_missed(const LocatedRay& ray)
{
    std::string text = fmt::format("two boundaries of one kind within 1/{} of the range", ray.nodes - 1);
    if (ray.climbed > 0) text += fmt::format(" ({} near touches were searched)", ray.climbed);
    if (ray.kind == BoundaryKind::fold)
        text += "; cycles that neither a subcritical linear boundary nor a start from near rest leads to";
    if (ray.undecided > 0) text += fmt::format("; {} of {} scanned points have no verdict", ray.undecided, ray.nodes);
    return text;
}

std::string could_be_missed(const FollowedBoundary& c)
{
    std::string text = fmt::format("a closed piece smaller than 1/{:.0f} of an axis", 1 / c.guard.cell);
    if (c.guard.climbed > 0)
        text += fmt::format(" that none of {} climbs between the nodes met ({} islands found so)", c.guard.climbed,
                            c.guard.islands);
    if (c.kind == BoundaryKind::fold)
        text += "; cycles that neither a subcritical linear boundary nor a start from near rest leads to";
    if (c.guard.unexplained > 0)
        text += fmt::format("; {} of {} changes of side on the grid were not followed", c.guard.unexplained,
                            c.guard.changes);
    if (c.guard.undecided > 0)
        text += fmt::format("; {} of {} grid points have no verdict", c.guard.undecided, c.guard.nodes);
    return text;
}

std::string ray_text(const Joint& design, const LocatedRay& ray)
{
    const auto motion = design.mechanism.motion;
    const std::string range = with_unit(ray.axis.values.front(), ray.axis.quantity, motion) + " … " +
                              with_unit(ray.axis.values.back(), ray.axis.quantity, motion);
    if (ray.undecided == ray.nodes) {
        Joint first = design;
        *find_parameter(first, ray.axis.path) = ray.axis.values.front();
        const auto reason = linear_verdict(first).steady.reason;
        return "No verdict along " + ray.axis.symbol + ": the joint cannot be judged at any of the " +
               std::to_string(ray.nodes) + " points of the scan" +
               (reason == Reason::none ? "." : ". At the first: " + reason_text(reason) + ".");
    }
    if (ray.points.empty()) {
        const bool all = ray.stable_share > 1 - 1e-12, none = ray.stable_share == 0;
        const std::string state = all ? "stable throughout" : none ? "unstable throughout" : "";
        return "No " + std::string(name_of(ray.kind)) + " boundary along " + ray.axis.symbol + " within " + range +
               (state.empty() || ray.kind == BoundaryKind::fold ? "" : ": " + state) + "." + outside_text(design, ray);
    }
    std::string text = std::string(name_of(ray.kind)) + " boundary along " + ray.axis.symbol + " at ";
    for (const auto& p : ray.points)
        text += (&p == &ray.points.front() ? "" : ", ") + with_unit(p.value, ray.axis.quantity, motion, 8) + " (" +
                direction_text(p.direction) + ")";
    return text + ".";
}

StabilityMap map_under(const Joint& design, Axis x, Axis y, const ParallelFor& parallel)
{
    x.values = spaced(x.values.front(), x.values.back(), map_nodes, x.log);
    y.values = spaced(y.values.front(), y.values.back(), map_nodes, y.log);
    StabilityMap map;
    map.motion = design.mechanism.motion;
    map.title = "Boundaries of sliding over (" + x.symbol + ", " + y.symbol + ")";
    map.abscissa.resize(x.values.size() * y.values.size());
    map.region.resize(map.abscissa.size());
    parallel(y.values.size(), [&](std::size_t j) {
        Joint joint = design;
        double &u = *find_parameter(joint, x.path), &v = *find_parameter(joint, y.path);
        for (std::size_t i = 0; i < x.values.size(); ++i) {
            u = x.values[i], v = y.values[j];
            const auto row = linear_point(joint);
            map.abscissa[j * x.values.size() + i] = row.spectral_abscissa;
            map.region[j * x.values.size() + i] = row.region;
        }
    });
    const auto shares = area_shares(x, y);
    for (std::size_t i = 0; i < shares.size(); ++i) {
        if (map.region[i] == Region::memory_only || map.region[i] == Region::velocity_only)
            map.disagreement += shares[i];
        if (map.region[i] == Region::undecided) map.undecided += shares[i];
    }
    Joint joint = design;
    const auto row = linear_point(design);
    map.design.x = *find_parameter(joint, x.path), map.design.y = *find_parameter(joint, y.path);
    map.design.inside = map.design.x >= x.values.front() && map.design.x <= x.values.back() &&
                        map.design.y >= y.values.front() && map.design.y <= y.values.back();
    map.design.region = row.region;
    map.design.spectral_abscissa = row.spectral_abscissa;
    map.has_design = true;
    map.x = std::move(x), map.y = std::move(y);
    return map;
}

Report boundary_report(const BoundaryAnswer& answer, const ParallelFor& parallel)
{
    Report report;
    report.title = answer.title.empty() ? "Boundaries of sliding" : answer.title;
    report.subtitle = "boundaries, located";
    for (const auto& ray : answer.rays)
        report.verdict += (report.verdict.empty() ? "" : " ") + ray_text(answer.design, ray);
    if (!answer.curves.empty()) {
        report.verdict += (report.verdict.empty() ? "" : " ") + meeting_text(answer);
        report.headlines = meeting_headlines(answer);
    }
    if (linear_point(answer.design).spectral_abscissa > 0) {
        report.tone = Tone::bad;
        report.alerts.push_back({Tone::bad, "The design itself is unstable: small disturbances of sliding grow."});
    }
    Section curves{"curves", "Curves", "", {}, {}};
    for (std::size_t i = 0; i < answer.curves.size();) {
        std::vector<FollowedBoundary> together;
        while (i < answer.curves.size() && (together.empty() || same_axes(together.front(), answer.curves[i])))
            together.push_back(answer.curves[i++]);
        curves.figures.push_back(curve_figure(answer, together, parallel));
    }
    if (!answer.curves.empty()) {
        curves.tables.push_back(guard_table(answer.curves));
        report.sections.push_back(std::move(curves));
    }
    Section rays{"rays", "Along single parameters", "", {}, {}};
    for (const auto& ray : answer.rays)
        if (!ray.points.empty()) rays.tables.push_back(ray_table(answer.design, ray));
    if (!rays.tables.empty()) report.sections.push_back(std::move(rays));
    for (const auto& ray : answer.rays)
        report.not_checked.push_back(std::string(name_of(ray.kind)) + " along " + ray.axis.symbol + ": " +
                                     could_be_missed(ray) + ".");
    for (const auto& c : answer.curves) {
        report.not_checked.push_back(std::string(name_of(c.kind)) + " over " + c.x.symbol + " and " + c.y.symbol +
                                     ": " + could_be_missed(c) + ".");
        for (const auto& piece : c.pieces)
            for (const auto end : {piece.first, piece.last})
                if (end == CurveEnd::lost)
                    report.alerts.push_back({Tone::warning, "A piece of the " + std::string(name_of(c.kind)) +
                                                                " boundary could not be followed to its end."});
    }
    report.provenance = {{"command", answer.command}};
    return report;
}

}  // namespace stickslip
