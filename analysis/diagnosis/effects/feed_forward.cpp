#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {

Effect feed_forward()
{
    Effect e;
    e.name = "feed-forward";
    e.stage = Stage::controller;
    e.in_command = true;
    e.form = "coulomb tanh(r'/speed) + acceleration r'', and the share of r' in the velocity error";
    e.source = "Franklin, Powell and Workman 1998; Armstrong-Helouvry, Dupont and Canudas de Wit 1994";
    e.confusable = {"coulomb-level", "inertia"};
    const auto form = [&](std::string_view name, std::string_view help, void (*apply)(Joint&, const double*),
                          bool (*applies)(const Joint&)) {
        EffectForm f;
        f.name = name;
        f.parameters = {factor_on_number(0.1, 10, 0.3, help, name)};
        f.apply = apply;
        f.seeds = {{1.1}, {0.9}};
        f.applies = applies;
        e.forms.push_back(f);
    };
    form(
        "coulomb", "true Coulomb feed-forward per documented",
        [](Joint& j, const double* p) { j.control.feed_forward.coulomb *= p[0]; },
        [](const Joint& j) { return j.control.feed_forward.coulomb != 0; });
    form(
        "acceleration", "true acceleration feed-forward per documented",
        [](Joint& j, const double* p) { j.control.feed_forward.acceleration *= p[0]; },
        [](const Joint& j) { return j.control.feed_forward.acceleration != 0; });
    return e;
}

}  // namespace stickslip::gap
