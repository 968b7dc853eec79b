// The list of laws: the one place that knows them all.
#pragma once
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/friction/coulomb_viscous.h"
#include "analysis/friction/rate_and_state.h"
#include "analysis/friction/stribeck.h"

namespace stickslip {

/// Any law, by value. The first alternative is what a default-constructed joint holds until a file names its law.
using FrictionLaw = std::variant<CoulombViscous, Stribeck, RateAndState>;

namespace detail {
template <std::size_t... i>
std::vector<LawInfo> infos(std::index_sequence<i...>)
{
    return {std::variant_alternative_t<i, FrictionLaw>::info...};
}
template <std::size_t... i>
std::optional<FrictionLaw> law_named(std::string_view name, std::index_sequence<i...>)
{
    std::optional<FrictionLaw> found;
    ((name == std::variant_alternative_t<i, FrictionLaw>::info.name ? void(found.emplace(std::in_place_index<i>))
                                                                    : void()),
     ...);
    return found;
}
using LawIndices = std::make_index_sequence<std::variant_size_v<FrictionLaw>>;
}  // namespace detail

/// What is known of every law, in the order of the list.
inline std::vector<LawInfo> laws()
{
    return detail::infos(detail::LawIndices{});
}

/// The law of that name with its parameters not set; nothing if there is none.
inline std::optional<FrictionLaw> law_named(std::string_view name)
{
    return detail::law_named(name, detail::LawIndices{});
}

inline const LawInfo& info(const FrictionLaw& law)
{
    return std::visit([](const auto& l) -> const LawInfo& { return l.info; }, law);
}
inline int states(const FrictionLaw& law)
{
    return std::visit([](const auto& l) { return l.states(); }, law);
}
/// f_ss(V), the friction of steady sliding.
inline double steady_force(const FrictionLaw& law, double V)
{
    return std::visit([V](const auto& l) { return l.steady_force(V); }, law);
}
inline States steady_state(const FrictionLaw& law, double V)
{
    return std::visit([V](const auto& l) { return l.steady_state(V); }, law);
}
inline FrictionResponse respond(const FrictionLaw& law, double V, const States& theta)
{
    return std::visit([&](const auto& l) { return l.respond(V, theta); }, law);
}

}  // namespace stickslip
