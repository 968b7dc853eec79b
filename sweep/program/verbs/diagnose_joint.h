// One joint's diagnosis: from its records to the files of its answer. Shared by the verb for one joint and for a robot.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/diagnosis.h"
#include "sweep/files/records/record_file.h"
#include "sweep/program/verbs/stage_line.h"
#include "sweep/program/verbs/verbs.h"
#include "sweep/study/diagnose.h"

#include <filesystem>
#include <string>
#include <vector>

namespace stickslip {

/// Records of one joint, and what reading them said.
struct GatheredRecords {
    std::vector<Record> records;
    std::vector<Note> warnings, contradictions;
    std::vector<std::string> gaps;

    void add(RecordReading reading);
};

/// Throws BadInput, which names the joint's file, for a law or a model that no record is fitted with.
void require_fitted(const Joint& joint, const GatheredRecords& records, const std::string& file);

/// Throws BadInput for records with gaps and for those that cannot be read as time series.
/// `about` is said before each stage.
JointDiagnosis diagnose_joint(const Joint& joint, const GatheredRecords& records, const Invocation& invocation,
                              StageLine& line, const std::string& about = "");

/// For the page of a joint that was diagnosed with its robot; empty otherwise.
struct JointOfRobot {
    std::string name, robot;
    std::string page;  ///< of the robot, from the joint's folder
};

/// diagnosis.json as text.
std::string joint_diagnosis_json(const JointDiagnosis& found);

/// diagnosis.json, corrected-joint.toml, next-experiment.csv and, where requested, the page; what an earlier answer
/// left there goes. False where an interruption ended the search for gains, which the page then lacks.
bool write_joint_diagnosis(const JointDiagnosis& found, const std::filesystem::path& directory,
                           const Invocation& invocation, bool page, const JointOfRobot& of = {});

/// The exit code of `diagnose`.
int exit_code_of(const Diagnosis& d, bool contradicted);

/// The folder of the answer, tried before the work and not after it.
std::filesystem::path answer_folder(const std::string& directory);

/// What an earlier answer left there would contradict this one.
void remove_earlier(const std::filesystem::path& directory);

}  // namespace stickslip
