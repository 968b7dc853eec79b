#include "sweep/words/boundary_text.h"

#include "analysis/results/text.h"
#include "sweep/words/idle_text.h"
#include "sweep/words/reason_text.h"

#include <fmt/format.h>

#include <cctype>

namespace stickslip {
namespace {

/// "from 3 Ω to 30 kΩ", "at 2 Ω, from 3 Ω to 5 Ω"; of many stretches where the first begins and the last ends.
std::string stretches_text(std::vector<ScanStretch> stretches, Quantity quantity, Units units)
{
    constexpr std::size_t most_told = 3;
    const bool many = stretches.size() > most_told;
    const std::string count = std::to_string(stretches.size());
    if (many) stretches = {{stretches.front().low, stretches.back().high}};
    std::string text;
    for (const auto& s : stretches) {
        text += text.empty() ? "" : ", ";
        text += s.low == s.high ? "at " + with_unit(s.low, quantity, units)
                                : range_text(s.low, s.high, quantity, units, {"from ", " to ", ""});
    }
    return many ? "in " + count + " stretches " + text : text;
}

/// "85 of 201 points have none: from 3 Ω to 30 kΩ".
std::string without_verdict_text(int undecided, int nodes, const std::vector<ScanStretch>& stretches, Quantity quantity,
                                 Units units)
{
    return std::to_string(undecided) + " of " + std::to_string(nodes) +
           (undecided == 1 ? " has none: " : " have none: ") + stretches_text(stretches, quantity, units);
}

/// What lies beyond a range without boundaries.
std::string outside_text(const LocatedRay& ray, Units units)
{
    if (!ray.outside) return "";
    const auto& o = *ray.outside;
    const auto quantity = ray.axis.quantity;
    const auto range = range_text(o.low, o.high, quantity, units, low_to_high);
    if (o.nodes > 0 && o.undecided == o.nodes) return " Outside, within " + range + ", no point has a verdict.";
    const auto open = o.undecided == 0 ? std::string()
                                       : without_verdict_text(o.undecided, o.nodes, o.without_verdict, quantity, units);
    // of points without a verdict, and of what lies between those that were looked at, nothing is known
    if (!o.nearest && open.empty()) return " None was found within " + range + " either.";
    if (!o.nearest)
        return " Outside, within " + range + ", none was found at the points that have a verdict; " + open + ".";
    return " The nearest one " + std::string(open.empty() ? "outside" : "found outside") + " lies at " +
           ray.axis.symbol + " = " +
           with_unit(o.nearest->value, quantity, units, ray.kind == BoundaryKind::outcome ? 4 : 8) +
           (open.empty() ? "." : "; of points within " + range + " that were looked at, " + open + ".");
}

/// What the scanned points of a ray without boundaries say.
std::string throughout(const LocatedRay& ray, Units units)
{
    const double judged = 1 - static_cast<double>(ray.undecided) / ray.nodes;
    const bool rests = ray.kind == BoundaryKind::hunting, cycles = ray.kind == BoundaryKind::fold;
    const char* side = ray.stable_share == 0               ? (rests    ? ": hunts "
                                                              : cycles ? ": cycles "
                                                                       : ": unstable ")
                       : ray.stable_share > judged - 1e-12 ? (rests    ? ": does not hunt "
                                                              : cycles ? ": no cycles "
                                                                       : ": stable ")
                                                           : nullptr;
    const auto open = ray.undecided == 0 ? std::string()
                                         : without_verdict_text(ray.undecided, ray.nodes, ray.without_verdict,
                                                                ray.axis.quantity, units);
    if (!side) return open.empty() ? "" : ": at scanned points that have a verdict; " + open;
    if (ray.neutral_share > 0 && ray.stable_share == 0)
        return ": neutral " +
               std::string(ray.neutral_share > judged - 1e-12 ? "throughout" : "or unstable throughout") +
               ". Where sliding is neutral, small disturbances neither decay nor grow, and nothing turns stable";
    return side + (ray.undecided == 0 ? std::string("throughout")
                                      : "at all of the " + std::to_string(ray.nodes - ray.undecided) +
                                            " scanned points that have a verdict; " + open);
}

/// Of a bracket that simulation leaves wide, which is one around values that it does not decide.
std::string open_text(const LocatedRay& ray, const BoundaryPoint& p, Units units)
{
    if (p.converged || p.method != LocationMethod::bisection) return "";
    const std::string text = "; simulation does not decide between " +
                             range_text(p.low, p.high, ray.axis.quantity, units, {"", " and ", ""}, 6);
    return ray.reason == Reason::none ? text : text + ": " + reason_text(ray.reason);
}

}  // namespace

std::string direction_text(int direction, BoundaryKind kind)
{
    // above its boundary a loop may not hunt because it diverges: no word of stability
    if (kind == BoundaryKind::hunting) return direction > 0 ? "hunts above" : direction < 0 ? "hunts below" : "–";
    return direction > 0 ? "unstable above" : direction < 0 ? "stable above" : "–";
}

std::string could_be_missed(const LocatedRay& ray)
{
    std::string text = fmt::format("two boundaries of one kind within 1/{} of the range", ray.nodes - 1);
    if (ray.climbed > 0)
        text += fmt::format(" ({} near {} searched)", ray.climbed, ray.climbed == 1 ? "touch was" : "touches were");
    if (ray.kind == BoundaryKind::fold && ray.narrowest_strip > 0)
        text += fmt::format(
            "; a strip of cycles beside a linear boundary, narrower than 1/{:.0f} of the range; cycles that no start "
            "from near rest leads to",
            1 / ray.narrowest_strip);
    else if (ray.kind == BoundaryKind::fold)
        text += "; cycles that neither a subcritical linear boundary nor a start from near rest leads to";
    if (ray.undecided > 0) text += fmt::format("; {} of {} scanned points have no verdict", ray.undecided, ray.nodes);
    if (ray.outside && ray.outside->undecided > 0)
        text += fmt::format("; {} of {} points outside have no verdict", ray.outside->undecided, ray.outside->nodes);
    if (ray.undecided > 0 && ray.reason != Reason::none)
        text += fmt::format(" ({}{})", ray.undecided > 1 ? "the first: " : "", reason_text(ray.reason));
    return text;
}

std::string could_be_missed(const FollowedBoundary& c)
{
    std::string text = fmt::format("a closed piece smaller than 1/{:.0f} of an axis", 1 / c.guard.cell);
    if (c.guard.climbed > 0)
        text += fmt::format(" that none of {} climbs between the nodes met ({} islands found so)", c.guard.climbed,
                            c.guard.islands);
    if (c.by_sides)
        text +=
            "; a strip of cycles beside a linear boundary, narrower than that; cycles that no start from near rest "
            "leads to";
    else if (c.kind == BoundaryKind::fold)
        text += "; cycles that neither a subcritical linear boundary nor a start from near rest leads to";
    if (c.guard.unexplained > 0)
        text += fmt::format("; {} of {} changes of side on the grid were not followed", c.guard.unexplained,
                            c.guard.changes);
    if (c.guard.undecided > 0)
        text += fmt::format("; {} of {} grid points have no verdict", c.guard.undecided, c.guard.nodes);
    return text;
}

std::string ray_text(const Joint& design, const LocatedRay& ray, const std::vector<IdleAxis>& idle)
{
    // the boundary along the velocity has a name of its own
    std::string kind =
        ray.kind == BoundaryKind::v_min ? "least velocity V_{min}" : std::string(name_of(ray.kind)) + " boundary";
    const Units units = units_of(design);
    const std::string range =
        range_text(ray.axis.values.front(), ray.axis.values.back(), ray.axis.quantity, units, low_to_high);
    if (ray.undecided == ray.nodes)
        return "No verdict along " + ray.axis.symbol + ": the joint cannot be judged at any of the " +
               std::to_string(ray.nodes) + " points of the scan" +
               (ray.reason == Reason::none ? "." : ". At the first point: " + reason_text(ray.reason) + ".");
    const bool at_rest = ray.kind == BoundaryKind::hunting;
    const auto* same = is_linear(ray.kind) || at_rest ? idle_axis(idle, ray.axis.path, at_rest) : nullptr;
    if (same && ray.points.empty())
        return "No " + kind + " can lie along " + ray.axis.symbol + " within " + range + ": " + idle_words(*same) +
               (!is_left_out(*same) ? "."
                : at_rest           ? ". What it does at rest is not judged: simulate it."
                                    : ". What it does to sliding is not judged: simulate it.");
    if (ray.points.empty())
        return "No " + kind + " along " + ray.axis.symbol + " within " + range + throughout(ray, units) + "." +
               outside_text(ray, units);
    kind[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(kind[0])));
    std::string text = kind + " along " + ray.axis.symbol + " at ";
    for (const auto& p : ray.points)
        text += (&p == &ray.points.front() ? "" : ", ") + with_unit(p.value, ray.axis.quantity, units, 8) + " (" +
                direction_text(p.direction, ray.kind) + open_text(ray, p, units) + ")";
    return text + ".";
}

std::string design_words(Region region)
{
    switch (region) {
        case Region::stable:
        case Region::memory_only:
            return "The design is stable: small disturbances of sliding decay.";
        case Region::bistable:
            return "The design is bistable: small disturbances decay, a larger one ends in stick-slip.";
        case Region::velocity_only:
        case Region::unstable:
            return "The design sticks and slips: small disturbances of sliding grow.";
        case Region::neutral:
            return "The design is neutral: small disturbances neither decay nor grow.";
        case Region::undecided:
            break;
    }
    return "The design has no verdict.";
}

Headline::Tone design_tone(Region region)
{
    switch (region) {
        case Region::stable:
        case Region::memory_only:
            return Headline::Tone::good;
        case Region::bistable:
            return Headline::Tone::warning;
        case Region::velocity_only:
        case Region::unstable:
            return Headline::Tone::bad;
        case Region::neutral:
            return Headline::Tone::warning;
        case Region::undecided:
            break;
    }
    return Headline::Tone::neutral;
}

}  // namespace stickslip
