#include "sweep/files/json/design_json.h"

#include "sweep/files/json/nearest_json.h"
#include "sweep/files/json/verdict_json.h"
#include "sweep/words/design_text.h"
#include "sweep/words/plain_text.h"

namespace stickslip {
namespace {

nlohmann::ordered_json choice_json(const GainChoice& c)
{
    return {{"k_p", json_number(c.k_p)},
            {"k_v", json_number(c.k_v)},
            {"motion_noise", json_number(c.motion_noise)},
            {"effort_noise", json_number(c.effort_noise)},
            {"peak_effort", json_number(c.peak_effort)},
            {"steady_deflection", json_number(c.steady_deflection)},
            {"margin", json_number(c.margin)},
            {"least_velocity", json_number(c.least_velocity)},
            {"cost", json_number(c.cost)}};
}

}  // namespace

nlohmann::ordered_json design_json(const DesignAnswer& a)
{
    const auto& d = a.design;
    nlohmann::ordered_json json = {{"format", "stickslip-design/1"}, {"title", a.title}, {"feasible", d.feasible}};
    json["answer"] = plain_text(design_text(a));
    json["loop"] = loop_json(a.loop, a.left_out);
    json["objective"] = a.requirements.objective == DesignObjective::motion ? "motion" : "effort";
    json["best"] = choice_json(d.best);
    json["nearest_boundary"] = nearest_json(a.nearest);
    json["demands"] = nlohmann::ordered_json::array();
    for (const auto& r : d.requirements)
        json["demands"].push_back({{"name", r.name},
                                   {"demanded", json_number(r.specified)},
                                   {"reached", json_number(r.achieved)},
                                   {"attainable", json_number(r.attainable)},
                                   {"others_met", r.others_met},
                                   {"met", r.met}});
    json["front"] = nlohmann::ordered_json::array();
    for (const auto& c : d.front) json["front"].push_back(choice_json(c));
    json["velocity_only"] = choice_json(d.velocity_only);
    json["velocity_only"]["found"] = d.velocity_only_found;
    json["as_joint"] = choice_json(d.as_joint);
    json["evaluations"] = d.evaluations;
    return json;
}

}  // namespace stickslip
