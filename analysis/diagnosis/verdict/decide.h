// From fits to an answer: what is noise, what is named, what cannot be distinguished, how likely.
#pragma once
#include "analysis/diagnosis/heldout/ensemble.h"

namespace stickslip::gap {

/// Whether a joint's misfit is what its own noise makes of it.
bool at_floor(const Fit& fit, const Attribution& a);

/// Part of the nominal joint's excess misfit at the middle level that is gone, where what a true joint of the kind
/// would leave by its own noise is no excess: between the rows of a slow log, or behind a jump, that can be many
/// floors.
double explained_beyond(const NoiseSpread& own, const Evaluation& middle, const Nominal& nominal);

/// Whether a wave among the effects has a period so much longer than the travel, or than the records, that only a bend
/// of it is seen: with a second free shape beside it, it bends into any smooth force.
bool bends_only(const Candidate& candidate, const Eigen::VectorXd& x, const Scales& scales);

/// Whether two of the causes are free functions of position, or of time: a short Fourier series, which comes near any
/// smooth force.
bool two_free_shapes(const Attribution& a);

/// Judges the best few against the noise that they themselves would have, which fixed thresholds do not know.
void confirm(const Fit& fit, std::vector<Attribution>& ranked);

struct Decision {
    bool named = false;
    const Attribution* winner = nullptr;
    std::vector<const Attribution*> ambiguous;
    double best_explained = 0;
};

/// The named cause, if any, and what this excitation, of so many rows, cannot tell from it. Pairs count only where no
/// single is accepted.
Decision decide(const std::vector<Attribution>& singles, const std::vector<Attribution>& pairs, double rows);

struct Ranked {
    const Attribution* attribution = nullptr;
    double probability = 0;
};

/// Everything fitted, the named one first, then the most probable: by the same odds, of `rows` rows in all records;
/// what is left for "none of these" grows with the winner's misfit.
std::vector<Ranked> rank(const std::vector<Attribution>& singles, const std::vector<Attribution>& pairs,
                         const Decision& decision, double rows);

/// Whether any effect of usual size would have shown itself at five times the noise.
bool could_have_shown(const Fit& fit);

}  // namespace stickslip::gap
