#include "analysis/diagnosis/verdict/sheet_values.h"

#include "analysis/diagnosis/policy/policy.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

struct SheetNumber {
    std::string_view effect, key;
    Quantity quantity;
    double (*of)(Joint& joint);  ///< one of its own, which stays as it is
    std::string_view form = {};  ///< empty: every form without a line of its own
};

constexpr SheetNumber sheet[] = {
    {"asymmetric-friction", "Coulomb level, positive direction", Quantity::effort,
     [](Joint& j) { return coulomb_force(main_friction(j)) + main_friction(j).asymmetry.coulomb; }},
    {"asymmetric-friction", "Coulomb level, negative direction", Quantity::effort,
     [](Joint& j) { return coulomb_force(main_friction(j)) - main_friction(j).asymmetry.coulomb; }},
    {"asymmetric-friction", "viscous slope, positive direction", Quantity::damping,
     [](Joint& j) { return viscous_slope(main_friction(j)) + main_friction(j).asymmetry.viscous; }},
    {"asymmetric-friction", "viscous slope, negative direction", Quantity::damping,
     [](Joint& j) { return viscous_slope(main_friction(j)) - main_friction(j).asymmetry.viscous; }},
    {"coulomb-level", "Coulomb level", Quantity::effort, [](Joint& j) { return coulomb_force(main_friction(j)); }},
    {"coulomb-level", "Coulomb level on the link", Quantity::effort,
     [](Joint& j) { return coulomb_force(j.frictions.link); }, "link"},
    {"coulomb-level", "Coulomb level on the motor", Quantity::effort,
     [](Joint& j) { return coulomb_force(j.frictions.motor); }, "motor"},
    {"friction-drift", "Coulomb level at the start", Quantity::effort,
     [](Joint& j) { return coulomb_force(main_friction(j)); }},
    {"friction-drift", "Coulomb level in the end", Quantity::effort,
     [](Joint& j) { return coulomb_force(main_friction(j)) + main_friction(j).drift.change; }},
    {"viscous", "viscous slope", Quantity::damping, [](Joint& j) { return viscous_slope(main_friction(j)); }},
    {"viscous", "viscous slope on the link", Quantity::damping,
     [](Joint& j) { return viscous_slope(j.frictions.link); }, "link"},
    {"viscous", "viscous slope on the motor", Quantity::damping,
     [](Joint& j) { return viscous_slope(j.frictions.motor); }, "motor"},
    {"inertia", "inertia", Quantity::inertia, [](Joint& j) { return j.mechanism.inertia; }},
    {"inertia", "link inertia", Quantity::inertia, [](Joint& j) { return j.mechanism.link_inertia; }, "link"},
    {"inertia", "motor inertia", Quantity::inertia, [](Joint& j) { return j.mechanism.motor_inertia; }, "motor"},
    {"constant-load", "constant load", Quantity::effort, [](Joint& j) { return j.load.constant; }},
    {"gravity", "gravity amplitude", Quantity::effort, [](Joint& j) { return j.load.gravity_amplitude; }},
    {"cogging", "cogging amplitude", Quantity::effort, [](Joint& j) { return j.load.cogging.amplitude; }},
    {"periodic-disturbance", "amplitude of the periodic force", Quantity::effort,
     [](Joint& j) { return j.load.disturbance.amplitude; }},
    {"position-dependent-friction", "amplitude over the position", Quantity::effort,
     [](Joint& j) { return main_friction(j).ripple.amplitude; }},
};

bool is_about(const SheetNumber& number, const Effect& effect, const EffectForm& form)
{
    if (number.effect != effect.name) return false;
    const bool has_line = std::ranges::any_of(
        sheet, [&](const SheetNumber& n) { return n.effect == effect.name && !n.form.empty() && n.form == form.name; });
    return has_line ? number.form == form.name : number.form.empty();
}

/// Mean over the records, which may differ in numbers of their own.
double mean_of(const SheetNumber& number, const Prepared& p, const Candidate& candidate, const Eigen::VectorXd& x)
{
    const auto si = in_si(candidate, x, p.scales);
    double sum = 0;
    for (const auto& c : p.cases) {
        Joint joint = edited(c.joint, candidate, si, c.number);
        sum += number.of(joint);
    }
    return sum / static_cast<double>(p.cases.size());
}

}  // namespace

std::vector<SheetValue> sheet_values(const Prepared& p, const Attribution& a, const Quality& quality,
                                     std::size_t corrections)
{
    constexpr double small = 1e-4;  // numerical: of the unit in which a parameter is fitted
    const Candidate& c = a.candidate;
    const Eigen::VectorXd& x = a.x[ladder_level];
    std::vector<SheetValue> values;
    for (const auto& number : sheet) {
        bool changed = false, by_direction = false;
        for (std::size_t i = corrections; i < c.effects.size(); ++i) {
            changed |= is_about(number, *c.effects[i], *c.forms[i]);
            by_direction |= c.effects[i]->name == "asymmetric-friction";
        }
        const bool both_ways = number.effect == "coulomb-level" || number.effect == "viscous";
        if (!changed || (by_direction && both_ways)) continue;
        SheetValue v{std::string(number.key),
                     mean_of(number, p, c, x),
                     {},
                     std::string(unit_of(number.quantity, units_of(p.documented[0])))};
        if (quality.covariance.rows() == x.size()) {
            Eigen::VectorXd slope(x.size());
            for (Eigen::Index k = 0; k < x.size(); ++k) {
                Eigen::VectorXd more = x, less = x;
                more[k] += small, less[k] -= small;
                slope[k] = (mean_of(number, p, c, more) - mean_of(number, p, c, less)) / (2 * small);
            }
            double variance = 0;
            bool unknown = slope.isZero();
            for (Eigen::Index k = 0; k < x.size(); ++k)
                for (Eigen::Index l = 0; l < x.size(); ++l) {
                    if (slope[k] == 0 || slope[l] == 0) continue;
                    unknown = unknown || !std::isfinite(quality.covariance(k, l));
                    variance += slope[k] * quality.covariance(k, l) * slope[l];
                }
            if (!unknown) {
                const double error = policy::two_sided_95 * std::sqrt(std::max(0.0, variance));
                v.interval = {v.value - error, v.value + error};
                v.pinned = error < std::abs(v.value);
            }
        }
        values.push_back(std::move(v));
    }
    return values;
}

}  // namespace stickslip::gap
