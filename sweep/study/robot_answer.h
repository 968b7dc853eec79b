// What a diagnosis of all joints of a robot found: each joint's answer, or why there is none.
#pragma once
#include "analysis/results/diagnosis.h"

#include <string>
#include <vector>

namespace stickslip {

struct JointOutcome {
    enum class Status { diagnosed, refused, not_reached };

    std::string name;
    std::string file;  ///< its joint file
    Status status = Status::not_reached;
    std::vector<std::string> problems;  ///< refused: what is wrong with its file or its records
    Diagnosis diagnosis;                ///< diagnosed only
    bool contradicted = false;          ///< diagnosed: records and joint are in different units
    bool corrected = false;             ///< corrected-joint.toml stands in its folder
    bool lacks_gains = false;           ///< its page was interrupted while the right gains were searched

    /// A search that was ended early names no cause, and that is no finding.
    bool ended_early() const
    {
        return status == Status::diagnosed && diagnosis.interrupted && diagnosis.verdict == Verdict::unknown;
    }
    bool differs() const
    {
        return status == Status::diagnosed && !ended_early() &&
               (diagnosis.verdict == Verdict::gap || diagnosis.verdict == Verdict::unknown);
    }
};

struct RobotAnswer {
    std::string title;
    std::vector<JointOutcome> joints;  ///< in the order of the robot's file
    bool interrupted = false;
};

/// "diagnosed", "refused" or "not-reached".
std::string name_of(JointOutcome::Status status);

/// A cause, or a few that act together, and what it takes of the joint's gap.
struct CauseShare {
    std::vector<std::string> names;
    double share = 0;  ///< of the squares beyond the noise on held-out data
    ConfidenceInterval interval;
    double probability = 0;
    std::vector<FittedParameter> parameters;
};

/// What a diagnosis names, the largest rung first as the ladder has it; nothing where it names nothing.
std::vector<CauseShare> named_causes(const Diagnosis& d);

}  // namespace stickslip
