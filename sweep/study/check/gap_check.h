// Has the gap between a joint and its records become worse than it was in a baseline? Told from fresh noise.
#pragma once
#include "sweep/study/compare/compare_diagnoses.h"

#include <string>
#include <vector>

namespace stickslip {

struct GapTolerance {
    double number = 0.05;        ///< share by which a number of the joint may move
    double gap = 0.1;            ///< share by which the gap, as documented or with its cause, may grow
    double standard_errors = 5;  ///< below it no number has moved: noise does more once in two million times
};

struct GapRegression {
    enum class Kind {
        new_gap,       ///< there was none
        grown,         ///< the gap as documented
        remainder,     ///< what the named cause leaves has grown
        new_cause,     ///< a cause that was not there, and that is distinguished from the baseline's
        number_moved,  ///< a number of the joint
        no_answer      ///< the records say too little now, and did not then
    };
    Kind kind = Kind::new_gap;
    std::string name;  ///< of the cause or the number
    NumberChange number;
};

struct GapCheck {
    DiagnosisComparison comparison;
    GapTolerance tolerance;
    std::vector<GapRegression> regressions;
    std::vector<std::string> changed_joint;  ///< lines of the joint file that are not those of the baseline

    bool passes() const { return regressions.empty(); }
};

std::vector<GapRegression> gap_regressions(const DiagnosisComparison& comparison, const GapTolerance& tolerance);

}  // namespace stickslip
