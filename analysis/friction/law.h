// The list of laws: the one place that knows them all.
#pragma once
#include "analysis/friction/kernel.h"
#include "analysis/friction/time_lag.h"

namespace stickslip {

/// Any law, by value. The first alternative is what a default-constructed joint holds until a file names its law.
using FrictionLaw = std::variant<CoulombViscous, Stribeck, RateAndState, KineticStatic, Ageing, RateAndStateRegularised,
                                 Dahl, LuGre, MaxwellSlip, TimeLag, Kernel>;

/// What is known of every law, in the order of the list.
inline std::vector<LawInfo> laws()
{
    return infos<FrictionLaw>();
}

/// The law of that name with its parameters not set; nothing if there is none.
inline std::optional<FrictionLaw> law_named(std::string_view name)
{
    return law_named<FrictionLaw>(name);
}

}  // namespace stickslip
