#include "analysis/diagnosis/effects/catalogue.h"
#include "analysis/loop/felt.h"

namespace stickslip::gap {
namespace {

const EffectParameter acceleration{"acceleration",
                                   Quantity::inertia,
                                   Scale::inertia,
                                   false,
                                   -3,
                                   3,
                                   0.3,
                                   "effort that is added per acceleration of the reference"};
const EffectParameter coulomb{"coulomb",
                              Quantity::effort,
                              Scale::effort,
                              false,
                              -3,
                              3,
                              0.3,
                              "effort that is added along the velocity of the reference"};
const EffectParameter coulomb_speed{"coulomb_speed",
                                    Quantity::velocity,
                                    Scale::velocity,
                                    true,
                                    1e-3,
                                    1,
                                    0.05,
                                    "velocity of the reference at which three quarters of it are there"};

bool lacks_acceleration(const Joint& j)
{
    return j.control.feed_forward.acceleration == 0;
}

bool lacks_coulomb(const Joint& j)
{
    return j.control.feed_forward.coulomb == 0;
}

void add_coulomb(Joint& j, const double* p)
{
    j.control.feed_forward.coulomb = p[0] / effort_per_command(j);
    j.control.feed_forward.coulomb_speed = p[1];
    j.control.feed_forward.coulomb_from = CoulombFrom::reference;
}

void add_acceleration(Joint& j, double per_acceleration)
{
    j.control.feed_forward.acceleration = per_acceleration / effort_per_command(j);
}

EffectForm factor(std::string_view name, std::string_view help, void (*apply)(Joint&, const double*),
                  bool (*applies)(const Joint&))
{
    EffectForm f;
    f.name = name;
    f.parameters = {factor_on_number(0.1, 10, 0.3, help, name)};
    f.apply = apply;
    f.seeds = {{1.1}, {0.9}};
    f.applies = applies;
    return f;
}

/// What the document lacks. The motion alone does not tell it from another inertia or another level of friction.
EffectForm lacking(std::string_view name, std::vector<EffectParameter> parameters,
                   std::vector<std::vector<double>> seeds, void (*apply)(Joint&, const double*),
                   bool (*applies)(const Joint&))
{
    EffectForm f;
    f.name = name;
    f.parameters = std::move(parameters);
    f.apply = apply;
    f.seeds = std::move(seeds);
    f.applies = applies;
    f.effort_alone = true;
    return f;
}

}  // namespace

Effect feed_forward()
{
    Effect e;
    e.name = "feed-forward";
    e.stage = Stage::controller;
    e.in_command = true;
    e.form = "coulomb tanh(r'/speed) + acceleration r'', and the share of r' in the velocity error";
    e.source = "Franklin, Powell and Workman 1998; Armstrong-Helouvry, Dupont and Canudas de Wit 1994";
    e.confusable = {"coulomb-level", "inertia"};
    e.forms.push_back(factor(
        "coulomb", "true Coulomb feed-forward per documented",
        [](Joint& j, const double* p) { j.control.feed_forward.coulomb *= p[0]; },
        [](const Joint& j) { return !lacks_coulomb(j); }));
    e.forms.push_back(factor(
        "acceleration", "true acceleration feed-forward per documented",
        [](Joint& j, const double* p) { j.control.feed_forward.acceleration *= p[0]; },
        [](const Joint& j) { return !lacks_acceleration(j); }));
    e.forms.push_back(factor(
        "velocity", "true share of the reference's velocity per documented",
        [](Joint& j, const double* p) { j.control.feed_forward.velocity *= p[0]; },
        [](const Joint& j) {
            return j.control.reference_velocity && j.control.feed_forward.velocity != 0 && j.control.k_v != 0;
        }));
    e.forms.back().effort_alone = true;  // viscous friction moves the joint likewise
    e.forms.push_back(lacking("undocumented-coulomb", {coulomb, coulomb_speed}, {{0.3, 0.05}, {-0.3, 0.05}},
                              add_coulomb, lacks_coulomb));
    e.forms.push_back(lacking(
        "undocumented-acceleration", {acceleration}, {{0.3}, {-0.3}},
        [](Joint& j, const double* p) { add_acceleration(j, p[0]); }, lacks_acceleration));
    e.forms.push_back(lacking(
        "undocumented", {coulomb, coulomb_speed, acceleration}, {{0.3, 0.05, 0.3}},
        [](Joint& j, const double* p) { add_coulomb(j, p), add_acceleration(j, p[2]); },
        [](const Joint& j) { return lacks_coulomb(j) && lacks_acceleration(j); }));
    e.forms.back().parts = {{"feed-forward", "undocumented-coulomb"}, {"feed-forward", "undocumented-acceleration"}};
    return e;
}

}  // namespace stickslip::gap
