#include "sweep/files/json/study_json.h"

#include "sweep/words/plain_text.h"
#include "sweep/words/study_text.h"

#include <cmath>

namespace stickslip {
namespace {

Json numbers_json(const std::vector<double>& list)
{
    Json json = Json::array();
    for (const double v : list) json.push_back(json_number(v));
    return json;
}

Json codes_json(const std::vector<StudyReason>& reasons)
{
    Json json = Json::array();
    for (const auto reason : reasons) json.push_back(name_of(reason));
    return json;
}

Json or_null(const std::string& text)
{
    return text.empty() ? Json(nullptr) : Json(text);
}

/// The sentence under this key and its code beside it, both null where there is no reason.
void add_reason(Json& json, const std::optional<StudyReason>& reason)
{
    json["reason"] = reason ? Json(study_text(*reason)) : Json(nullptr);
    json["reason_code"] = reason ? Json(name_of(*reason)) : Json(nullptr);
}

Json velocities_json(const StableVelocities& v, const Interval& searched)
{
    const auto reasons = reasons_of(v, searched);
    return {{"stable", intervals_json(v.intervals)},       {"least", json_number(v.least)},
            {"all_above", json_number(v.all_above)},       {"least_force_rate", json_number(v.least_force_rate)},
            {"reason", or_null(velocities_text(reasons))}, {"reason_codes", codes_json(reasons)}};
}

Json velocity_study_json(const LinearStudy& s)
{
    if (std::isnan(s.velocities.low)) {
        Json json = {{"searched", nullptr},       {"looked_at", nullptr},   {"velocity_only", nullptr},
                     {"state_variable", nullptr}, {"k_v_for_all", nullptr}, {"hardest", nullptr}};
        add_reason(json, range_gain_reason(s));
        return json;
    }
    Json json = {{"searched", {json_number(s.velocities.low), json_number(s.velocities.high)}},
                 {"looked_at", s.velocities_looked_at},
                 {"velocity_only", velocities_json(s.velocity_only, s.velocities)},
                 {"state_variable", velocities_json(s.state_variable, s.velocities)},
                 {"k_v_for_all", s.range_gain ? json_number(s.range_gain->k_v) : Json(nullptr)},
                 {"hardest", s.range_gain ? json_number(s.range_gain->velocity) : Json(nullptr)}};
    json["stable_k_v_for_all"] = s.range_gain ? intervals_json(s.range_gain->stable_k_v) : Json(nullptr);
    add_reason(json, range_gain_reason(s));
    return json;
}

Json comparison_json(const Comparison& c)
{
    const auto sets = [&](const std::vector<Interval>& list) { return c.known ? intervals_json(list) : Json(nullptr); };
    Json json = {{"k_v_demanded",
                  {{"velocity_only", json_number(c.k_v_demanded_velocity_only())},
                   {"state_variable", json_number(c.k_v_demanded_memory())}}},
                 {"stable_k_v", {{"velocity_only", sets(c.k_v_velocity_only)}, {"state_variable", sets(c.k_v_memory)}}},
                 {"stable_k_p", {{"velocity_only", sets(c.k_p_velocity_only)}, {"state_variable", sets(c.k_p_memory)}}},
                 {"forbidden_needlessly_k_p", sets(c.forbidden_needlessly)},
                 {"allowed_wrongly_k_p", sets(c.allowed_wrongly)}};
    add_reason(json, c.known ? std::nullopt : std::optional(StudyReason::gains_not_alone));
    return json;
}

Json reduction_json(const ReductionStudy& r)
{
    Json json{{"name", plain_text(r.name)}, {"assumption", plain_text(r.assumption)}};
    if (!r.compared()) {
        json["refused"] = plain_text(refused_text(r));
        return json;
    }
    json["model"] = plain_text(r.model);
    json["neglected"] = Json::array();
    for (const auto& text : r.neglected) json["neglected"].push_back(plain_text(text));
    json["searched"] = {json_number(r.searched_low), json_number(r.searched_high)};
    json["boundary_of"] = r.boundary_path;
    json["full"] = numbers_json(r.own.full);
    json["reduced"] = numbers_json(r.own.reduced);
    json["error"] = json_number(r.own.error);
    const auto reason = error_reason(r);
    json["error_reason"] = reason ? Json(error_text(r)) : Json(nullptr);
    json["error_reason_code"] = reason ? Json(name_of(*reason)) : Json(nullptr);
    json["assumed_large"] = r.assumption_path.empty() ? Json(nullptr) : Json(r.assumption_path);
    json["within_1_percent_from"] = json_number(r.good_from);
    json["within_10_percent_from"] = json_number(r.fair_from);
    return json;
}

Json locus_json(const std::vector<GainRoots>& locus)
{
    Json json = Json::array();
    for (const auto& at : locus) {
        Json roots = Json::array();
        for (const auto& s : at.roots) roots.push_back({json_number(s.real()), json_number(s.imag())});
        json.push_back({{"k_p", at.k_p}, {"roots", roots}});
    }
    return json;
}

}  // namespace

Json study_json(const LinearStudy& s, const std::vector<GainRoots>& locus)
{
    Json json;
    json["response"] = {{"at_rest", json_number(s.compliance)},
                        {"peak", json_number(s.peak.magnitude)},
                        {"peak_omega", json_number(s.peak.omega)}};
    add_reason(json["response"], response_reason(s));
    const auto unbounded = reasons_of(s.margins);
    json["margins"] = {{"gain_below", json_number(s.margins.gain_below)},
                       {"gain_above", json_number(s.margins.gain_above)},
                       {"phase", json_number(s.margins.phase)},
                       {"crossover", json_number(s.margins.crossover)},
                       {"reason", or_null(margins_reason_text(unbounded, s.comparison.searched_to))},
                       {"reason_codes", codes_json(unbounded)}};
    json["root_locus"] = locus_json(locus);
    json["velocities"] = velocity_study_json(s);
    json["comparison"] = comparison_json(s.comparison);
    json["comparison"]["optimal_mix"] = {{"velocity_noise", json_number(s.velocity_noise)},
                                         {"k_p", json_number(s.mix.k_p)},
                                         {"k_v", json_number(s.mix.k_v)},
                                         {"noise", json_number(s.mix.noise)}};
    add_reason(json["comparison"]["optimal_mix"], mix_reason(s));
    json["force_ramp"] = nullptr;
    if (s.ramp)
        json["force_ramp"] = {{"rate", json_number(s.ramp->rate)},
                              {"stable_k_p",
                               {{"velocity_only", intervals_json(s.ramp->velocity_only)},
                                {"state_variable", intervals_json(s.ramp->state_variable)}}}};
    json["reductions"] = Json::array();
    for (const auto& r : s.reductions) json["reductions"].push_back(reduction_json(r));
    return json;
}

}  // namespace stickslip
