#include "sweep/program/verbs/diagnose_robot.h"

#include "sweep/engine/build.h"
#include "sweep/files/json/robot_json.h"
#include "sweep/files/robots/robot_joints.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/names.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/program/verbs/diagnose_joint.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/parallel.h"
#include "sweep/program/verbs/say.h"
#include "sweep/program/verbs/terminal.h"
#include "sweep/report/pages/robot_report.h"
#include "sweep/report/write_robot_report.h"
#include "sweep/words/robot_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace stickslip {
namespace {

using Status = JointOutcome::Status;

/// The requested ones, in the order of the file.
std::vector<RobotJointFile> chosen(const RobotJoints& robot, const std::vector<std::string>& only)
{
    std::vector<std::string> names;
    for (const auto& joint : robot.joints) names.push_back(joint.name);
    for (const auto& name : only)
        if (std::find(names.begin(), names.end(), name) == names.end())
            throw BadInput(robot.source.string() + ": has no joint " + name + ", it has " + files::listed(names) +
                           files::did_you_mean(name, names));
    std::vector<RobotJointFile> joints;
    for (const auto& joint : robot.joints)
        if (only.empty() || std::find(only.begin(), only.end(), joint.name) != only.end()) joints.push_back(joint);
    return joints;
}

/// The joint's records from every log. A log without it is a note, all logs without it are an error.
GatheredRecords gathered(const RobotQuestion& question, const LoggedJoint& wanted, const Joint& joint)
{
    GatheredRecords given;
    std::vector<std::string> absent;
    for (const auto& file : question.logs) {
        auto log = read_joint_log(file, wanted, joint, question.how);
        if (log.records.empty()) absent.push_back(log.absent);
        for (auto& reading : log.records) {
            const auto same = [&](const Record& other) { return other.name == reading.record.name; };
            if (std::any_of(given.records.begin(), given.records.end(), same)) reading.record.name = file;
            given.add(std::move(reading));
        }
    }
    if (given.records.empty()) throw BadInput(absent);
    for (const auto& text : absent) given.warnings.push_back({.text = text});
    return given;
}

/// Reads, diagnoses and writes one joint; what is wrong with its input stands in the outcome.
JointOutcome outcome_of(const RobotQuestion& question, const RobotJoints& robot, const RobotJointFile& asked,
                        const std::string& about, const Invocation& invocation)
{
    JointOutcome outcome;
    outcome.name = asked.name;
    outcome.file = asked.file.string();
    const auto folder = std::filesystem::path(question.directory) / asked.name;
    try {
        const Joint joint = read_joint(asked.file);
        const LoggedJoint wanted{asked.in_log, asked.file, robot.has_record ? robot.source : std::filesystem::path()};
        const auto given = gathered(question, wanted, joint);
        StageLine line;
        const auto found = diagnose_joint(joint, given, invocation, line, about);
        outcome.lacks_gains = !write_joint_diagnosis(
            found, folder, invocation, !question.no_report,
            {asked.name, robot.title.empty() ? "All joints of the robot" : robot.title, "../robot.html"});
        outcome.status = Status::diagnosed;
        outcome.diagnosis = found.diagnosis;
        outcome.diagnosis.traces.clear();  // they stand on the joint's page
        outcome.contradicted = found.contradicted;
        outcome.corrected = std::filesystem::exists(folder / "corrected-joint.toml");
    } catch (const BadInput& e) {
        outcome.status = Status::refused;
        outcome.problems = e.messages();
        remove_earlier(folder);
        std::filesystem::remove(folder / "diagnosis.json");
    }
    return outcome;
}

void say_outcome(const JointOutcome& joint, const RobotQuestion& question)
{
    for (const auto& problem : joint.problems) say("{}: {}\n", joint.name, problem);
    if (question.json || joint.status != Status::diagnosed) return;
    const bool named = joint.diagnosis.verdict == Verdict::gap;
    fmt::print("{}: {}{}{}\n", joint.name, outcome_words(joint), named ? ": " : "",
               named ? causes_words(joint.diagnosis) : "");
    std::fflush(stdout);
}

int exit_code_of(const RobotAnswer& robot)
{
    if (robot.interrupted) return exit_interrupted;
    const auto any = [&](auto&& among) { return std::any_of(robot.joints.begin(), robot.joints.end(), among); };
    if (any([](const auto& j) { return j.status == Status::refused || j.contradicted; })) return exit_bad_input;
    return any([](const auto& j) { return j.diagnosis.verdict == Verdict::insufficient_data; }) ? exit_insufficient
                                                                                                : exit_done;
}

}  // namespace

int diagnose_robot(const RobotQuestion& question, const Invocation& invocation)
{
    const auto robot = read_robot_joints(question.robot);
    const auto joints = chosen(robot, question.only);
    const auto directory = answer_folder(question.directory);
    for (const char* name : {"robot.json", "robot.html"}) std::filesystem::remove(directory / name);
    const ThreadLimit limit(question.threads);
    RobotAnswer answer;
    answer.title = robot.title;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (invocation.interrupted) {
            answer.joints.push_back({joints[i].name, joints[i].file.string()});
            continue;
        }
        const auto about = fmt::format("{}, joint {} of {}: ", joints[i].name, i + 1, joints.size());
        answer.joints.push_back(outcome_of(question, robot, joints[i], about, invocation));
        // readers of foreign logs are interrupted with the program: what they then say is no fault of the log
        if (invocation.interrupted && answer.joints.back().status == Status::refused)
            answer.joints.back() = {joints[i].name, joints[i].file.string()};
        say_outcome(answer.joints.back(), question);
    }
    // an interruption that comes when all are answered takes nothing from them
    answer.interrupted = std::ranges::any_of(answer.joints, [](const JointOutcome& joint) {
        return joint.status == Status::not_reached || joint.diagnosis.interrupted || joint.lacks_gains;
    });
    const auto json = robot_json(answer, !question.no_report).dump(2) + "\n";
    write_whole(directory / "robot.json", json);
    const std::vector<std::pair<std::string, std::string>> provenance{{"version", program_version()},
                                                                      {"command", invocation.command}};
    if (!question.no_report) write_robot_report(robot_report(answer, provenance), directory);
    if (question.json) {
        fmt::print("{}", json);
    } else {
        print_sentence(robot_sentence(answer));
        fmt::print("robot:     {}\n", (directory / "robot.json").string());
        if (!question.no_report) fmt::print("page:      {}\n", (directory / "robot.html").string());
    }
    return exit_code_of(answer);
}

}  // namespace stickslip
