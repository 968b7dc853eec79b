#include "analysis/results/point.h"

namespace stickslip {
namespace {

template <auto member>
std::uint8_t code_of(const PointResult& p)
{
    return static_cast<std::uint8_t>(p.*member);
}

template <auto member>
void set_code_of(PointResult& p, std::uint8_t code)
{
    p.*member = static_cast<std::decay_t<decltype(p.*member)>>(code);
}

template <auto member>
constexpr Column coded(std::string_view name, std::string_view long_name, std::string_view meanings,
                       bool nonlinear = false)
{
    return {name, long_name, Quantity::number, nullptr, &code_of<member>, &set_code_of<member>, meanings, nonlinear};
}

constexpr Column numbered(std::string_view name, std::string_view long_name, Quantity q, double PointResult::*m,
                          bool nonlinear = false)
{
    return {name, long_name, q, m, nullptr, nullptr, {}, nonlinear};
}

constexpr Column table[] = {
    numbered("k_v_min", "least velocity gain of the velocity-only theory", Quantity::velocity_gain,
             &PointResult::k_v_min),
    numbered("spectral_abscissa", "largest real part of the spectrum, memory included", Quantity::rate,
             &PointResult::spectral_abscissa),
    numbered("k_cr", "critical position gain", Quantity::position_gain, &PointResult::k_cr),
    numbered("omega", "frequency at the critical position gain", Quantity::angular_frequency, &PointResult::omega),
    coded<&PointResult::region>("region", "verdicts of both theories",
                                "stable memory_only velocity_only unstable bistable undecided neutral"),
    coded<&PointResult::velocity_only_stable>("velocity_only_stable", "stable in the velocity-only model",
                                              "unstable stable undecided neutral"),
    coded<&PointResult::state_variable_stable>("state_variable_stable", "stable by friction with memory",
                                               "unstable stable undecided neutral"),
    coded<&PointResult::reason>(
        "reason", "why a value is missing",
        "none no_velocity law_needs_motion no_steady_state not_finite linear_only not_converged "
        "solver_failed unsupported neutral diverges limit_too_low impossible"),
    coded<&PointResult::outcome>(
        "outcome", "what the nonlinear joint does after the stated disturbance",
        "not_asked stable-sliding stick-slip limit-cycle reversal period-n irregular undecided "
        "linear-only solver-failure held",
        true),
    coded<&PointResult::path>("path", "method that decided the outcome",
                              "none lanes cvode shooting method-of-steps ticks interpolation", true),
    numbered("growth_rate", "growth rate of the small disturbance", Quantity::rate, &PointResult::growth_rate, true),
    numbered("amplitude", "limit-cycle amplitude in position, half peak to peak", Quantity::position,
             &PointResult::amplitude, true),
    numbered("velocity_min", "least velocity of the limit cycle", Quantity::velocity, &PointResult::velocity_min, true),
    numbered("velocity_max", "peak velocity of the limit cycle", Quantity::velocity, &PointResult::velocity_max, true),
    numbered("period", "period of the limit cycle", Quantity::time, &PointResult::period, true),
    numbered("stick_fraction", "share of the period spent sticking, or moving backwards", Quantity::number,
             &PointResult::stick_fraction, true),
    numbered("overshoot", "largest excess of position over the steady path, per steady deflection", Quantity::number,
             &PointResult::overshoot, true),
    numbered("interpolation_error", "largest error of an interpolated row's cell at its checks, 0 where computed",
             Quantity::number, &PointResult::interpolation_error, true),
};

}  // namespace

std::span<const Column> columns()
{
    return table;
}

std::string_view code_name(std::string_view column, std::uint8_t code)
{
    for (const auto& c : table) {
        if (c.name != column) continue;
        std::string_view words = c.meanings;
        for (; code > 0; --code) {
            const auto space = words.find(' ');
            if (space == std::string_view::npos) return "unknown";
            words.remove_prefix(space + 1);
        }
        return words.substr(0, words.find(' '));
    }
    return "unknown";
}

}  // namespace stickslip
