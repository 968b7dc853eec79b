#include "sweep/words/cause_text.h"

#include "analysis/joint/parameters.h"
#include "analysis/joint/signs.h"
#include "analysis/results/text.h"
#include "sweep/words/symbols.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace stickslip {
namespace {

/// What an effect is in words, and at the ends of which paths of a joint its numbers stand; where none is named, the
/// fitted numbers are said under their own names.
struct Words {
    std::string_view effect, sentence;
    std::array<std::string_view, 4> paths = {};
};

constexpr Words all_words[] = {
    {"coulomb-level", "Coulomb friction is not the documented one", {".coulomb"}},
    {"viscous", "Viscous friction is not the documented one", {".viscous"}},
    {"stribeck", "Friction falls from standstill to low speed (Stribeck)"},
    {"load-dependent-friction", "Friction grows with the transmitted effort"},
    {"presliding", "Friction yields like a spring before it slides"},
    {"frictional-memory", "Friction depends on past motion"},
    {"position-dependent-friction", "Friction depends on the position"},
    {"friction-drift", "The level of friction drifts with time"},
    {"inertia", "The inertia is not the documented one", {"inertia"}},
    {"constant-load", "The constant load is not the documented one", {"load.constant"}},
    {"gravity", "Gravity is not the documented one", {"load.gravity_amplitude"}},
    {"cogging", "A force locked to the position acts that does not depend on the direction (cogging)"},
    {"backlash", "There is backlash between motor and link"},
    {"compliance", "The transmission between motor and link is compliant"},
    {"effort-gain", "The drive delivers another effort than documented", {"effort_gain", "torque_constant"}},
    {"saturation", "The effort is limited below what is documented", {"control.effort_limit", "actuator.limit"}},
    {"supply-sag", "The supply voltage sags under load"},
    {"actuator-lag", "The actuator follows its command late", {"actuator.lag", "control.delay"}},
    {"delay", "The loop is later than the joint file states", {"control.delay", "sensor.delay", "actuator.lag"}},
    {"velocity-filter", "The velocity filter in the controller is not the documented one", {"velocity_estimate.tau"}},
    {"gain-k_p", "The position gain in the controller is not the documented one", {"control.k_p"}},
    {"gain-k_v", "The velocity gain in the controller is not the documented one", {"control.k_v"}},
    {"gain-k_i",
     "The integral action of the controller is not the documented one",
     {"control.k_i", "control.velocity_integral_gain", "control.velocity_reset_time", "control.integral_limit"}},
    {"feed-forward", "The controller adds a feed-forward that the joint file does not state"},
    {"dead-zone", "The controller ignores position errors within a dead zone"},
    {"quantisation", "The position is read on a coarser grid than documented"},
    {"sensor-offset", "The position reading is offset or scaled"},
    {"periodic-disturbance", "A periodic force acts from outside"},
};

const FittedParameter* fitted(const Cause& cause, std::string_view name)
{
    for (const auto& p : cause.parameters)
        if (p.name == name) return &p;
    return nullptr;
}

/// "friction.motor.asymmetry.viscous" of the body whose friction differs, empty where none does.
std::string asymmetric_body(Joint& joint)
{
    constexpr std::string_view table = "asymmetry.";
    for (const auto& p : parameters(joint))
        if (const auto at = p.path.find(table); at != std::string::npos && *p.value != 0) return p.path.substr(0, at);
    return "";
}

/// "viscous 166.9 ± 1.6 N·s/m in the positive direction and 240.1 N·s/m in the negative one"
std::string both_directions(const char* name, double level, const FittedParameter& half)
{
    constexpr double surely = 2;  // standard errors
    if (std::abs(half.value) < surely * half.standard_error)
        return fmt::format("{} not measurably different ({} half the difference)", name,
                           with_error(half.value, half.standard_error, half.unit));
    return fmt::format("{} {} in the positive direction and {} in the negative one", name,
                       with_error(level + half.value, half.standard_error, half.unit),
                       with_error(level - half.value, half.standard_error, half.unit));
}

std::string directions_text(const Cause& cause, Joint after)
{
    const std::string body = asymmetric_body(after);
    std::string text;
    for (const char* name : {"viscous", "coulomb"}) {
        const auto* half = fitted(cause, std::string("asymmetric-friction.") + name);
        const double* level = find_parameter(after, body + name);
        if (!half || !level || half->value == 0) continue;
        text += (text.empty() ? ": " : "; ") + both_directions(name[0] == 'c' ? "Coulomb" : name, *level, *half);
    }
    return "Friction differs between the directions" + text + ".";
}

std::string gear_text(const Cause& cause)
{
    const auto number = [&](const std::string& name) {
        const auto* p = fitted(cause, "load-dependent-friction." + name);
        return p ? with_error(p->value, p->standard_error, p->unit) : "";
    };
    return "Friction of the gear grows with the effort at the load: " + number("forward") +
           " of it where the drive moves the load, " + number("backward") + " where the load moves the drive, with " +
           number("beyond") + " of the inertia beyond the gear.";
}

/// The numbers of a joint file that end like one of the paths and have moved.
std::string moved_numbers(const Words& words, Joint before, Joint after)
{
    const Units units = units_of(after);
    std::string text;
    for (const auto& p : parameters(after)) {
        const double* was = find_parameter(before, p.path);
        const bool own = std::any_of(words.paths.begin(), words.paths.end(),
                                     [&](auto end) { return !end.empty() && p.path.ends_with(end); });
        if (!own || !was || *was == *p.value) continue;
        text += (text.empty() ? "" : ", ") + with_unit(*p.value, p.quantity, units, 4);
        text += std::isfinite(*was) && *was != 0 ? " instead of " + with_unit(*was, p.quantity, units, 4)
                                                 : " where the joint file has none";
    }
    return text;
}

std::string fitted_numbers(const Cause& cause, const std::string& effect)
{
    std::string text;
    for (const auto& p : cause.parameters) {
        if (!is_of(p, effect)) continue;
        std::string name = p.name.substr(effect.size() + 1);
        if (const Sign* sign = sign_of("friction." + name)) name = sign->name;
        std::replace(name.begin(), name.end(), '_', ' ');
        text += (text.empty() ? "" : ", ") + name + " " + with_error(p.value, p.standard_error, p.unit);
    }
    return text;
}

/// Where the numbers of an effect stand that is fitted as a sine and a cosine.
constexpr std::pair<std::string_view, std::string_view> waves[] = {{"cogging", "load.cogging."},
                                                                   {"gravity", "load.gravity_"},
                                                                   {"periodic-disturbance", "load.disturbance."},
                                                                   {"position-dependent-friction", "ripple."}};

/// "amplitude 4 N, periods 100 1/m": as a joint file states a wave, not as it was fitted.
std::string wave_numbers(const std::string& effect, Joint before, Joint after)
{
    const auto wave =
        std::find_if(std::begin(waves), std::end(waves), [&](const auto& w) { return w.first == effect; });
    if (wave == std::end(waves)) return "";
    std::string text;
    for (const auto& p : parameters(after)) {
        const auto at = p.path.find(wave->second);
        const double* was = find_parameter(before, p.path);
        if (at == std::string::npos || (was && *was == *p.value) || p.quantity == Quantity::angle) continue;
        std::string name = p.path.substr(at + wave->second.size());
        std::ranges::replace(name, '_', ' ');  // of the second harmonic
        text += (text.empty() ? "" : ", ") + name + " " + with_unit(*p.value, p.quantity, units_of(after), 4);
    }
    return text;
}

std::string one_text(const std::string& effect, const Cause& cause, const Joint& before, const Joint& after)
{
    if (effect == "asymmetric-friction") return directions_text(cause, after);
    if (fitted(cause, effect + ".backward")) return gear_text(cause);
    const auto* words =
        std::find_if(std::begin(all_words), std::end(all_words), [&](const Words& w) { return w.effect == effect; });
    std::string text(words == std::end(all_words) ? std::string_view(effect) : words->sentence);
    std::string numbers = words == std::end(all_words) ? "" : moved_numbers(*words, before, after);
    if (effect == "constant-load" && before.load.constant == 0)
        text = "A constant load acts that the joint file does not state";
    if (effect == "gravity" && before.load.gravity_amplitude == 0)
        text = "A weight acts that the joint file does not state", numbers.clear();
    if (fitted(cause, effect + ".sine")) numbers = wave_numbers(effect, before, after);
    if (numbers.empty()) numbers = fitted_numbers(cause, effect);
    return text + (numbers.empty() ? "." : ": " + numbers + ".");
}

}  // namespace

