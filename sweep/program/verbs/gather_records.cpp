#include "sweep/program/verbs/gather_records.h"

#include "sweep/files/text/bad_input.h"

#include <algorithm>
#include <filesystem>

namespace stickslip {
namespace {

/// Two records of one name are distinguished by their folders.
void name_by_path(RecordReading& reading, const std::string& file, const std::vector<std::string>& files)
{
    const std::string name = reading.record.name;
    const auto same = [&](const std::string& other) { return std::filesystem::path(other).filename() == name; };
    if (std::count_if(files.begin(), files.end(), same) >= 2) reading.record.name = file;
}

/// The records of one joint in a file: itself, or those of the joint that is named in a log of several.
std::vector<RecordReading> readings_of(const std::string& file, const RecordsQuestion& question, const Joint& joint)
{
    if (question.name.empty() && !is_foreign_log(file)) {
        std::vector<RecordReading> one;
        one.push_back(read_record(file, joint, record_layout_for(file, question.joint_file, joint)));
        return one;
    }
    auto log = read_joint_log(file, {question.name, question.joint_file, {}}, joint, question.how);
    if (log.records.empty()) throw BadInput(log.absent);
    return std::move(log.records);
}

}  // namespace

void refuse_twice(const std::vector<std::string>& files)
{
    for (std::size_t i = 0; i < files.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            std::error_code failed;  // reading says so
            if (std::filesystem::equivalent(files[i], files[j], failed))
                throw BadInput(files[i] + ": is given twice, expected every record once");
        }
}

GatheredRecords gather_records(const std::vector<std::string>& files, const RecordsQuestion& question,
                               const Joint& joint)
{
    refuse_twice(files);
    GatheredRecords given;
    for (const auto& file : files)
        for (auto& reading : readings_of(file, question, joint)) {
            name_by_path(reading, file, files);
            given.add(std::move(reading));
        }
    return given;
}

}  // namespace stickslip
