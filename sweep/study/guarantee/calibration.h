// Answered cases whose causes are known, and what they promise for joints like theirs.
#pragma once
#include "analysis/results/cause_set.h"
#include "sweep/study/guarantee/nonconformity.h"
#include "sweep/study/guarantee/place.h"

#include <map>
#include <string>
#include <vector>

namespace stickslip::guarantee {

/// One case: what was put in, what was answered, and what joint and records are.
struct CalibrationCase {
    std::string name;  ///< the same case has the same name in every file
    blind::Truth truth;
    blind::Answer answer;
    Place place;
};

struct Calibration {
    std::string method;                    ///< hash of the sources that answered: the promise is about their answers
    std::vector<std::string> populations;  ///< how the cases were drawn, those of merged calibrations each once
    std::string joint;                     ///< hash of the one joint that the cases are of; empty: of many
    std::vector<CalibrationCase> cases;

    /// All of them in one line.
    std::string population() const;
};

/// Adds the cases of another calibration; those that both have count once. Throws std::invalid_argument where method or
/// joint differ, or where one name has two answers.
void merge(Calibration& into, const Calibration& other);

/// From which score on a cause is excluded.
struct Promise {
    double coverage = 0, confidence = 0;
    CauseSet::Holds holds = CauseSet::Holds::population;
    double threshold = 0;                      ///< of all cases; population
    std::map<std::string, double> thresholds;  ///< of every cause; every_cause. Infinite: too few cases
    int cases = 0;
    int needed = 0;                       ///< cases, of a cause or in all
    std::map<std::string, int> cases_of;  ///< in which each cause acts
    bool kept = false;                    ///< there are enough cases for a promise

    /// What this cause may score at most to stay possible.
    double limit(const std::string& cause) const;
};

/// For every cause where each cause of the population has enough cases, else over the population where all together are
/// enough, else none.
Promise promise_of(const Calibration& calibration, double coverage, double confidence = 0.95);

/// The causes that the promise leaves for an answer. `catalogue`: the effects that this joint could have.
CauseSet set_of(const blind::Answer& answer, const Promise& promise, const Calibration& calibration,
                const std::vector<std::string>& catalogue);

/// Whether the set holds every cause that was put into a case, by its name or one of the very same motion.
bool holds(const CauseSet& set, const blind::Truth& truth);

}  // namespace stickslip::guarantee
