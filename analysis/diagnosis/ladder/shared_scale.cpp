// A scale of the effort that a document and a log share: a torque constant that is off makes every number of the
// document wrong by one factor, but for those that are wrong by another factor as well.
#include "analysis/diagnosis/effects/catalogue.h"
#include "analysis/diagnosis/ladder/climber.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace stickslip::gap {

/// A number that the document states.
struct Stated {
    const Effect* effect;
    double part;           ///< its prior as a part of it
    double per_x;          ///< what a unit of its change is of it; 0: the change is a logarithm
    double logarithm = 0;  ///< of the number over the documented one, where nothing holds it to that

    void take(double x) { logarithm = per_x > 0 ? std::log(std::max(0.1, 1 + per_x * x)) : x; }
    Eigen::VectorXd times(double factor) const
    {
        const double log = logarithm + std::log(factor);
        return Eigen::VectorXd::Constant(1, per_x > 0 ? std::expm1(log) / per_x : log);
    }
};

namespace {

constexpr std::size_t agreeing = 2;       // numbers at least: one alone says nothing of what they share
constexpr std::size_t most_readings = 3;  // numerical: ladders that are fitted, a second each

double part_of(std::string_view number, const CorrectionPrior& prior)
{
    if (number == "inertia") return prior.inertia;
    if (number == "coulomb-level") return prior.coulomb;
    if (number == "viscous") return prior.viscous;
    return number == "gravity" ? prior.gravity : 0.0;
}

/// A number that is documented as less than `least` of the usual effort is stated by no document.
std::vector<Stated> stated_by(const Corrections& corrections, const CorrectionPrior& prior)
{
    const Candidate all = corrections.beside({}).candidate;
    std::vector<Stated> stated;
    for (std::size_t i = 0, at = 0; i < all.effects.size(); at += all.count_of(*all.forms[i++])) {
        const double part = part_of(all.effects[i]->name, prior), sd = all.sd_of(at);
        const bool factor = all.parameter(at).logarithmic;
        if (part > 0 && (factor || sd > part * prior.least))
            stated.push_back({effect_named(all.effects[i]->name), part, factor ? 0 : part / sd});
    }
    return stated;
}

/// Numbers of a document as wrong by one factor, but for those that are wrong by their own.
struct Reading {
    unsigned freed = 0;  ///< which of the numbers, a bit each
    double scale = 1;
    double held = 0;    ///< squared standard deviations of the others from the document over the scale
    double plain = 0;   ///< the same without a scale
    std::size_t count;  ///< of the freed ones
};

std::vector<Reading> readings_of(const std::vector<Stated>& numbers, std::size_t most_freed)
{
    std::vector<Reading> readings;
    for (unsigned freed = 0; freed < 1u << numbers.size(); ++freed) {
        Reading r{.freed = freed, .count = static_cast<std::size_t>(std::popcount(freed))};
        if (r.count > most_freed || r.count + agreeing > numbers.size()) continue;
        double sum = 0, weights = 0;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if (freed >> i & 1u) continue;
            const double weight = 1 / std::pow(numbers[i].part, 2);
            sum += numbers[i].logarithm * weight, weights += weight;
            r.plain += std::pow(numbers[i].logarithm, 2) * weight;
        }
        r.scale = std::exp(-sum / weights);
        r.held = r.plain - sum * sum / weights;
        readings.push_back(r);
    }
    return readings;
}

/// What a set has for a number, as a correction or as a cause.
double change_in(const FittedSet& set, std::string_view number)
{
    const Candidate& all = set.model.candidate;
    for (std::size_t i = 0, at = 0; i < all.effects.size(); at += all.count_of(*all.forms[i++]))
        if (all.effects[i]->name == number && all.count_of(*all.forms[i]) == 1)
            return set.fit.x[static_cast<Eigen::Index>(at)];
    return 0;
}

}  // namespace

