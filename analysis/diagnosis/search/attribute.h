// Which effect, or which few together, explain the gap: every candidate fitted at every level and ranked.
#pragma once
#include "analysis/base/parallel_for.h"
#include "analysis/diagnosis/audit/audit.h"
#include "analysis/diagnosis/fit/fit.h"

#include <vector>

namespace stickslip::gap {

/// A fitted candidate. Parameters are kept for each level, since each horizon weighs different physics.
struct Attribution {
    Candidate candidate;
    std::array<Eigen::VectorXd, levels.size()> x;
    std::array<Evaluation, levels.size()> evaluation;
    Eigen::MatrixXd information;  ///< at the middle level
    double score = 0;             ///< mean log misfit over levels and records, plus a price a parameter; less is better
    double evidence = 0;          ///< the same with what is below the floor and without the price
    double explained = 0;         ///< part of the excess misfit that is gone
    bool refined = false;         ///< carried through all levels
    bool accepted = false;        ///< what is left is noise
    int evaluations = 0;
};

struct Nominal {
    std::array<Evaluation, levels.size()> evaluation;
    double score = 0;
    double worst = 0;  ///< largest misfit over floor in any record at the slow observer
};

/// What searches for causes work on: the records, what is usual in them, what the joint leaves without a cause, and how
/// tasks are run.
struct Fit {
    const std::vector<Case>& cases;
    const Scales& scales;
    const Nominal& nominal;
    const ParallelFor& parallel;
};

/// The nominal joint's misfit; `worst` at 12 rad/s.
Nominal judge_nominal(const std::vector<Case>& cases);

/// Every form of every effect that this joint can have and that the audit has not settled.
std::vector<Candidate> single_candidates(const std::vector<Case>& cases, const Audit& audit);

/// Fits every form of every single effect, keeps the best form of each, best score first.
std::vector<Attribution> fit_singles(const Fit& fit, const std::vector<Candidate>& candidates);

/// Fits pairs: each of the best `partners` singles with every other effect, and the members of the best pair with every
/// other effect; best score first.
std::vector<Attribution> fit_pairs(const Fit& fit, const std::vector<Attribution>& singles, std::size_t partners);

/// Of the leading singles in a form that two others come near together (EffectForm::parts), those two from the numbers
/// of the one, carried through all levels. What looks like such a form may be both, and no part alone leads there.
std::vector<Attribution> fit_parts(const Fit& fit, const std::vector<Attribution>& singles);

/// Backward elimination: each member of the best pair refitted alone, from the numbers that it has in the pair, takes
/// the place of the same effect among the singles where it is better. A search that starts from nothing may have missed
/// what the pair found, and the partner then only makes up for the start.
void fit_members_alone(const Fit& fit, std::vector<Attribution>& singles, const std::vector<Attribution>& pairs);

/// Score, explained part and acceptance from the evaluations.
void judge(Attribution& attribution, const Nominal& nominal);

/// Misfit averaged over levels and records; what is below the floor is noise and counts as one.
double mean_log_misfit(const std::array<Evaluation, levels.size()>& evaluations);
/// The same without that: minus twice the log likelihood a reading of white innovations whose variance is unknown, up
/// to a constant. Rivals that both explain to within noise are distinguished by it, a floor that is too high or not.
double mean_log_square(const std::array<Evaluation, levels.size()>& evaluations);

}  // namespace stickslip::gap
