// Corrections that are small terms of every machine: which there are, their priors, and how large one is.
#include "analysis/diagnosis/fit/candidate_numbers.h"
#include "analysis/diagnosis/fit/corrections.h"
#include "analysis/diagnosis/policy/ladder.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stickslip::gap {
namespace {

constexpr std::array<std::string_view, 3> looked_for{"position-dependent-friction", "cogging", "friction-drift"};

}  // namespace

std::span<const std::string_view> Corrections::small_terms()
{
    return looked_for;
}

bool Corrections::is_small_term(const Effect& correction)
{
    return std::ranges::count(looked_for, correction.name) > 0;
}

bool Corrections::has(std::string_view name) const
{
    return std::ranges::count(effects_, name, &Effect::name) > 0;
}

void Corrections::add_small_term(const Effect& effect, const EffectForm& form, const Eigen::VectorXd& x)
{
    EffectForm small = form;
    small.name = {};
    small.seeds = {{}};
    std::vector<double> sds;
    for (std::size_t i = 0; i < small.parameters.size(); ++i) {
        EffectParameter& p = small.parameters[i];
        const double at = x[static_cast<Eigen::Index>(i)];
        if (p.quantity == Quantity::effort) {
            p.low = -usual_effort_, p.high = usual_effort_;
            sds.push_back(small_sd_);
            small.seeds[0].push_back(0);
            continue;
        }
        // of a wave one radian over the travel is what a record resolves; a time hardly shows: a factor of e
        sds.push_back(p.grid != FrequencyGrid::none ? std::exp(-at) : 1);
        p.grid = FrequencyGrid::none;
        p.low = std::max(p.low, std::exp(at - widest_ * sds.back()));
        p.high = std::min(p.high, std::exp(at + widest_ * sds.back()));
        small.seeds[0].push_back(std::exp(at));
    }
    Effect& e = effects_.emplace_back();
    e.name = effect.name;
    e.stage = Stage::correction;
    e.forms.push_back(std::move(small));
    sds_.push_back(std::move(sds));
}

double Corrections::deviations(const Candidate& candidate, std::size_t correction, std::size_t at,
                               const Eigen::VectorXd& x)
{
    double square = 0;
    for (std::size_t i = at; i < at + candidate.forms[correction]->parameters.size(); ++i)
        // numbers around anything else are where it acts, not how much
        if (const double sd = candidate.sd_of(i); sd > 0 && prior_mean(candidate, i) == 0)
            square += std::pow(x[static_cast<Eigen::Index>(i)] / sd, 2);
    return std::sqrt(square);
}

bool Corrections::at_its_bound(const Candidate& candidate, std::size_t correction, std::size_t at,
                               const Eigen::VectorXd& x)
{
    return deviations(candidate, correction, at, x) > (1 - policy::inside_bound) * policy::ladder.prior.widest;
}

}  // namespace stickslip::gap
