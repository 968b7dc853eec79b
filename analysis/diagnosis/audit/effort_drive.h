// Logs without a command: whether the measured effort drives the joint, in place of a controller that did not run.
#pragma once
#include "analysis/diagnosis/audit/audit.h"
#include "analysis/diagnosis/records/record.h"
#include "analysis/joint/joint.h"
#include "analysis/results/note.h"

#include <vector>

namespace stickslip::gap {

/// The record with its current turned into an effort where a motor is documented and no effort was logged.
Record with_effort_of_current(Record record, const Joint& joint);

/// How well controllers make the measured effort out of the logged reference and motion, as parts of its squares.
struct EffortOfController {
    bool judged = false;       ///< enough rows are known not to be at a limit
    double as_documented = 1;  ///< left by the documented controller as it is
    double left = 1;      ///< by its structure: its own effort and its terms with free gains, up to a few rows late
    double left_pid = 1;  ///< by a PID and a constant
    double left_fed = 1;  ///< by its structure beside a feed-forward of acceleration and Coulomb friction
    double k_p = 0, k_v = 0, k_i = 0;  ///< of that PID, effort per error, per rate and per integral
    bool velocity_logged = false;      ///< not made of differences of the position
    std::vector<double> error{};       ///< measured less documented effort, row by row

    /// Gains, limits, delays and a feed-forward that differ leave it the controller of the document.
    bool documented_one() const;
};
EffortOfController effort_of_controller(const Record& record, const Joint& joint);

/// Records whose measured effort drives the joint, and what the controllers of those with a reference would have done;
/// an empty entry for those without.
struct EffortDrive {
    std::vector<EffortOfController> controllers;
};

/// Of records that hold no command: where the controller of the file makes the measured effort in none of them,
/// whatever its gains, the effort itself has to drive the joint, and the references are removed. `notes` says so.
EffortDrive drive_by_effort(std::vector<Record>& records, const Joint& nominal, std::vector<Note>& notes);

/// Hands the controller's errors to the cases, and names an integral that the file lacks, and gains that differ, where
/// a PID makes the effort in every record with the same integral; else the reasons say that another controller ran.
void audit_effort(const EffortDrive& drive, std::vector<Case>& cases, Audit& audit, std::vector<Note>& reasons);

/// The joint behind its measured effort: no actuator, and no dead time but that of the sensor.
Joint behind_its_effort(Joint joint);

}  // namespace stickslip::gap
