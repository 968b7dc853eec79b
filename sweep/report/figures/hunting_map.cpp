#include "sweep/report/figures/hunting_map.h"

#include "analysis/results/text.h"
#include "sweep/report/figures/map_figures.h"
#include "sweep/report/figures/meeting_headlines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace stickslip {
namespace {

/// In the order of a field map's textures: those of smooth sliding, stick-slip and undecided places among them.
enum Kind : std::uint8_t { rests, hunts, unused_texture, diverges, hunts_from_afar, not_decided, kinds };

Kind kind_of(const SetPoint& s)
{
    if (s.hunting == Hunting::undecided) return not_decided;
    if (s.diverges()) return diverges;
    if (s.hunting == Hunting::yes) return s.rests_nearby ? hunts_from_afar : hunts;
    return rests;
}

FieldMap map_over(const HuntingField& field, const std::vector<FollowedBoundary>& curves, Units units)
{
    FieldMap map;
    map.units = units;
    map.x = field.x, map.y = field.y;
    for (const auto& c : curves) {
        if (c.pieces.empty()) continue;
        const Curve drawn = curve_with_brackets(c);
        map.lines.push_back({"boundary of hunting, located", drawn.x, drawn.y, false, drawn.kind});
    }
    map.has_design = true;
    map.design = field.design;
    return map;
}

std::string over_text(const HuntingField& field)
{
    return " over (" + field.x.symbol + ", " + field.y.symbol + ")";
}

Figure kinds_figure(const HuntingField& field, FieldMap map)
{
    map.title = "At a set point" + over_text(field);
    map.classes = {
        "comes to rest", "hunts", "", "diverges: the loop itself is unstable", "hunts from afar, rests from nearby",
        "not decided"};
    for (const auto& place : field.places) map.values.push_back(kind_of(place));
    map.statement = hunting_shares_text(field);
    Figure figure;
    figure.id = chart_id("hunting", field.x, field.y);
    figure.finding = map.statement;
    figure.caption =
        map.statement +
        " Hunting: stick, creep of the integrator, slip, again and again about the set "
        "point. The line is located; points between the nodes of the grid have the colour of the nearest node.";
    figure.picture = std::move(map);
    return figure;
}

Figure amplitude_figure(const HuntingField& field, FieldMap map)
{
    map.title = "Distance of the stops from the set point" + over_text(field);
    map.name = "distance of the stops";
    map.quantity = Quantity::position;
    map.none = "does not hunt";
    double low = infinity, high = 0;
    for (const auto& place : field.places) {
        const double a = place.hunting == Hunting::yes ? place.amplitude : missing;
        map.values.push_back(a);
        if (a > 0) low = std::min(low, a), high = std::max(high, a);
    }
    constexpr double decades_worth = 30;  // beyond this ratio equal steps of colour hide the small values
    map.scale = high > decades_worth * low ? FieldMap::Scale::log : FieldMap::Scale::linear;
    const std::string range = span_text(low, high, Quantity::position, map.units, from_to);
    Figure figure;
    figure.id = chart_id("hunting-amplitude", field.x, field.y);
    figure.finding = "Where the joint hunts, its stops are " + range + " from the set point.";
    figure.caption = figure.finding + " A jump goes from one side to the other: twice as far.";
    figure.picture = std::move(map);
    return figure;
}

}  // namespace

std::string hunting_shares_text(const HuntingField& field)
{
    std::array<double, kinds> share{};
    const auto shares = area_shares(field.x, field.y);
    for (std::size_t i = 0; i < field.places.size(); ++i) share[kind_of(field.places[i])] += shares[i];
    const std::pair<double, const char*> parts[] = {{share[hunts] + share[hunts_from_afar], "hunts"},
                                                    {share[rests], "comes to rest"},
                                                    {share[diverges], "diverges"},
                                                    {share[not_decided], "is not decided"}};
    std::string text;
    for (const auto& [part, what] : parts)
        if (part > 0) text += (text.empty() ? std::string("it ") : ", ") + what + " on " + percent(part);
    const bool nowhere = share[rests] + share[hunts_from_afar] + share[not_decided] == 0;
    if (nowhere) return "The joint comes to rest nowhere on this chart: " + text + ".";
    return "On this chart " + text + ".";
}

std::vector<Figure> hunting_figures(const HuntingField& field, const std::vector<FollowedBoundary>& curves, Units units)
{
    const auto map = map_over(field, curves, units);
    std::vector<Figure> figures{kinds_figure(field, map)};
    if (std::any_of(field.places.begin(), field.places.end(),
                    [](const SetPoint& s) { return s.hunting == Hunting::yes && s.amplitude > 0; }))
        figures.push_back(amplitude_figure(field, map));
    return figures;
}

}  // namespace stickslip
