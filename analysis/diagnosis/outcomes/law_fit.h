// One friction law against a table of outcomes: its most likely numbers, and what they say of rows left out.
#pragma once
#include "analysis/diagnosis/outcomes/outcome_table.h"
#include "analysis/diagnosis/outcomes/rivals.h"

#include <functional>

namespace stickslip::gap {

/// A table with the joint of every row.
struct Outcomes {
    OutcomeTable table;
    std::vector<Joint> joints;  ///< nominal, with the settings of the row
    OutcomeScales scales;
    std::function<void()> checkpoint = {};  ///< called before every row is looked at; may throw to end early

    std::size_t size() const { return joints.size(); }
};

struct LawFit {
    const RivalLaw* rival = nullptr;  ///< nullptr: the nominal joint
    FrictionLaw law;
    std::vector<double> x;                       ///< what was searched; the softness of the boundary comes last
    std::vector<double> values, standard_error;  ///< SI, as the rival names them
    std::vector<double> distance;                ///< of every row, with all rows fitted
    std::vector<double> probability;             ///< of stick-slip in every row, by the fit to the other rows
    std::vector<double> amplitude;               ///< predicted, where one was measured and predicted; else NaN
    double softness = 0.1;                       ///< relative width of the boundary that the rows show
    double held_out = 0;                         ///< log-likelihood of all rows, each by the fit to the others
    double amplitude_held_out = 0;               ///< the same of amplitudes, less that of perfect ones
    bool followed = false;                       ///< its motions from rest were simulated
    int misjudged = 0;                           ///< rows whose probability lies on the wrong side
    int beyond_linear = 0;                       ///< rows whose motion from rest ends otherwise than small disturbances
    double posterior = 0;

    double total() const { return held_out + amplitude_held_out; }
};

/// Probability of stick-slip at a distance from the boundary.
double probability_at(double distance, double softness);

/// The joint of a row with another law; nothing else of its friction is kept.
Joint with_law(const Joint& joint, const FrictionLaw& law);

/// Fits a law to all rows, then to four fifths of them in turn. Deterministic; safe to call side by side.
LawFit fit_law(const Outcomes& outcomes, const RivalLaw& rival);

/// The nominal joint: only the softness of its boundary is fitted.
LawFit judge_nominal_law(const Outcomes& outcomes, const Joint& nominal);

/// What the amplitudes that judge would score if all were guessed to be their middle one: what a law has to beat.
double guessed_amplitudes(const Outcomes& outcomes);

/// Follows the motion from rest at every row where the law has memory, and the amplitudes where they were measured.
/// With amplitudes the number that stretches motion alone is fitted to every other one of them, and the rest judge it.
void confirm_by_motion(const Outcomes& outcomes, LawFit& fit);

}  // namespace stickslip::gap