std::string with_error(double value, double standard_error, const std::string& unit)
{
    const bool stated = std::isfinite(standard_error) && standard_error > 0;
    const ScaledUnit scaled = scaled_unit(stated ? std::max(std::abs(value), standard_error) : std::abs(value), unit);
    const std::string shown = unit == "1" || unit.empty() ? "" : " " + scaled.text;
    const double v = value / scaled.size, e = standard_error / scaled.size;
    if (!stated) return plain_number(v, 4) + shown;
    const int places = 1 - static_cast<int>(std::floor(std::log10(e)));  // of two digits of the error
    constexpr int most_places = 5;
    if (places >= 0 && places <= most_places) {
        const bool below = v < 0 && std::abs(v) >= 0.5 * std::pow(10, -places);
        return fmt::format("{}{:.{}f} ± {:.{}f}", below ? "−" : "", std::abs(v), places, e, places) + shown;
    }
    constexpr int least = 1, most = 6;
    const int digits =
        v == 0 ? least
               : std::clamp(static_cast<int>(std::floor(std::log10(std::abs(v))) - std::floor(std::log10(e))) + 2,
                            least, most);
    return plain_number(v, digits) + " ± " + plain_number(e, 2) + shown;
}

std::string cause_text(const Cause& cause, const Joint& before, const Joint& after)
{
    std::string text;
    for (const auto& name : cause.names) text += (text.empty() ? "" : " ") + one_text(name, cause, before, after);
    return text;
}

}  // namespace stickslip
