#include "sweep/study/guarantee/nonconformity.h"

#include <algorithm>

namespace stickslip::guarantee {
namespace {

/// The probability of all that is ranked and holds the cause; of everything without one.
double listed(const blind::Answer& answer, const std::string& cause = "")
{
    double sum = 0;
    for (std::size_t i = 0; i < std::min(answer.ranked.size(), answer.probabilities.size()); ++i)
        if (cause.empty() || std::ranges::count(answer.ranked[i], cause)) sum += answer.probabilities[i];
    return std::clamp(sum, 0.0, 1.0);
}

double probability_of(const blind::Answer& answer, const std::string& cause)
{
    if (cause == no_gap) return answer.verdict == "no-gap" ? 1 : 0;
    if (cause != none_of_these) return listed(answer, cause);
    // what the list leaves is the probability that none of it is the cause
    const bool judged = answer.verdict == "gap" || answer.verdict == "unknown";
    return judged ? 1 - listed(answer) : 0;
}

}  // namespace

std::vector<std::string> causes_of(const blind::Truth& truth)
{
    if (truth.verdict == "unknown") return {none_of_these};
    if (truth.effects.empty()) return {no_gap};
    return truth.effects;
}

double nonconformity(const blind::Answer& answer, const std::string& cause)
{
    return answer.verdict == "insufficient-data" ? 0 : 1 - probability_of(answer, cause);
}

double nonconformity(const blind::Answer& answer, const blind::Truth& truth)
{
    double most = 0;
    for (const auto& cause : causes_of(truth)) {
        double least = nonconformity(answer, cause);
        const bool other_names = cause != none_of_these && (cause != no_gap || truth.dirty);
        for (const auto& other : truth.equivalent)
            if (other_names) least = std::min(least, nonconformity(answer, other));
        most = std::max(most, least);
    }
    return most;
}

}  // namespace stickslip::guarantee
