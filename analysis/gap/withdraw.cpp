#include "analysis/gap/withdraw.h"

namespace stickslip::gap {

bool withdraw_if_worse(Diagnosis& d)
{
    if (d.verdict != Verdict::gap || !d.overall.worse()) return false;
    d.verdict = Verdict::unknown;
    std::string names;
    if (!d.effects.empty())
        for (const auto& name : d.effects[0].names) names += (names.empty() ? "" : " with ") + name;
    d.reasons.insert(d.reasons.begin(), names +
                                            " fits best, but makes the simulation of held-out data worse: "
                                            "it is not named as the cause");
    d.ambiguous_with.clear();
    d.next_experiment = {};
    return true;
}

}  // namespace stickslip::gap
