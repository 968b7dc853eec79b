#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {
namespace {

bool integrates(const Joint& j)
{
    const auto& c = j.control;
    return c.k_i != 0 || is_set(c.velocity_integral_gain) || is_set(c.velocity_reset_time);
}

}  // namespace

Effect gain_k_i()
{
    Effect e;
    e.name = "gain-k_i";
    e.stage = Stage::controller;
    e.in_command = true;
    e.form = "(1 + epsilon) k_i, in a cascade K_i or 1/T_n; k_i that the document lacks; another limit of the integral";
    e.source = "Franklin, Powell and Workman 1998; Armstrong-Helouvry and Amin 1996";
    e.confusable = {"constant-load", "gain-k_p"};
    {
        EffectForm f;
        f.parameters = {
            factor_on_number(0.1, 10, 0.2, "true gain per nominal"),
        };
        f.apply = [](Joint& j, const double* p) {
            auto& c = j.control;
            c.k_i *= p[0];
            if (is_set(c.velocity_integral_gain)) c.velocity_integral_gain *= p[0];
            if (is_set(c.velocity_reset_time)) c.velocity_reset_time /= p[0];
        };
        f.seeds = {{1.1}, {0.9}};
        f.applies = integrates;
        e.forms.push_back(f);
    }
    {
        EffectForm f;
        f.name = "limit";
        f.parameters = {
            {"integral_limit", Quantity::command, Scale::peak_effort, true, 0.02, 2, 0.7,
             "limit of the integral's share"},
        };
        f.apply = [](Joint& j, const double* p) { j.control.integral_limit = p[0]; };
        f.seeds = {{0.7}, {0.4}, {0.2}, {0.1}};
        f.applies = integrates;
        f.rough = true;
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
