// Every reduction that a joint allows, each with the boundary before and after it, and where its assumption breaks.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "analysis/joint/reduction.h"
#include "analysis/results/point.h"
#include "analysis/stability/reduction_error.h"

namespace stickslip {

/// A reduction, single step or chain, with what it assumes large and the number whose boundary it is compared along.
struct NamedReduction {
    std::function<Reduction(const Joint&)> reduce;
    std::string boundary_path, assumption_path, assumption;  ///< as in ReductionStudy
    std::string steps;                                       ///< "Fig. 5 to 6, transmission at the motor"
};

/// Every reduction of Figs. 4 → 5 → 6 → 7 that starts from a joint of this model; none for a single mass. A reduction
/// may still refuse the joint (std::invalid_argument).
std::vector<NamedReduction> reductions_of(const Joint& joint);

/// One reduction of one joint along the number that its assumption is about: the boundary of the full joint and of the
/// reduced one at each value.
struct ReductionStudy {
    std::string name;                    ///< "three masses to one, ideal motor … (Fig. 5 to 7a)"
    std::string model;                   ///< short: "Fig. 6, transmission at the motor, then Fig. 7a, ideal motor"
    std::vector<std::string> neglected;  ///< half sentences, mark-up
    std::string refused;                 ///< why the reduction does not apply; all below is empty then
    bool unsearched = false;             ///< it would take more than the usual effort; likewise
    std::string boundary_path;           ///< the number whose boundary is compared: "control.k_p"
    std::string assumption_path;         ///< the number that is assumed large; empty for an exact reduction
    std::string assumption;              ///< mark-up: "k_{tr} ≫ k_{p}"
    ReductionError own;                  ///< at the joint's own value of the assumption's number
    double searched_low = missing, searched_high = missing;  ///< for boundaries, of the number at boundary_path
    std::vector<double> values;                              ///< of the assumption's number, ascending
    std::vector<ReductionError> at;                          ///< one a value
    /// Above this value of the assumption's number the error stays within 1 % and 10 %; NaN where it never does.
    double good_from = missing, fair_from = missing;

    bool compared() const { return refused.empty() && !unsearched; }
};

struct StudyOptions {
    double decades = 2;           ///< how far the assumption's number moves to either side of its own value
    int values = 33;              ///< steps of it
    int refinements = 3;          ///< how often steps are halved where a boundary moves far, begins or ends
    double boundary_decades = 3;  ///< how far the boundary is searched to either side of its own value
    double far_decades = 9;       ///< the same where neither joint has one nearer
    int scan = 48;
};

/// Studies of every reduction of Figs. 4 → 5 → 6 → 7 that starts from this joint, single steps and chains; none for a
/// single mass. Both verdicts are those of friction with memory.
std::vector<ReductionStudy> reduction_studies(const Joint& joint, const StudyOptions& options = {});

}  // namespace stickslip
