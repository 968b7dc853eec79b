#include "sweep/files/json/boundary_json.h"

#include "analysis/joint/parameters.h"
#include "sweep/files/json/set_point_json.h"
#include "sweep/files/json/verdict_json.h"
#include "sweep/words/boundary_text.h"
#include "sweep/words/plain_text.h"

#include <fmt/format.h>

#include <cmath>

namespace stickslip {
namespace {

using Json = nlohmann::ordered_json;

Json axis_json(const Axis& axis, Units units)
{
    return {{"path", axis.path},
            {"unit", unit_of(axis.quantity, units)},
            {"from", axis.values.front()},
            {"to", axis.values.back()},
            {"scale", axis.log ? "log" : "linear"}};
}

Json point_json(const BoundaryPoint& p)
{
    return {{"value", p.value},
            {"low", p.low},
            {"high", p.high},
            {"precision", p.precision()},
            {"direction", p.direction},
            {"status", p.converged ? "located" : "coarse"},
            {"method", name_of(p.method)},
            {"evaluations", p.evaluations}};
}

Json stretches_json(const std::vector<ScanStretch>& stretches)
{
    Json json = Json::array();
    for (const auto& s : stretches) json.push_back({s.low, s.high});
    return json;
}

Json ray_json(const Joint& design, const LocatedRay& ray, const std::vector<IdleAxis>& idle)
{
    Json json = {{"kind", name_of(ray.kind)}, {"axis", axis_json(ray.axis, units_of(design))}};
    json["points"] = Json::array();
    for (const auto& p : ray.points) json["points"].push_back(point_json(p));
    json["evaluations"] = ray.evaluations;
    json["scanned"] = {{"points", ray.nodes},
                       {"undecided", ray.undecided},
                       {"without_verdict", stretches_json(ray.without_verdict)},
                       {"stable_share", ray.stable_share},
                       {"neutral_share", ray.neutral_share}};
    if (ray.outside) {
        const auto& nearest = ray.outside->nearest;
        json["outside"] = {{"from", ray.outside->low},
                           {"to", ray.outside->high},
                           {"points", ray.outside->nodes},
                           {"undecided", ray.outside->undecided},
                           {"without_verdict", stretches_json(ray.outside->without_verdict)},
                           {"nearest", nearest ? point_json(*nearest) : Json(nullptr)}};
    }
    json["could_be_missed"] = could_be_missed(ray);
    json["reason_code"] = code_json(ray.reason);
    json["answer"] = plain_text(ray_text(design, ray, idle));
    return json;
}

Json curve_json(const Joint& design, const FollowedBoundary& c)
{
    const Units units = units_of(design);
    Json json = {{"kind", name_of(c.kind)}, {"x", axis_json(c.x, units)}, {"y", axis_json(c.y, units)}};
    json["pieces"] = Json::array();
    for (const auto& piece : c.pieces) {
        Json points = Json::array();
        for (const auto& p : piece.points) {
            Json point = {{"x", p.x}, {"y", p.y}, {"along", p.along_y ? "y" : "x"}};
            point.update(point_json(p.at));
            points.push_back(std::move(point));
        }
        json["pieces"].push_back(
            {{"first_end", name_of(piece.first)}, {"last_end", name_of(piece.last)}, {"points", std::move(points)}});
    }
    json["guard"] = {{"points", c.guard.nodes},    {"undecided", c.guard.undecided},
                     {"changes", c.guard.changes}, {"unexplained", c.guard.unexplained},
                     {"climbed", c.guard.climbed}, {"islands", c.guard.islands},
                     {"cell", c.guard.cell}};
    json["evaluations"] = c.evaluations;
    json["precision"] = c.precision();
    json["could_be_missed"] = could_be_missed(c);
    return json;
}

Json meeting_json(const Meeting& m, Units units)
{
    Json json = {{"kind", name_of(m.kind)}, {"path", m.axis.path}, {"unit", unit_of(m.axis.quantity, units)},
                 {"from", m.own},           {"at", m.at},          {"on_chart", m.on_chart}};
    json["beyond"] = m.beyond ? set_point_json(*m.beyond) : Json(nullptr);
    return json;
}

std::string csv_tail(const BoundaryPoint& p)
{
    return fmt::format("{},{},{},{},{},{},{},{}\n", p.value, p.low, p.high, p.precision(), p.direction,
                       p.converged ? "located" : "coarse", name_of(p.method), p.evaluations);
}

}  // namespace

nlohmann::ordered_json boundary_json(const BoundaryAnswer& answer)
{
    Json json = {{"format", "stickslip-boundary/1"}, {"title", answer.title}, {"command", answer.command}};
    Joint joint = answer.design;
    json["joint"] = Json::object();
    for (const auto& leaf : parameters(joint))
        if (std::isfinite(*leaf.value)) json["joint"][leaf.path] = *leaf.value;
    json["region"] = code_name("region", static_cast<std::uint8_t>(answer.region));
    json["loop"] = loop_json(answer.loop, answer.left_out);
    json["idle"] = idle_json(answer.idle);
    if (answer.set_point) json["set_point"] = set_point_json(*answer.set_point);
    json["lines"] = Json::array();
    for (const auto& ray : answer.rays) json["lines"].push_back(ray_json(answer.design, ray, answer.idle));
    json["curves"] = Json::array();
    for (const auto& c : answer.curves) json["curves"].push_back(curve_json(answer.design, c));
    json["meetings"] = Json::array();
    for (const auto& m : answer.meetings) json["meetings"].push_back(meeting_json(m, units_of(answer.design)));
    return json;
}

std::string boundary_csv(const BoundaryAnswer& answer)
{
    std::string text =
        "kind,x_path,y_path,piece,x,y,along,value,low,high,precision,direction,status,method,evaluations\n";
    for (const auto& ray : answer.rays)
        for (const auto& p : ray.points)
            text += fmt::format("{},{},,0,{},,x,", name_of(ray.kind), ray.axis.path, p.value) + csv_tail(p);
    for (const auto& c : answer.curves)
        for (std::size_t i = 0; i < c.pieces.size(); ++i)
            for (const auto& p : c.pieces[i].points)
                text += fmt::format("{},{},{},{},{},{},{},", name_of(c.kind), c.x.path, c.y.path, i, p.x, p.y,
                                    p.along_y ? "y" : "x") +
                        csv_tail(p.at);
    return text;
}

}  // namespace stickslip