std::vector<FittedSet> Climber::over_a_scale(const FittedSet& set, const Corrections& corrections, Scaled wanted)
{
    const Effect* scale = effect_named("effort-gain");
    auto numbers = stated_by(corrections, rules_.prior);
    const auto is_stated = [&](const Effect* e) { return std::ranges::count(numbers, e, &Stated::effect) > 0; };
    Candidate others;
    others.records = set.model.candidate.records;
    Eigen::VectorXd of_others;
    for (std::size_t i = 0; i < set.causes.effects.size(); ++i)
        if (const Effect* e = set.causes.effects[i]; e != scale && !is_stated(e))
            of_others = insert(others, e, set.causes.forms[i], of_others, set.of_member(i));
    const std::size_t beside = others.effects.size() + 1;
    if (beside > rules_.most_rungs || numbers.size() < agreeing) return {};
    take_freed(set, others, of_others, numbers);
    auto readings = readings_of(numbers, rules_.most_rungs - beside);
    const double each = rules_.far_off * rules_.far_off;
    const auto cost = [&](const Reading& r) { return r.held + each * static_cast<double>(r.count + 1); };
    double without = 0;  // each number off as a document is, or wrong on its own
    for (const auto& number : numbers) without += std::min(each, std::pow(number.logarithm / number.part, 2));
    std::erase_if(readings, [&](const Reading& r) {
        return r.plain - r.held < rules_.relieved || (wanted == Scaled::likelier && !(cost(r) < without));
    });
    std::ranges::stable_sort(readings, {}, cost);
    if (readings.size() > most_readings) readings.resize(most_readings);
    std::vector<Start> starts;
    for (const auto& r : readings) {
        Candidate freed = others;
        Eigen::VectorXd x = of_others;
        for (std::size_t i = 0; i < numbers.size(); ++i)
            if (r.freed >> i & 1u)
                x = insert(freed, numbers[i].effect, &numbers[i].effect->forms[0], x, numbers[i].times(r.scale));
        for (auto& start : scaled_by(r.scale, freed, x)) starts.push_back(std::move(start));
    }
    auto sets = judged(starts);
    std::erase_if(sets, [](const FittedSet& s) { return !s.plausible || s.correction; });
    return sets;
}

void Climber::take_freed(const FittedSet& set, const Candidate& others, const Eigen::VectorXd& of_others,
                         std::vector<Stated>& numbers) const
{
    Candidate all = others;
    Eigen::VectorXd x = of_others;
    for (const auto& number : numbers)
        x = insert(all, number.effect, &number.effect->forms[0], x,
                   Eigen::VectorXd::Constant(1, change_in(set, number.effect->name)));
    FittedSet freed = fitter_.unfitted(all, set, x);
    freed.fit = fitter_.refit(all, freed.fit.x);
    for (auto& number : numbers) {
        const auto& in = freed.causes.effects;
        number.take(freed.of_member(static_cast<std::size_t>(std::ranges::find(in, number.effect) - in.begin()))[0]);
    }
}

std::vector<Start> Climber::scaled_by(double factor, const Candidate& causes, const Eigen::VectorXd& of_causes) const
{
    const Effect* scale = effect_named("effort-gain");
    std::vector<Start> starts;
    for (const auto& form : scale->forms) {
        const Candidate alone{{scale}, {&form}, causes.records};
        if (!alone.applies(fitter_.joint()) || (form.effort_alone && !fitter_.logs_effort())) continue;
        Start start{causes};
        const auto x = insert(start.causes, scale, &form, of_causes, to_fit(alone, {factor}));
        start.x0 = fitter_.start(start.causes, {}, x);  // what the scale corrects starts as documented
        starts.push_back(std::move(start));
    }
    return starts;
}

FittedSet Climber::with_shared_scale(FittedSet set, const Corrections& corrections)
{
    if (std::ranges::count(set.causes.effects, effect_named("effort-gain")) > 0) return set;
    for (const auto& scaled : over_a_scale(set, corrections, Scaled::likelier)) {
        // each cause more has to earn its place over the scale, as it has in a ladder
        const std::size_t more =
            set.causes.effects.size() - std::min(set.causes.effects.size(), scaled.causes.effects.size());
        const double most = set.misfit + static_cast<double>(more) * least_gain(set, rules_);
        if (!(scaled.misfit < most)) continue;
        // along the scale only priors slope, and a first search ends on the way
        if (auto settled = compared({scaled}); settled.misfit < most) return settled;
    }
    return set;
}

}  // namespace stickslip::gap
