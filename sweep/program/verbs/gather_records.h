// The records of one joint out of the files that a verb was given.
#pragma once
#include "sweep/files/records/joint_log.h"
#include "sweep/program/verbs/diagnose_joint.h"

#include <string>
#include <vector>

namespace stickslip {

struct RecordsQuestion {
    std::string joint_file;
    std::string name;  ///< of the joint in logs of several; may be empty
    LogOptions how;
};

/// Throws BadInput, also for a file that is given twice.
GatheredRecords gather_records(const std::vector<std::string>& files, const RecordsQuestion& question,
                               const Joint& joint);

/// The same file twice would be held out of a fit to itself.
void refuse_twice(const std::vector<std::string>& files);

}  // namespace stickslip
