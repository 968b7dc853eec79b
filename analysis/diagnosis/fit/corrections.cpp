#include "analysis/diagnosis/fit/corrections.h"

#include "analysis/diagnosis/fit/candidate_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stickslip::gap {
namespace {

constexpr std::string_view of_record = "coulomb-level of the record", load = "constant-load";

/// A number of the friction: how it is read and changed, and how it grows through the reduction. An effort of the motor
/// is N times as large at the joint; a slope is N squared times as large, as the motor also moves N times as fast.
struct FrictionNumber {
    double (*of)(const Friction&);
    void (*shift)(Friction&, double);
    bool is_slope;

    double per_motor(const Joint& j) const
    {
        const double ratio = j.mechanism.transmission.ratio;
        return is_slope ? ratio * ratio : ratio;
    }
    double at_joint(const Joint& j) const
    {
        if (is_single_mass(j)) return of(j.friction);
        return per_motor(j) * of(j.frictions.motor) + of(j.frictions.link);
    }
};

constexpr FrictionNumber coulomb_number{coulomb_force, shift_coulomb, false};
constexpr FrictionNumber viscous_number{viscous_slope, shift_viscous, true};

/// Shares a change at the joint out between two bodies, in proportion.
void change_friction(Joint& j, const FrictionNumber& number, const double change)
{
    if (is_single_mass(j)) return number.shift(j.friction, change);
    const double all = number.at_joint(j);
    const double motor = all > 0 ? number.per_motor(j) * number.of(j.frictions.motor) / all : 0.5;
    number.shift(j.frictions.motor, motor * change / number.per_motor(j));
    number.shift(j.frictions.link, (1 - motor) * change);
}

/// Whether each of the numbers is as near as this many standard deviations; the last of these is of all that follow.
bool within(const Eigen::VectorXd& numbers, const std::vector<double>& sds, double most)
{
    for (Eigen::Index n = 0; n < numbers.size(); ++n)
        if (std::abs(numbers[n]) > most * sds[std::min(static_cast<std::size_t>(n), sds.size() - 1)]) return false;
    return true;
}

}  // namespace

void Corrections::add(std::string_view name, const EffectParameter& parameter, void (*apply)(Joint&, const double*),
                      bool own)
{
    EffectForm form;
    form.parameters = {parameter};
    form.apply = apply;
    form.own = own;
    Effect& e = effects_.emplace_back();
    e.name = name;
    e.stage = Stage::correction;
    e.forms.push_back(std::move(form));
}

Corrections::Corrections(const std::vector<Case>& cases, const Scales& scales, const CorrectionPrior& prior)
    : records_(cases.size()), widest_(prior.widest)
{
    double seconds = 0;
    for (const auto& c : cases) seconds += c.ticks.duration();
    weight_ = 1 / std::max(1.0, seconds / block_time);
    const Joint& j = cases[0].joint;
    const double level = std::max(coulomb_number.at_joint(j) / unit_of(Scale::load_effort, scales), prior.least);
    const auto number = [&](Quantity quantity, Scale scale, bool logarithmic, double sd, std::string_view help) {
        EffectParameter p{logarithmic ? "factor" : "change",
                          quantity,
                          scale,
                          logarithmic,
                          -prior.widest * sd,
                          prior.widest * sd,
                          sd,
                          help};
        p.factor = logarithmic;
        if (logarithmic) p.low = std::exp(p.low), p.high = std::exp(p.high);
        sds_.push_back({sd});
        return p;
    };
    add(
        "inertia", number(Quantity::number, Scale::one, true, prior.inertia, "true inertia per documented"),
        [](Joint& to, const double* p) {
            to.mechanism.inertia *= p[0], to.mechanism.motor_inertia *= p[0], to.mechanism.link_inertia *= p[0];
        },
        false);
    add(
        "coulomb-level",
        number(Quantity::effort, Scale::load_effort, false, prior.coulomb * level, "change of the Coulomb level"),
        [](Joint& to, const double* p) { change_friction(to, coulomb_number, p[0]); }, false);
    const double drag = std::max(
        viscous_number.at_joint(j) * unit_of(Scale::load_velocity, scales) / unit_of(Scale::load_effort, scales),
        prior.least);
    small_sd_ = prior.small_term * level;
    usual_effort_ = prior.widest * small_sd_;
    usual_drag_ = prior.widest * prior.viscous * drag;
    add(
        "viscous",
        number(Quantity::damping, Scale::load_damping, false, prior.viscous * drag, "change of the viscous slope"),
        [](Joint& to, const double* p) { change_friction(to, viscous_number, p[0]); }, false);
    add(
        load, number(Quantity::effort, Scale::load_effort, false, prior.load * level, "constant load"),
        [](Joint& to, const double* p) { to.load.constant += p[0]; }, false);
    if (const double gravity = std::abs(j.load.gravity_amplitude); gravity > 0) {
        add(
            "gravity",
            number(Quantity::effort, Scale::load_effort, false,
                   prior.gravity * gravity / unit_of(Scale::load_effort, scales), "change of the gravity amplitude"),
            [](Joint& to, const double* p) { to.load.gravity_amplitude += p[0]; }, false);
        // its angle is none of that number: over a small travel it is a load, and as usual as one
        sds_.back().push_back(prior.load * level);
    }
    if (records_ > 1 && prior.coulomb_of_record > 0)
        add(
            of_record,
            number(Quantity::effort, Scale::load_effort, false, prior.coulomb_of_record * level,
                   "change of the Coulomb level in this record"),
            [](Joint& to, const double* p) { change_friction(to, coulomb_number, p[0]); }, true);
}

