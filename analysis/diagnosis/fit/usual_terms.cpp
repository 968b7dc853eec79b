// Small terms that every machine has, and how large they usually are.
#include "analysis/diagnosis/fit/corrections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace stickslip::gap {
namespace {

/// What part of a size a record sees: of a change that comes with time, and of a peak that falls with the speed up to
/// the usual one.
double part_within_record(const Candidate& causes, const EffectForm& form, const Eigen::VectorXd& x, Eigen::Index at)
{
    const auto parameter = [&](Eigen::Index i) {
        return static_cast<std::size_t>(i) < causes.parameter_count() ? causes.parameter(static_cast<std::size_t>(i))
                                                                      : EffectParameter{};
    };
    const auto &size = parameter(at), &next = parameter(at + 1);
    if (size.name == "change" && next.scale == Scale::duration) return 1 - std::exp(-std::exp(-x[at + 1]));
    if (size.name != "c2" || next.name != "c3") return 1;
    const double exponent = parameter(at + 2).name == "c4" ? std::exp(x[at + 2]) : form.name == "gaussian" ? 2 : 1;
    return 1 - std::exp(-std::pow(std::exp(-x[at + 1]), exponent));
}

}  // namespace

bool Corrections::is_usual(const Candidate& causes, const Eigen::VectorXd& x, const Effect& cause) const
{
    constexpr std::array<std::string_view, 5> small_terms{"cogging", "position-dependent-friction",
                                                          "asymmetric-friction", "friction-drift", "stribeck"};
    if (std::ranges::count(small_terms, cause.name) == 0) return false;
    Eigen::Index at = 0;
    for (std::size_t i = 0; i < causes.effects.size(); ++i)
        for (std::size_t k = 0; k < causes.count_of(*causes.forms[i]); ++k, ++at) {
            if (causes.effects[i] != &cause) continue;
            const auto& p = causes.parameter(static_cast<std::size_t>(at));
            const double size = std::abs(x[at]);
            if (p.quantity == Quantity::effort &&
                size * part_within_record(causes, *causes.forms[i], x, at) > usual_effort_)
                return false;
            if (p.quantity == Quantity::damping && std::abs(x[at]) > usual_drag_) return false;
        }
    return true;
}

}  // namespace stickslip::gap
