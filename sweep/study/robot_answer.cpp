#include "sweep/study/robot_answer.h"

#include <algorithm>

namespace stickslip {

std::string name_of(JointOutcome::Status status)
{
    switch (status) {
        case JointOutcome::Status::diagnosed:
            return "diagnosed";
        case JointOutcome::Status::refused:
            return "refused";
        case JointOutcome::Status::not_reached:
            break;
    }
    return "not-reached";
}

std::vector<CauseShare> named_causes(const Diagnosis& d)
{
    std::vector<CauseShare> causes;
    if (d.verdict != Verdict::gap || d.effects.empty()) return causes;
    for (const auto& rung : d.ladder)
        causes.push_back({rung.names, rung.share, rung.interval, rung.probability, rung.parameters});
    if (!causes.empty()) return causes;
    // no ladder: numbers of the document that are off, or a rig, which has one cause and its misfit
    const auto& first = d.effects.front();
    const double share = d.corrected_share > 0 ? d.corrected_share : 1 - std::min(1.0, d.overall.left());
    return {{first.names, share, {}, first.probability, first.parameters}};
}

}  // namespace stickslip
