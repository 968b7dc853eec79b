#include "sweep/files/json/load_json.h"

#include "sweep/files/json/verdict_json.h"

namespace stickslip {

nlohmann::ordered_json load_json(const LoadStudy& study)
{
    nlohmann::ordered_json json = {
        {"low", study.low},
        {"high", study.high},
        {"stable_share",
         {{"velocity_only", study.stable_velocity_only}, {"state_variable", study.stable_state_variable}}},
        {"hardest", json_number(study.hardest_load)},
        {"k_cr", json_number(study.hardest_k_cr)}};
    auto& levels = json["levels"] = nlohmann::ordered_json::array();
    for (const auto& v : study.at)
        levels.push_back({{"load", v.load},
                          {"velocity_only",
                           {{"spectral_abscissa", json_number(v.velocity_only)}, {"k_v_min", json_number(v.k_v_min)}}},
                          {"state_variable",
                           {{"spectral_abscissa", json_number(v.state_variable)}, {"k_cr", json_number(v.k_cr)}}}});
    return json;
}

}  // namespace stickslip
