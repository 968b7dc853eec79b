#include "sweep/files/json/verdict_json.h"

#include "sweep/words/loop_text.h"
#include "sweep/words/plain_text.h"
#include "sweep/words/reason_text.h"
#include "sweep/words/study_text.h"

#include <cmath>

namespace stickslip {
namespace {

/// "stable", "neutral", "unstable", of either theory.
template <class Verdict>
const char* verdict_name(const Verdict& v)
{
    return v.stable ? "stable" : v.neutral ? "neutral" : "unstable";
}

/// What bounds a window of stable gains there: a machine word for each kind of crossing.
std::string_view end_name(const StateVariableVerdict& v, double gain, std::string_view otherwise)
{
    if (gain == infinity) return "none";
    for (const auto& c : v.crossings)
        if (c.k_p == gain) return c.omega == 0 ? "at-rest" : "oscillation";
    return otherwise;
}

Json ends_json(const StateVariableVerdict& v)
{
    Json json = Json::array();
    for (const auto& i : v.stable_intervals)
        json.push_back(
            {end_name(v, i.low, v.searched_from > 0 ? "searched-from" : "zero"), end_name(v, i.high, "searched-to")});
    return json;
}

Json state_variable_json(const StateVariableVerdict& v)
{
    Json eigenvalues = Json::array(), multipliers = Json::array(), crossings = Json::array();
    for (const auto& s : v.eigenvalues) eigenvalues.push_back({json_number(s.real()), json_number(s.imag())});
    for (const auto& z : v.multipliers) multipliers.push_back({json_number(z.real()), json_number(z.imag())});
    for (const auto& c : v.crossings)
        crossings.push_back({{"k_p", json_number(c.k_p)}, {"omega", json_number(c.omega)}, {"direction", c.direction}});
    return {{"stable", v.stable},
            {"verdict", verdict_name(v)},
            {"spectral_abscissa", json_number(v.spectral_abscissa)},
            {"eigenvalues", eigenvalues},
            {"eigenvalues_complete", v.all_eigenvalues},
            {"eigenvalues_note", v.all_eigenvalues ? Json(nullptr) : Json(rightmost_roots_text())},
            {"multipliers", v.multipliers.empty() ? Json(nullptr) : multipliers},
            {"gain_margin_db", json_number(v.gain_margin_db)},
            {"phase_margin_deg", json_number(v.phase_margin_deg)},
            {"f_v", json_number(v.f_v)},
            {"kernel_integral", json_number(v.kernel_integral)},
            {"crossings", crossings},
            {"stable_intervals", intervals_json(v.stable_intervals)},
            {"stable_ends", ends_json(v)},
            {"k_cr", json_number(v.k_cr)},
            {"searched_from", json_number(v.searched_from)},
            {"searched_to", json_number(v.searched_to)},
            {"doubtful_omega", intervals_json(v.doubtful)}};
}

/// A code: words call the loops alike, and may change.
std::string_view kind_name(LoopKind kind)
{
    return kind == LoopKind::ideal ? "ideal" : kind == LoopKind::continuous ? "continuous" : "sampled";
}

}  // namespace

Json loop_json(const LoopUse& loop, const std::optional<LeftOut>& left_out)
{
    Json unused = Json::array();
    for (const auto& term : loop.not_used)
        unused.push_back({{"key", term.key},
                          {"why", why_text(term.why)},
                          {"why_code", name_of(term.why)},
                          {"matters", term.matters}});
    Json ideal = nullptr;
    if (left_out)
        ideal = {{"kind", kind_name(left_out->loop.kind)},
                 {"keys", left_out->loop.used},
                 {"spectral_abscissa", json_number(left_out->growth)}};
    Json gear = nullptr;
    if (loop.gear.between())
        gear = {{"ratio", loop.gear.ratio},
                {"counted_at", "joint"},
                {"k_p_per_record", loop.gear.gain},
                {"text", plain_text(side_text(loop.gear, false))}};
    return {
        {"kind", kind_name(loop.kind)}, {"used", loop.used}, {"not_used", unused}, {"gear", gear}, {"left_out", ideal}};
}

Json idle_json(const std::vector<IdleAxis>& idle)
{
    Json json = Json::array();
    for (const auto& axis : idle)
        json.push_back({{"path", axis.path},
                        {"why", axis.why ? Json(why_text(*axis.why)) : Json(nullptr)},
                        {"why_code", axis.why ? Json(name_of(*axis.why)) : Json(nullptr)},
                        {"matters", axis.matters}});
    return json;
}

Json intervals_json(const std::vector<Interval>& list)
{
    Json json = Json::array();
    for (const auto& i : list) json.push_back({json_number(i.low), json_number(i.high)});
    return json;
}

Json json_number(double value)
{
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json code_json(Reason reason)
{
    return reason == Reason::none ? Json(nullptr) : Json(code_name("reason", static_cast<std::uint8_t>(reason)));
}

Json verdict_json(const LinearVerdict& verdict)
{
    const auto& steady = verdict.steady;
    Json json = {{"steady",
                  {{"velocity", json_number(steady.velocity)},
                   {"slides_at", json_number(steady.slides_at)},
                   {"friction", json_number(steady.friction)},
                   {"deflection", json_number(steady.deflection)}}},
                 {"loop", loop_json(verdict.loop)}};
    if (steady.reason != Reason::none) {
        json["linear"] = nullptr;
        json["reason"] = reason_text(steady.reason);
        json["reason_code"] = code_json(steady.reason);
        return json;
    }
    const auto& v = verdict.velocity_only;
    json["linear"] = {{"velocity_only",
                       {{"stable", v.stable},
                        {"verdict", verdict_name(v)},
                        {"k_v_min", json_number(v.k_v_min)},
                        {"stable_k_v", intervals_json(v.stable_k_v)},
                        {"slope", json_number(v.slope)}}},
                      {"state_variable", state_variable_json(verdict.state_variable)}};
    return json;
}

}  // namespace stickslip
