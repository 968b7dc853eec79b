// A candidate's parameters to be fitted, and the two ways to fit them.
#pragma once
#include "analysis/diagnosis/fit/side_by_side.h"

namespace stickslip::gap {

/// What a fit minimises: the misfit of a candidate in these records, with parameters in these units, at one bandwidth
/// of the observer, rad/s. A view: what it is made of has to outlive it.
struct FitProblem {
    const std::vector<Case>& cases;
    const Candidate& candidate;
    const Scales& scales;
    double omega;

    std::vector<double> si(const Eigen::VectorXd& x) const { return in_si(candidate, x, scales); }
    /// The misfit, without what priors add.
    Evaluation at(const Eigen::VectorXd& x, std::vector<double>* residuals = nullptr) const
    {
        return evaluate(cases, candidate, si(x), omega, residuals);
    }
    FitProblem with_bandwidth(double other) const { return {cases, candidate, scales, other}; }
};

struct LevelFit {
    Eigen::VectorXd x;
    Evaluation evaluation;
    Eigen::MatrixXd information;  ///< JᵀWJ of the scaled residuals at x; zero for parameters that were kept
    int evaluations = 0;
};

/// One entry a parameter: 1 keeps its value. Empty: all are fitted.
using Kept = std::vector<char>;

/// Levenberg-Marquardt from x. NLopt has no least-squares method; this one needs a third of its evaluations here, and
/// gives the information matrix.
LevelFit descend(const FitProblem& problem, Eigen::VectorXd x, int iterations, const Kept& kept = {});
Fitting<LevelFit> descending(FitProblem problem, Eigen::VectorXd x, int iterations, Kept kept = {});

/// NLopt's Nelder-Mead from x, for misfits without usable gradients (backlash, saturation). The first step is in
/// logarithms or in parts of what is usual.
LevelFit search_rough(const FitProblem& problem, Eigen::VectorXd x, int evaluations, double first_step = 0.3,
                      const Kept& kept = {});
Fitting<LevelFit> searching_rough(FitProblem problem, Eigen::VectorXd x, int evaluations, double first_step = 0.3,
                                  Kept kept = {});

}  // namespace stickslip::gap
