#include "sweep/files/json/study_json.h"

#include "analysis/stability/real_response.h"
#include "analysis/stability/steady.h"

#include "sweep/words/verdict_text.h"

#include <fmt/format.h>

#include <cmath>

namespace stickslip {
namespace {

Json intervals_json(const std::vector<Interval>& list)
{
    Json json = Json::array();
    for (const auto& i : list) json.push_back({json_number(i.low), json_number(i.high)});
    return json;
}

Json numbers_json(const std::vector<double>& list)
{
    Json json = Json::array();
    for (const double v : list) json.push_back(json_number(v));
    return json;
}

/// Why a least velocity is missing, or is no more than the end of the search.
Json velocities_reason(const StableVelocities& v, const Interval& searched)
{
    if (v.intervals.empty()) return "no velocity of the searched range is stable with these gains";
    std::string text;
    if (v.least <= searched.low) text = "sliding is stable at the lowest velocity searched, so the least lies below it";
    if (std::isnan(v.all_above))
        text += (text.empty() ? "" : "; ") + std::string("the highest velocity searched is not stable");
    return text.empty() ? Json(nullptr) : Json(text);
}

/// Why margins are missing or without end.
Json margins_reason(const LoopMargins& m, double searched_to)
{
    if (std::isnan(m.gain_below)) return "sliding is not stable with these gains, there is no margin to lose";
    std::string text;
    if (std::isinf(m.gain_above))
        text = "gain_above: no boundary lies above this k_p" +
               (std::isfinite(searched_to) ? fmt::format(" up to {:.4g}, as far as was searched", searched_to)
                                           : std::string());
    if (std::isnan(m.crossover))
        text += (text.empty() ? "" : "; ") + std::string("phase: |L| is 1 nowhere, no lag makes the joint unstable");
    return text.empty() ? Json(nullptr) : Json(text);
}

Json velocities_json(const StableVelocities& v, const Interval& searched)
{
    return {{"stable", intervals_json(v.intervals)},
            {"least", json_number(v.least)},
            {"all_above", json_number(v.all_above)},
            {"least_force_rate", json_number(v.least_force_rate)},
            {"reason", velocities_reason(v, searched)}};
}

Json velocity_study_json(const LinearStudy& s)
{
    if (std::isnan(s.velocities.low))
        return {{"searched", nullptr},
                {"velocity_only", nullptr},
                {"state_variable", nullptr},
                {"k_v_for_all", nullptr},
                {"hardest", nullptr},
                {"reason", "a kernel is friction found at one velocity and says nothing about others"}};
    Json json = {{"searched", {json_number(s.velocities.low), json_number(s.velocities.high)}},
                 {"velocity_only", velocities_json(s.velocity_only, s.velocities)},
                 {"state_variable", velocities_json(s.state_variable, s.velocities)},
                 {"k_v_for_all", s.range_gain ? json_number(s.range_gain->k_v) : Json(nullptr)},
                 {"hardest", s.range_gain ? json_number(s.range_gain->velocity) : Json(nullptr)}};
    json["stable_k_v_for_all"] = s.range_gain ? intervals_json(s.range_gain->stable_k_v) : Json(nullptr);
    json["reason"] = s.range_gain && std::isnan(s.range_gain->k_v)
                         ? Json("no single k_v serves every velocity of the range at this k_p")
                         : Json(nullptr);
    return json;
}

/// Why there is no optimal mix.
Json mix_reason(const LinearStudy& s)
{
    if (!std::isnan(s.mix.noise)) return nullptr;
    if (std::isnan(s.velocity_noise))
        return "control.period is not set: how noisy a velocity differenced from positions is depends on it";
    return "no pair of gains on a boundary of stability was found";
}

Json comparison_json(const Comparison& c)
{
    const auto sets = [&](const std::vector<Interval>& list) { return c.known ? intervals_json(list) : Json(nullptr); };
    return {{"k_v_demanded",
             {{"velocity_only", json_number(c.k_v_demanded_velocity_only())},
              {"state_variable", json_number(c.k_v_demanded_memory())}}},
            {"stable_k_v", {{"velocity_only", sets(c.k_v_velocity_only)}, {"state_variable", sets(c.k_v_memory)}}},
            {"stable_k_p", {{"velocity_only", sets(c.k_p_velocity_only)}, {"state_variable", sets(c.k_p_memory)}}},
            {"forbidden_needlessly_k_p", sets(c.forbidden_needlessly)},
            {"allowed_wrongly_k_p", sets(c.allowed_wrongly)},
            {"reason",
             c.known ? Json(nullptr) : Json("this loop has not both k_p and k_v as gains that can be turned alone")}};
}

/// Why there is no answer to a steady sine.
Json response_reason(const LinearStudy& s)
{
    if (std::isinf(s.peak.magnitude)) return "sliding is neutral: the answer to a sine at peak_omega grows without end";
    if (!std::isnan(s.peak.magnitude)) return nullptr;
    if (std::isnan(s.compliance)) return "the linear theory has no response of this loop with this friction";
    return "sliding is not stable: a steady sine has no steady answer";
}

/// Why there is no error of a reduction; nothing where there is one.
Json error_reason(const ReductionStudy& r)
{
    if (std::isfinite(r.own.error)) return nullptr;
    const auto range = fmt::format("{} from {:.4g} to {:.4g}", r.boundary_path, r.searched_low, r.searched_high);
    if (std::isnan(r.own.error)) return "neither joint has a boundary along " + range + ": nothing to compare";
    return fmt::format("boundaries along {}: {} of the full joint, {} of the reduced one", range, r.own.full.size(),
                       r.own.reduced.size());
}

Json reduction_json(const ReductionStudy& r)
{
    Json json{{"name", plain_text(r.name)}, {"assumption", plain_text(r.assumption)}};
    if (!r.refused.empty()) {
        json["refused"] = plain_text(r.refused);
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
    json["error_reason"] = error_reason(r);
    json["assumed_large"] = r.assumption_path.empty() ? Json(nullptr) : Json(r.assumption_path);
    json["within_1_percent_from"] = json_number(r.good_from);
    json["within_10_percent_from"] = json_number(r.fair_from);
    return json;
}

/// Two decades to either side of the joint's own gain, in twelve steps a decade.
Json locus_json(const Joint& joint)
{
    const bool finite = loop_kind(joint) == LoopKind::sampled ||
                        (joint.dead_time() == 0 && linear_joint(joint, commanded_velocity(joint)).rational());
    const int steps = finite ? 48 : 8;  // where roots have no end, each gain costs a search
    std::vector<double> gains;
    for (int i = 0; i <= steps; ++i) gains.push_back(joint.control.k_p * std::pow(10, 4.0 * i / steps - 2));
    const auto rows = root_locus(joint, gains);
    if (rows.empty()) return Json::array();
    Json json = Json::array();
    for (std::size_t i = 0; i < gains.size(); ++i) {
        Json roots = Json::array();
        for (const auto& s : rows[i]) roots.push_back({json_number(s.real()), json_number(s.imag())});
        json.push_back({{"k_p", gains[i]}, {"roots", roots}});
    }
    return json;
}

}  // namespace

Json study_json(const Joint& joint, const LinearStudy& s)
{
    Json json;
    json["response"] = {{"at_rest", json_number(s.compliance)},
                        {"peak", json_number(s.peak.magnitude)},
                        {"peak_omega", json_number(s.peak.omega)},
                        {"reason", response_reason(s)}};
    json["margins"] = {{"gain_below", json_number(s.margins.gain_below)},
                       {"gain_above", json_number(s.margins.gain_above)},
                       {"phase", json_number(s.margins.phase)},
                       {"crossover", json_number(s.margins.crossover)},
                       {"reason", margins_reason(s.margins, s.comparison.searched_to)}};
    json["root_locus"] = locus_json(joint);
    json["velocities"] = velocity_study_json(s);
    json["comparison"] = comparison_json(s.comparison);
    json["comparison"]["optimal_mix"] = {{"velocity_noise", json_number(s.velocity_noise)},
                                         {"k_p", json_number(s.mix.k_p)},
                                         {"k_v", json_number(s.mix.k_v)},
                                         {"noise", json_number(s.mix.noise)},
                                         {"reason", mix_reason(s)}};
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
