// One law out of a list of laws (a std::variant): the calls of the concept, for whichever law it holds.
#pragma once
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/friction/response.h"

namespace stickslip {

/// What is known of every law of a list, in its order.
template <class Laws>
std::vector<LawInfo> infos()
{
    return []<std::size_t... i>(std::index_sequence<i...>)
    {
        return std::vector<LawInfo>{std::variant_alternative_t<i, Laws>::info...};
    }
    (std::make_index_sequence<std::variant_size_v<Laws>>{});
}

/// The law of that name with its parameters not set; nothing if the list has none.
template <class Laws>
std::optional<Laws> law_named(std::string_view name)
{
    std::optional<Laws> found;
    const auto take = [&]<std::size_t i>() {
        if (name == std::variant_alternative_t<i, Laws>::info.name) found.emplace(std::in_place_index<i>);
    };
    [&]<std::size_t... i>(std::index_sequence<i...>)
    {
        (take.template operator()<i>(), ...);
    }
    (std::make_index_sequence<std::variant_size_v<Laws>>{});
    return found;
}

template <class... Laws>
const LawInfo& info(const std::variant<Laws...>& law)
{
    return std::visit([](const auto& l) -> const LawInfo& { return l.info; }, law);
}
template <class... Laws>
int states(const std::variant<Laws...>& law)
{
    return std::visit([](const auto& l) { return l.states(); }, law);
}
/// f_ss(V), the friction of steady sliding.
template <class... Laws>
double steady_force(const std::variant<Laws...>& law, double V)
{
    return std::visit([V](const auto& l) { return l.steady_force(V); }, law);
}
template <class... Laws>
States steady_state(const std::variant<Laws...>& law, double V)
{
    return std::visit([V](const auto& l) { return l.steady_state(V); }, law);
}
template <class... Laws>
FrictionResponse respond(const std::variant<Laws...>& law, double V, const States& theta)
{
    return std::visit([&](const auto& l) { return l.respond(V, theta); }, law);
}
/// The largest force at V = 0 of a law that is set-valued at rest; 0 for any other.
template <class... Laws>
double static_force(const std::variant<Laws...>& law)
{
    return std::visit(
        [](const auto& l) {
            if constexpr (requires { l.static_force(); }) return l.static_force();
            return 0.0;
        },
        law);
}

/// f_ss'(V) of a law whose memory is its states: ∂f/∂V − Σ ∂f/∂θ_i ∂θ̇_i/∂V / (∂θ̇_i/∂θ_i) in steady sliding     (15)
template <class... Laws>
double steady_slope(const std::variant<Laws...>& law, double V)
{
    const auto r = respond(law, V, steady_state(law, V));
    double slope = r.by_velocity;
    for (int i = 0; i < states(law); ++i)
        if (r.rate_by_velocity[i] != 0) slope -= r.by_state[i] * r.rate_by_velocity[i] / r.rate_by_state[i];
    return slope;
}

}  // namespace stickslip
