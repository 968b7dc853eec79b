// At least one instance of every law, with parameters of a size that joints have.
#pragma once
#include <string>
#include <vector>

#include "analysis/friction/law.h"

namespace stickslip::samples {

struct Sample {
    std::string name;
    FrictionLaw law;
};

template <class Law>
Law rate_and_state(const NumberList& B = {1.5}, const NumberList& L = {1e-5}, double f0 = 60)
{
    Law law;
    law.f0 = f0;
    law.A = 1;
    law.B = B;
    law.L = L;
    law.V_star = 1e-3;
    return law;
}

inline RateAndStateRegularised regularised(MemoryForm evolution, double f0 = 60)
{
    auto law = rate_and_state<RateAndStateRegularised>({1.5}, {1e-5}, f0);
    law.evolution = evolution;
    return law;
}

/// A stiff, lightly damped bristle: σ0 = 1e5 N/m, σ1 = √1e5, σ2 = 0.4 N·s/m, F_c = 1 N, F_s = 1.5 N, v_s = 1 mm/s.
inline LuGre lugre()
{
    return {1e5, std::sqrt(1e5), 0.4, 1, 1.5, 1e-3};
}

inline MaxwellSlip maxwell_slip(bool generalised)
{
    MaxwellSlip law;
    law.elements.push_back({2e5, 1});
    law.elements.push_back({5e4, 2});
    law.viscous = 3;
    if (generalised) {
        law.attraction = 500;
        law.static_ratio = 1.4;
        law.stribeck_velocity = 2e-3;
    }
    return law;
}

inline TimeLag time_lag(CurveLaw curve, double lag = 5e-3)
{
    TimeLag law;
    law.lag = lag;
    law.curve.law = std::move(curve);
    return law;
}

inline Kernel kernel(bool with_history)
{
    Kernel law;
    law.f0 = 12;
    law.f_v = 900;
    law.V_star = 1e-3;
    law.exponentials.push_back({1.2e5, 100});
    law.exponentials.push_back({-2e4, 700});
    if (with_history) {
        law.impulses.push_back({150, 4e-3});
        KernelTable table;
        table.time = {0, 1e-3, 4e-3};
        table.value = {2e4, 5e4, 0};
        law.samples = std::make_shared<const KernelTable>(table);
        law.table_name = "g.csv";
    }
    return law;
}

inline std::vector<Sample> laws()
{
    return {
        {"coulomb-viscous", CoulombViscous{10, 5}},
        {"kinetic-static", KineticStatic{10, 13}},
        {"stribeck (22)", Stribeck{10, 5, 4, 1e-2, 2}},
        {"stribeck, c4 = 0.7", Stribeck{10, 5, 4, 1e-2, 0.7}},
        {"rate-and-state", rate_and_state<RateAndState>()},
        {"rate-and-state, two states", rate_and_state<RateAndState>({1, 0.84}, {1e-5, 2e-4})},
        {"ageing", rate_and_state<Ageing>()},
        {"ageing, two states", rate_and_state<Ageing>({1, 0.84}, {1e-5, 2e-4})},
        {"regularised, slip", regularised(MemoryForm::slip)},
        {"regularised, ageing", regularised(MemoryForm::ageing)},
        {"regularised, soft", regularised(MemoryForm::ageing, 2)},
        {"dahl", Dahl{10, 1e5, 1}},
        {"dahl, exponent 1.5", Dahl{10, 1e5, 1.5}},
        {"lugre", lugre()},
        {"maxwell-slip", maxwell_slip(false)},
        {"maxwell-slip, generalised", maxwell_slip(true)},
        {"time-lag of stribeck", time_lag(Stribeck{10, 5, 4, 1e-2, 2})},
        {"time-lag of lugre", time_lag(lugre())},
        {"kernel of exponentials", kernel(false)},
        {"kernel with delay and table", kernel(true)},
    };
}

}  // namespace stickslip::samples
