#include "sweep/files/json/margins_json.h"

#include "sweep/files/json/nearest_json.h"
#include "sweep/files/json/verdict_json.h"
#include "sweep/words/margins_text.h"
#include "sweep/words/plain_text.h"

namespace stickslip {

nlohmann::ordered_json margins_json(const MarginsAnswer& a)
{
    nlohmann::ordered_json json = {{"format", "stickslip-margins/1"}, {"title", a.title}};
    json["answer"] = plain_text(margins_text(a));
    json["reason_code"] = code_json(a.reason);
    json["loop"] = loop_json(a.loop, a.left_out);
    json["idle"] = idle_json(a.idle);
    json["nearest"] = nearest_json(a.nearest);
    json["tolerance_each"] = json_number(a.tolerance_each);
    json["alone"] = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < a.alone.size(); ++i) {
        const auto& c = a.alone_of[i];
        const auto& n = a.alone[i];
        nlohmann::ordered_json row = {{"path", c.less.empty() ? c.path : c.path + " - " + c.less},
                                      {"value", value_of(a.joint, c)},
                                      {"found", n.found}};
        row["boundary"] = n.found ? nlohmann::ordered_json(n.moves[0].to) : nlohmann::ordered_json(nullptr);
        json["alone"].push_back(std::move(row));
    }
    if (a.worst) {
        json["worst_case"] = {{"shape", a.uncertainty.shape == UncertaintyShape::box ? "box" : "ellipsoid"},
                              {"stable", a.worst->instability < 0},
                              {"spectral_abscissa", json_number(a.worst->instability)},
                              {"deviations", a.worst->deviations},
                              {"evaluations", a.worst->evaluations},
                              {"undecided", a.worst->undecided}};
    }
    if (a.robust) {
        auto& points = json["robust_boundary"] = nlohmann::ordered_json::array();
        for (const auto& piece : a.robust->pieces) {
            auto one = nlohmann::ordered_json::array();
            for (const auto& p : piece.points)
                one.push_back({{"x", p.x}, {"y", p.y}, {"low", p.at.low}, {"high", p.at.high}});
            points.push_back(std::move(one));
        }
    }
    return json;
}

}  // namespace stickslip
