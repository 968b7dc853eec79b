#include "analysis/diagnosis/verdict/report_corrections.h"

#include "analysis/diagnosis/fit/candidate_numbers.h"
#include "analysis/diagnosis/policy/ladder_verdict.h"
#include "analysis/diagnosis/policy/page_and_plan.h"
#include "analysis/diagnosis/verdict/causes.h"
#include "analysis/diagnosis/verdict/quality.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {

std::vector<Correction> corrections_of(const Prepared& p, const JudgedLadder& j)
{
    std::vector<Correction> all;
    const Candidate& c = j.winner.candidate;
    const auto quality = quality_of(p.cases, j.winner, p.scales);
    const auto si = in_si(c, j.winner.x[ladder_level], p.scales);
    const Units units = units_of(p.documented[0]);
    std::size_t i = 0;
    for (std::size_t n = 0; n < j.corrections; ++n)
        for (std::size_t k = 0; k < c.count_of(*c.forms[n]); ++k, ++i) {
            const auto& parameter = c.parameter(i);
            std::string name = std::string(c.effects[n]->name) + "." + std::string(parameter.name);
            if (c.forms[n]->own > 0) name = "coulomb-level.change in " + p.cases[k].ticks.name;
            // a small term has no document to be off: its prior is that of its size
            const bool of_document = prior_mean(c, i) == 0;
            const double sd =
                !of_document ? not_set : c.sd_of(i) * (parameter.logarithmic ? 1 : unit_of(parameter.scale, p.scales));
            all.push_back({c.forms[n]->own > 0 ? "coulomb-level" : std::string(c.effects[n]->name),
                           {name, si[i], quality.standard_error[i], std::string(unit_of(parameter.quantity, units))},
                           sd});
        }
    return all;
}

std::vector<std::string> furthest_off(const JudgedLadder& j)
{
    const Candidate& c = j.winner.candidate;
    const Eigen::VectorXd& x = j.winner.x[ladder_level];
    std::size_t i = 0;
    double largest = 0;
    std::vector<std::string> name;
    for (std::size_t n = 0; n < j.corrections; ++n)
        for (std::size_t k = 0; k < c.count_of(*c.forms[n]); ++k, ++i)
            if (const double off = std::abs(x[static_cast<Eigen::Index>(i)]) / c.sd_of(i);
                off > largest && !Corrections::is_small_term(*c.effects[n])) {
                largest = off;
                name = {c.forms[n]->own > 0 ? "coulomb-level" : std::string(c.effects[n]->name)};
            }
    return name;
}

std::vector<std::string> that_matter(const Prepared& p, const JudgedLadder& j)
{
    std::vector<std::string> names;
    const Candidate& c = j.winner.candidate;
    const auto squares = [&](const Eigen::VectorXd& x) {
        double sum = 0;
        for (const auto& m : evaluate(p.cases, c, in_si(c, x, p.scales), levels[ladder_level]).records)
            sum += m.position + m.effort;
        return sum;
    };
    const Eigen::VectorXd& x = j.winner.x[ladder_level];
    const double all = squares(x), none = squares(Eigen::VectorXd::Zero(x.size()));
    Eigen::Index at = 0;
    for (std::size_t n = 0; n < c.effects.size(); ++n) {
        const auto count = static_cast<Eigen::Index>(c.count_of(*c.forms[n]));
        Eigen::VectorXd less = x;
        less.segment(at, count).setZero();
        at += count;
        if (Corrections::is_small_term(*c.effects[n])) continue;  // in no document
        const std::string name = c.forms[n]->own > 0 ? "coulomb-level" : std::string(c.effects[n]->name);
        if (squares(less) - all > policy::worth_correcting * (none - all) &&
            std::find(names.begin(), names.end(), name) == names.end())
            names.push_back(name);
    }
    return names.empty() ? furthest_off(j) : names;
}

double taken_by_numbers(const JudgedLadder& j)
{
    double sum = 0;
    for (const auto& [effect, share] : j.numbers) sum += share.share;
    return sum;
}

namespace {

/// Of several numbers that are named as off the sets without one that the records do not hold off its document: over
/// one direction of sliding a Coulomb level and a constant load are one number, and only their priors divide it.
std::vector<std::vector<std::string>> fewer_numbers(const Prepared& p, const JudgedLadder& j,
                                                    const std::vector<std::string>& named)
{
    constexpr double hardly_held = 100;  // numerical: of a prior's width; what stands along it is open
    Attribution free = j.winner;
    const Candidate& c = free.candidate;
    // levels of single records stay where they are: moved with the common one, they would leave it open anyhow
    for (std::size_t n = 0, i = 0; n < j.corrections; i += c.count_of(*c.forms[n++]))
        for (std::size_t k = 0; k < c.count_of(*c.forms[n]); ++k)
            free.candidate.prior_sd[i + k] *= c.forms[n]->own == 0 ? hardly_held : 1 / hardly_held;
    const auto covariance = quality_of(p.cases, free, p.scales).covariance;
    std::vector<std::vector<std::string>> sets;
    Eigen::Index at = 0;
    for (std::size_t n = 0; n < j.corrections; ++n) {
        const auto count = static_cast<Eigen::Index>(c.count_of(*c.forms[n]));
        const auto name = std::ranges::find(named, c.effects[n]->name);
        const bool one = c.forms[n]->own == 0 && count == 1 && covariance.rows() > at;
        if (named.size() > 1 && name != named.end() && one &&
            std::abs(j.winner.x[ladder_level][at]) < policy::two_sided_95 * std::sqrt(covariance(at, at))) {
            sets.push_back(named);
            sets.back().erase(sets.back().begin() + (name - named.begin()));
        }
        at += count;
    }
    return sets;
}

}  // namespace

std::vector<Cause> numbers_alone(const Prepared& p, const JudgedLadder& j)
{
    Cause c = cause_of(p, j.winner, j.noise_left ? policy::numbers_to_noise : policy::numbers_and_more);
    c.names = j.numbers.empty() ? that_matter(p, j) : j.with_numbers({});
    c.signatures = {"numbers"};
    std::erase_if(c.parameters, [&](const auto& parameter) {
        return std::ranges::none_of(c.names, [&](const auto& n) { return is_of(parameter, n); });
    });
    c.heldout_gain = 1 - std::sqrt(j.shares.base / std::max(1e-300, j.shares.documented));
    const auto fewer = fewer_numbers(p, j, c.names);
    c.probability /= static_cast<double>(1 + fewer.size());
    std::vector<Cause> causes{std::move(c)};
    for (const auto& names : fewer) {
        Cause rival;
        rival.names = names;
        rival.probability = causes[0].probability;
        rival.misfit = causes[0].misfit;
        causes.push_back(std::move(rival));
    }
    return causes;
}

}  // namespace stickslip::gap
