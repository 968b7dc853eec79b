#include "sweep/files/json/nearest_json.h"

#include "sweep/files/json/verdict_json.h"

#include <nlohmann/json.hpp>

namespace stickslip {

nlohmann::ordered_json nearest_json(const NearestBoundary& n)
{
    nlohmann::ordered_json json = {{"decided", n.decided}, {"stable", n.stable}, {"found", n.found}};
    json["distance"] = json_number(n.distance);
    json["moves"] = nlohmann::ordered_json::array();
    for (const auto& m : n.moves)
        json["moves"].push_back({{"path", m.less.empty() ? m.path : m.path + " - " + m.less},
                                 {"from", m.from},
                                 {"to", m.to},
                                 {"change", m.to / m.from - 1}});
    json["evaluations"] = n.evaluations;
    return json;
}

}  // namespace stickslip
