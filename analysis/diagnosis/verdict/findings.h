// What a diagnosis gathers on its way: records made ready, then the causes that were found in them.
#pragma once
#include "analysis/diagnosis/audit/audit.h"
#include "analysis/diagnosis/audit/stretches.h"
#include "analysis/diagnosis/search/free_force.h"
#include "analysis/diagnosis/verdict/decide.h"
#include "analysis/diagnosis/verdict/judge_ladder.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace stickslip::gap {

/// Records as the fits take them, and the joint that the document describes held against them.
struct Prepared {
    std::vector<Case> cases;           ///< each with the joint that the audit left; of long records stretches
    std::vector<Joint> documented;     ///< of each case, before the audit
    std::vector<Case> whole;           ///< the records where `cases` are stretches of them; else none
    std::vector<StretchOf> stretches;  ///< of each case, then
    Audit audit;
    Scales scales;
    Nominal nominal;

    Fit fit(const ParallelFor& parallel) const { return {cases, scales, nominal, parallel}; }
    bool noise_documented() const
    {
        return std::all_of(cases.begin(), cases.end(), [](const auto& c) { return c.noise_documented; });
    }
};

/// Candidates and what became of them. The decision points into the lists, so findings are moved, not copied.
struct Findings {
    Findings() = default;
    Findings(Findings&&) = default;
    Findings& operator=(Findings&&) = delete;

    Attribution none;           ///< the joint as it is
    bool within_noise = false;  ///< nothing but noise is left without any effect
    std::vector<Attribution> singles, pairs;
    std::vector<FreeFit> free;
    Decision decision;
    JudgedLadder judged;
    bool climbed = false;  ///< there is a ladder
    bool by_ladder =
        false;  ///< and the answer is the ladder's: neither a single cause nor a pair explains to within noise
    std::optional<Note> why_not;  ///< why the cause that comes nearest is not the answer

    bool named() const { return by_ladder ? judged.answers() : decision.named; }
};

}  // namespace stickslip::gap
