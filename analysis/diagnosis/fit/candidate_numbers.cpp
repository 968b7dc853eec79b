#include "analysis/diagnosis/fit/candidate_numbers.h"

#include "analysis/diagnosis/fit/effect.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <vector>

namespace stickslip::gap {
namespace {

double bounded(const EffectParameter& p, double x)
{
    if (p.logarithmic) return std::clamp(x, std::log(p.low), std::log(p.high));
    return std::clamp(x, p.low, p.high);
}

/// The parameters of one form, which begin at `first`, as they hold in a record.
std::vector<double> held_in(std::size_t record, const EffectForm& form, std::vector<double>::const_iterator first,
                            const Candidate& candidate)
{
    const auto shared = static_cast<std::ptrdiff_t>(form.parameters.size() - form.own);
    const auto own = first + shared + static_cast<std::ptrdiff_t>(form.own * std::min(record, candidate.records - 1));
    std::vector<double> p(first, first + shared);
    p.insert(p.end(), own, own + static_cast<std::ptrdiff_t>(form.own));
    return p;
}

}  // namespace

Eigen::VectorXd bounded(const Candidate& c, Eigen::VectorXd x)
{
    for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = bounded(c.parameter(static_cast<std::size_t>(i)), x[i]);
    return x;
}

double prior_mean(const Candidate& c, std::size_t i)
{
    for (const auto* f : c.forms) {
        if (i >= c.count_of(*f)) {
            i -= c.count_of(*f);
            continue;
        }
        if (f->seeds.empty() || i >= f->seeds[0].size()) return 0;
        return f->parameters[i].logarithmic ? std::log(f->seeds[0][i]) : f->seeds[0][i];
    }
    return 0;
}

std::optional<std::size_t> record_of(const Candidate& c, std::size_t i)
{
    for (const auto* f : c.forms) {
        const std::size_t shared = f->parameters.size() - f->own;
        if (i < c.count_of(*f)) return i < shared ? std::nullopt : std::optional((i - shared) / f->own);
        i -= c.count_of(*f);
    }
    return std::nullopt;
}

std::vector<double> in_si(const Candidate& candidate, const Eigen::VectorXd& x, const Scales& scales)
{
    std::vector<double> si(static_cast<std::size_t>(x.size()));
    for (std::size_t i = 0; i < si.size(); ++i) {
        const auto& p = candidate.parameter(i);
        const double value = bounded(p, x[static_cast<Eigen::Index>(i)]);
        si[i] = unit_of(p.scale, scales) * (p.logarithmic ? std::exp(value) : value);
    }
    return si;
}

Eigen::VectorXd to_fit(const Candidate& candidate, const std::vector<double>& scaled)
{
    Eigen::VectorXd x(static_cast<Eigen::Index>(scaled.size()));
    for (std::size_t i = 0; i < scaled.size(); ++i) {
        const auto& p = candidate.parameter(i);
        const double value = std::clamp(scaled[i], p.low, p.high);
        x[static_cast<Eigen::Index>(i)] = p.logarithmic ? std::log(value) : value;
    }
    return x;
}

Joint edited(const Joint& joint, const Candidate& candidate, const std::vector<double>& si, std::size_t record)
{
    Joint j = joint;
    auto first = si.begin();
    for (const auto* form : candidate.forms) {
        if (form->apply) form->apply(j, held_in(record, *form, first, candidate).data());
        first += static_cast<std::ptrdiff_t>(candidate.count_of(*form));
    }
    return j;
}

Plant edited_plant(const Joint& joint, const Candidate& candidate, const std::vector<double>& si, std::size_t record)
{
    Plant plant = flatten(edited(joint, candidate, si, record));
    auto first = si.begin();
    for (const auto* form : candidate.forms) {
        if (form->apply_free) form->apply_free(plant.free, held_in(record, *form, first, candidate).data());
        first += static_cast<std::ptrdiff_t>(candidate.count_of(*form));
    }
    return plant;
}

double parameters_more(const Candidate& c, const Candidate& than)
{
    return std::max(0.0, static_cast<double>(c.parameter_count()) - static_cast<double>(than.parameter_count()));
}

bool makes_the_motion_of(const Candidate& one, const Candidate& rival)
{
    const auto only_in = [](const Candidate& c, const Candidate& not_in) {
        std::vector<std::size_t> members;
        for (std::size_t i = 0; i < c.effects.size(); ++i)
            if (std::ranges::count(not_in.effects, c.effects[i]) == 0) members.push_back(i);
        return members;
    };
    const auto own = only_in(one, rival), others = only_in(rival, one);
    return own.size() == 1 && others.size() == 1 &&
           std::ranges::count(rival.forms[others[0]]->same_motion, one.effects[own[0]]->name) > 0;
}

bool move_alike(const Candidate& one, const Candidate& other)
{
    return makes_the_motion_of(one, other) || makes_the_motion_of(other, one);
}

}  // namespace stickslip::gap
