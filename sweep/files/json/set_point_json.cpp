#include "sweep/files/json/set_point_json.h"

#include "sweep/files/json/verdict_json.h"
#include "sweep/words/set_point_text.h"

namespace stickslip {

nlohmann::ordered_json set_point_json(const SetPoint& s)
{
    nlohmann::ordered_json json;
    json["hunting"] = s.hunting == Hunting::undecided ? nlohmann::ordered_json(nullptr)
                                                      : nlohmann::ordered_json(s.hunting == Hunting::yes);
    json["amplitude"] = json_number(s.amplitude);
    json["slip_time"] = json_number(s.slip_time);
    json["stick_time"] = json_number(s.stick_time);
    json["period"] = json_number(s.period);
    json["multiplier"] = json_number(s.multiplier);
    json["rest_error"] = json_number(s.rest_error);
    json["static_friction"] = json_number(s.own_level);
    json["compensation"] = json_number(s.compensation);
    json["searched"] = {{"starts", s.starts},
                        {"from", json_number(s.searched_from)},
                        {"to", json_number(s.searched_to)},
                        {"largest_ratio", json_number(s.largest_ratio)}};
    json["rests_nearby"] = s.rests_nearby;
    json["by_start"] = nlohmann::ordered_json::array();
    for (const auto& range : s.by_start)
        json["by_start"].push_back(
            {{"from", json_number(range.from)}, {"to", json_number(range.to)}, {"end", name_of(range.end)}});
    json["asymmetric"] = s.asymmetric;
    json["method"] = name_of(s.method);
    json["reason"] = set_point_reason(s.reason);
    json["reason_code"] = name_of(s.reason);
    json["not_used"] = s.not_used;
    return json;
}

}  // namespace stickslip
