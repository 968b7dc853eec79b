#include "analysis/diagnosis/ladder/plausible.h"

#include "analysis/diagnosis/policy/ladder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip::gap {

namespace {

/// All of the friction may act on the link, all of the inertia behind the gear.
bool is_part_of_a_whole(const EffectParameter& p)
{
    return p.scale == Scale::one && !p.logarithmic && p.low == 0 && p.high == 1;
}

}  // namespace

bool at_bound(const EffectParameter& p, double scaled)
{
    if (is_part_of_a_whole(p)) return false;
    // an additive number may well be nothing; a factor or a size at its least is not what the name means
    const bool above =
        !p.open_above && scaled > p.high * (p.high > 0 ? 1 - policy::beside_bound : 1 + policy::beside_bound);
    return above || (p.logarithmic && scaled < p.low * (1 + policy::beside_bound)) ||
           (!p.logarithmic && p.low < 0 && scaled < p.low * (1 - policy::beside_bound));
}

namespace {

/// Whether the effect has a form that lacks just this number: at its least the number is absent, and the form is that
/// other one (LuGre's bristles without damping are Dahl's).
bool may_be_absent(const Effect& effect, const EffectForm& form, std::string_view number)
{
    const auto has = [](const EffectForm& f, std::string_view name) {
        return std::ranges::any_of(f.parameters, [&](const EffectParameter& p) { return p.name == name; });
    };
    return std::ranges::any_of(effect.forms, [&](const EffectForm& other) {
        return other.parameters.size() + 1 == form.parameters.size() &&
               std::ranges::all_of(form.parameters,
                                   [&](const EffectParameter& p) { return has(other, p.name) == (p.name != number); });
    });
}

double in_units_of(const PhysicalRange& range, double scaled, double si, const Scales& scales, const Joint& joint)
{
    // what is not documented bounds nothing
    const auto per = [&](double value, double unit) { return is_set(unit) && unit > 0 ? value / unit : range.low; };
    switch (range.per) {
        case Per::winding:
            return per(si, joint.actuator.resistance);
        case Per::coulomb: {
            Joint copy = joint;
            return per(si, coulomb_force(main_friction(copy)));
        }
        case Per::reading:
            return per(scaled * scales.position, std::max(joint.sensor.encoder_quantum, joint.sensor.position_noise));
        case Per::period_of_record:
            return si * scales.duration / (2 * std::numbers::pi);
        case Per::period_of_travel:
            return si * scales.position / (2 * std::numbers::pi);
        default:
            return scaled;
    }
}

}  // namespace

bool plausible(const Candidate& causes, const Eigen::VectorXd& x, const Scales& scales, const Joint& joint,
               std::span<const PhysicalRange> ranges)
{
    if (causes.effects.empty()) return true;
    const auto si = in_si(causes, x, scales);
    std::size_t i = 0;
    for (std::size_t n = 0; n < causes.effects.size(); ++n)
        for (std::size_t k = 0; k < causes.count_of(*causes.forms[n]); ++k, ++i) {
            const auto& p = causes.parameter(i);
            const double scaled = si[i] / unit_of(p.scale, scales);
            const bool absent =
                p.logarithmic && scaled < 2 * p.low && may_be_absent(*causes.effects[n], *causes.forms[n], p.name);
            if (at_bound(p, scaled) && !absent) return false;
            for (const auto& range : ranges) {
                if (range.effect != causes.effects[n]->name || range.parameter != p.name) continue;
                const double value = in_units_of(range, scaled, si[i], scales, joint);
                if (!(value >= range.low && value <= range.high)) return false;
            }
        }
    return true;
}

EffectForm with_physical_waves(const Effect& effect, EffectForm form, const Scales& scales,
                               std::span<const PhysicalRange> ranges)
{
    for (auto& p : form.parameters)
        for (const auto& range : ranges) {
            if (range.effect != effect.name || range.parameter != p.name || range.per != Per::period_of_travel)
                continue;
            const double unit = 2 * std::numbers::pi / scales.position / unit_of(p.scale, scales);
            p.low = std::max(p.low, range.low * unit), p.high = std::min(p.high, range.high * unit);
        }
    return form;
}

}  // namespace stickslip::gap