bool Corrections::is_released(std::string_view name) const
{
    return load_released_ && name == load;
}

void Corrections::release_load(bool released)
{
    load_released_ = released;
}

Corrected Corrections::beside(const Candidate& causes) const
{
    Corrected all;
    all.candidate.records = records_;
    all.candidate.prior_weight = weight_;
    const auto is_cause = [&](std::string_view name) {
        return std::ranges::any_of(causes.effects, [&](const auto* e) { return e->name == name; });
    };
    for (std::size_t i = 0; i < effects_.size(); ++i) {
        const Effect& e = effects_[i];
        if (is_cause(e.name) || is_released(e.name)) continue;
        all.candidate.effects.push_back(&e);
        all.candidate.forms.push_back(&e.forms[0]);
        const std::size_t count = all.candidate.count_of(e.forms[0]);
        for (std::size_t k = 0; k < count; ++k)  // the numbers of all records have one
            all.candidate.prior_sd.push_back(sds_[i][std::min(k, sds_[i].size() - 1)]);
        all.numbers += count;
    }
    all.corrections = all.candidate.effects.size();
    all.candidate.effects.insert(all.candidate.effects.end(), causes.effects.begin(), causes.effects.end());
    all.candidate.forms.insert(all.candidate.forms.end(), causes.forms.begin(), causes.forms.end());
    return all;
}

Corrected Corrections::but(Corrected all, std::size_t correction)
{
    Candidate& c = all.candidate;
    const auto place = static_cast<std::ptrdiff_t>(correction);
    std::size_t at = 0;
    for (std::size_t i = 0; i < correction; ++i) at += c.count_of(*c.forms[i]);
    const std::size_t count = c.count_of(*c.forms[correction]);
    const auto first = c.prior_sd.begin() + static_cast<std::ptrdiff_t>(at);
    c.prior_sd.erase(first, first + static_cast<std::ptrdiff_t>(count));
    c.effects.erase(c.effects.begin() + place), c.forms.erase(c.forms.begin() + place);
    --all.corrections, all.numbers -= count;
    return all;
}

bool Corrections::same_number(const Effect& effect, const EffectForm& form) const
{
    return !form.own_number && std::ranges::any_of(effects_, [&](const Effect& own) {
        return own.name == effect.name && !is_small_term(own) && !is_released(own.name);
    });
}

std::optional<std::size_t> Corrections::one_of(const Candidate& causes, const Eigen::VectorXd& x) const
{
    Eigen::Index at = 0;
    for (std::size_t i = 0; i < causes.effects.size(); ++i) {
        const auto count = static_cast<Eigen::Index>(causes.count_of(*causes.forms[i]));
        const bool same = same_number(*causes.effects[i], *causes.forms[i]);
        for (std::size_t k = 0; k < effects_.size(); ++k) {
            if (causes.effects[i]->name != effects_[k].name) continue;
            const bool is_load = count > 1 && sds_[k].size() > 1;  // as an angle of gravity is
            if (same && !(load_released_ && is_load) && within(x.segment(at, count), sds_[k], widest_)) return i;
            if (is_small_term(effects_[k]) && is_usual(causes, x, *causes.effects[i])) return i;
        }
        at += count;
    }
    return std::nullopt;
}

Eigen::VectorXd Corrections::start(const Corrected& to, const Corrected& from, const Eigen::VectorXd& corrections,
                                   const Eigen::VectorXd& causes)
{
    // factors are logarithms, so zero leaves every number as it is; small terms stay where they lie, without a size
    Eigen::VectorXd x = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(to.candidate.parameter_count()));
    for (std::size_t i = 0; i < to.numbers; ++i) x[static_cast<Eigen::Index>(i)] = prior_mean(to.candidate, i);
    Eigen::Index at = 0;
    for (std::size_t i = 0; i < to.corrections; ++i) {
        const auto count = static_cast<Eigen::Index>(to.candidate.count_of(*to.candidate.forms[i]));
        Eigen::Index there = 0;
        for (std::size_t k = 0; k < from.corrections && corrections.size() > 0; ++k) {
            const auto length = static_cast<Eigen::Index>(from.candidate.count_of(*from.candidate.forms[k]));
            if (from.candidate.effects[k] == to.candidate.effects[i])
                x.segment(at, count) = corrections.segment(there, count);
            there += length;
        }
        at += count;
    }
    x.tail(causes.size()) = causes;
    return x;
}

}  // namespace stickslip::gap
