#include "sweep/files/json/nonlinear_json.h"

#include "sweep/files/json/verdict_json.h"
#include "sweep/study/spec.h"
#include "sweep/words/detail_text.h"
#include "sweep/words/reason_text.h"

namespace stickslip {
namespace {

std::string kind_name(DisturbanceKind kind)
{
    for (const auto& k : DisturbanceSpec::kinds)
        if (k.value == kind) return std::string(k.name);
    return "unknown";
}

/// [re, im] each, the largest first.
nlohmann::ordered_json multipliers_json(const std::vector<std::complex<double>>& multipliers)
{
    auto list = nlohmann::ordered_json::array();
    for (const auto& m : multipliers) list.push_back({m.real(), m.imag()});
    return list;
}

nlohmann::ordered_json criticality_json(Criticality criticality)
{
    switch (criticality) {
        case Criticality::supercritical:
            return "supercritical";
        case Criticality::subcritical:
            return "subcritical";
        case Criticality::degenerate:
            return "degenerate";
        case Criticality::none:
            break;
    }
    return nullptr;
}

nlohmann::ordered_json words(const std::string& text)
{
    return text.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(text);
}

/// Null where there is none.
template <class Code>
nlohmann::ordered_json code(Code code)
{
    return code == Code::none ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(name_of(code));
}

}  // namespace

std::string region_name(NonlinearRegion region)
{
    switch (region) {
        case NonlinearRegion::stable:
            return "stable";
        case NonlinearRegion::bistable:
            return "bistable";
        case NonlinearRegion::stick_slip:
            return "stick-slip";
        case NonlinearRegion::undecided:
            break;
    }
    return "undecided";
}

nlohmann::ordered_json nonlinear_json(const NonlinearVerdict& v)
{
    return {{"outcome", code_name("outcome", static_cast<std::uint8_t>(v.outcome))},
            {"region", region_name(v.region)},
            {"noise_suffices", v.noise_suffices},
            {"held_places", v.held_places},
            {"places_alike", v.places_alike},
            {"disturbance", {{"kind", kind_name(v.disturbance.kind)}, {"size", json_number(v.disturbance.size)}}},
            {"growth_rate", json_number(v.growth_rate)},
            {"amplitude", json_number(v.amplitude)},
            {"jitter", json_number(v.jitter)},
            {"velocity_min", json_number(v.velocity_min)},
            {"velocity_max", json_number(v.velocity_max)},
            {"period", json_number(v.period)},
            {"stick_fraction", json_number(v.stick_fraction)},
            {"overshoot", json_number(v.overshoot)},
            {"repeats", v.repeats},
            {"multipliers", multipliers_json(v.multipliers)},
            {"criticality", criticality_json(v.criticality)},
            {"lyapunov", json_number(v.lyapunov)},
            {"fold_k_p", json_number(v.fold_k_p)},
            {"path", code_name("path", static_cast<std::uint8_t>(v.path))},
            {"used_fallback", v.used_fallback},
            {"reason", words(reason_text(v))},
            {"reason_code", code_json(v.reason)},
            {"reason_detail", code(v.detail)},
            {"searched_from", words(larger_tried_text(v.searched_from))},
            {"searched_from_code", code(v.searched_from)},
            {"growth_reason", words(detail_text(v.growth_missing))},
            {"growth_reason_code", code(v.growth_missing)},
            {"fold_reason", words(detail_text(v.fold_missing))},
            {"fold_reason_code", code(v.fold_missing)}};
}

}  // namespace stickslip
