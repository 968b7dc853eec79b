#include "sweep/files/verdict_json.h"

#include "sweep/report/verdict_text.h"

#include <cmath>

namespace stickslip {
namespace {

Json state_variable_json(const StateVariableVerdict& v)
{
    Json eigenvalues = Json::array(), crossings = Json::array(), intervals = Json::array(), doubtful = Json::array();
    for (const auto& s : v.eigenvalues) eigenvalues.push_back({json_number(s.real()), json_number(s.imag())});
    for (const auto& c : v.crossings)
        crossings.push_back({{"k_p", json_number(c.k_p)}, {"omega", json_number(c.omega)}, {"direction", c.direction}});
    for (const auto& i : v.stable_intervals) intervals.push_back({json_number(i.low), json_number(i.high)});
    for (const auto& i : v.doubtful) doubtful.push_back({json_number(i.low), json_number(i.high)});
    return {{"stable", v.stable},
            {"spectral_abscissa", json_number(v.spectral_abscissa)},
            {"eigenvalues", eigenvalues},
            {"f_v", json_number(v.f_v)},
            {"kernel_integral", json_number(v.kernel_integral)},
            {"crossings", crossings},
            {"stable_intervals", intervals},
            {"k_cr", json_number(v.k_cr)},
            {"searched_to", json_number(v.searched_to)},
            {"doubtful_omega", doubtful}};
}

}  // namespace

Json json_number(double value)
{
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json verdict_json(const LinearVerdict& verdict)
{
    const auto& steady = verdict.steady;
    Json json = {{"steady",
                  {{"velocity", json_number(steady.velocity)},
                   {"friction", json_number(steady.friction)},
                   {"deflection", json_number(steady.deflection)}}}};
    if (steady.reason != Reason::none) {
        json["linear"] = nullptr;
        json["reason"] = reason_text(steady.reason);
        return json;
    }
    const auto& v = verdict.velocity_only;
    json["linear"] = {
        {"velocity_only", {{"stable", v.stable}, {"k_v_min", json_number(v.k_v_min)}, {"slope", json_number(v.slope)}}},
        {"state_variable", state_variable_json(verdict.state_variable)}};
    return json;
}

}  // namespace stickslip
