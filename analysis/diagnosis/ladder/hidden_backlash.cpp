// Backlash of a joint whose two masses are documented, in addition to causes that hide it.
#include "analysis/diagnosis/ladder/climber.h"

#include "analysis/diagnosis/fit/candidate_numbers.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

constexpr double width_step = 1.15;  // numerical: only within a fifth of the right one does the misfit lead to a width
constexpr std::size_t go_on = 2;     // dips, deepest first

}  // namespace

std::vector<Start> Climber::with_hidden_backlash(const std::vector<FittedSet>& sets) const
{
    std::vector<Start> dips;
    for (const auto& single : singles_) {
        const Effect* effect = single.candidate.effects[0];
        for (const auto& form : effect->forms) {
            const Candidate alone{{effect}, {&form}, single.candidate.records};
            if (!form.needs_history || !alone.applies(fitter_.joint())) continue;
            for (const auto& set : sets) {
                if (!set.plausible || std::ranges::count(set.causes.effects, effect) > 0) continue;
                for (auto& dip : fitter_.dips(set, *effect, form, width_step)) dips.push_back(std::move(dip));
            }
        }
    }
    std::ranges::stable_sort(dips, {}, &Start::objective);
    if (dips.size() > go_on) dips.resize(go_on);
    return dips;
}

std::vector<Start> SetFitter::dips(const FittedSet& below, const Effect& effect, const EffectForm& form,
                                   double step) const
{
    const double from = std::log(form.seeds.front()[0]), to = std::log(form.seeds.back()[0]);
    const auto count = static_cast<std::size_t>((to - from) / std::log(step)) + 1;
    std::vector<Start> tried;
    std::vector<std::vector<double>> si;
    for (std::size_t i = 0; i < count; ++i) {
        Start& s = tried.emplace_back(Start{below.causes});
        const Eigen::VectorXd width =
            Eigen::VectorXd::Constant(1, from + static_cast<double>(i) * std::log(step));  // fitted as a logarithm
        const Eigen::VectorXd x = insert(s.causes, &effect, &form, below.of_causes(below.fit.x), width);
        s.x0 = start(s.causes, below, x);
        si.push_back(in_si(corrections_.beside(s.causes).candidate, s.x0, scales_));
    }
    const auto looks =
        evaluate_all(whole_, corrections_.beside(tried.front().causes).candidate, si, {levels[ladder_level]});
    std::vector<Start> dips;
    for (std::size_t i = 0; i < count; ++i) {
        tried[i].objective = looks[i].objective;
        if (i > 0 && i + 1 < count && looks[i].objective < looks[i - 1].objective &&
            looks[i].objective < looks[i + 1].objective)
            dips.push_back(tried[i]);
    }
    return dips;
}

}  // namespace stickslip::gap
