#include "sweep/files/json/set_point_design_json.h"

#include "sweep/files/json/set_point_json.h"
#include "sweep/files/json/verdict_json.h"
#include "sweep/words/set_point_design_text.h"

namespace stickslip {

nlohmann::ordered_json set_point_design_json(const SetPointDesign& design, double friction_margin)
{
    nlohmann::ordered_json json;
    json["format"] = "stickslip-set-point-design/1";
    json["friction_margin"] = friction_margin;
    json["k_i_limit"] = json_number(design.k_i_limit);
    json["k_i"] = {{"value", json_number(design.k_i_used)}, {"assumed", design.k_i_assumed}};
    json["ways"] = nlohmann::ordered_json::array();
    for (const auto& c : design.choices) {
        nlohmann::ordered_json way{{"way", name_of(c.way)},
                                   {"hunts", c.holds ? nlohmann::ordered_json(false) : nullptr},
                                   {"control.k_i", json_number(c.k_i)},
                                   {"control.dead_zone", json_number(c.dead_zone)},
                                   {"push", json_number(c.push)},
                                   {"push_speed", json_number(c.push_speed)},
                                   {"dither", json_number(c.dither)},
                                   {"dither_frequency", json_number(c.dither_frequency)},
                                   {"window", {json_number(c.low), json_number(c.high)}},
                                   {"rest_error", json_number(c.rest_error)},
                                   {"proofs", nlohmann::ordered_json::array()}};
        bool found = false;
        for (const auto& p : c.proofs) {
            found = found || p.answer.hunting == Hunting::yes;
            way["proofs"].push_back({{"static", json_number(p.breakaway)},
                                     {"kinetic", json_number(p.coulomb)},
                                     {"set_point", set_point_json(p.answer)}});
        }
        if (found) way["hunts"] = true;
        json["ways"].push_back(way);
    }
    json["best"] = design.best < 0
                       ? nlohmann::ordered_json(nullptr)
                       : nlohmann::ordered_json(name_of(design.choices[static_cast<std::size_t>(design.best)].way));
    return json;
}

}  // namespace stickslip
