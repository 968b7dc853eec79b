#include "sweep/files/records/joint_log.h"

#include "sweep/files/records/foreign_log.h"
#include "sweep/files/records/joint_columns.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/toml_input.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace stickslip {
namespace {

/// The robot's layout, then the joint's, then that of record.toml beside the record: later ones win.
RecordLayout layout_of(const std::filesystem::path& record, const LoggedJoint& wanted, const Joint& joint)
{
    RecordLayout layout;
    if (!wanted.robot_file.empty()) layout = read_record_layout(wanted.robot_file, joint);
    for (auto& rule : record_layout_for(record, wanted.joint_file, joint).rules)
        layout.rules.push_back(std::move(rule));
    return layout_for_joint(std::move(layout), wanted.name);
}

JointLog from_table(const std::filesystem::path& table, const LoggedJoint& wanted, const Joint& joint)
{
    const auto columns = joint_columns(table, wanted.name, layout_of(table, wanted, joint));
    JointLog log;
    if (columns.present)
        log.records.push_back(read_record(table, joint, columns.layout));
    else if (columns.joints.empty())
        log.absent = table.string() + ": names no joints: expected columns such as " + wanted.name +
                     "_position, or [record.columns] that say which are whose";
    else
        log.absent = table.string() + ": has no joint " + wanted.name + ", it has " + files::listed(columns.joints) +
                     files::did_you_mean(wanted.name, columns.joints);
    return log;
}

/// Tables of a folder that belong to the joint; `others` is what else is there.
std::vector<std::filesystem::path> tables_of(const std::filesystem::path& folder, const std::string& name,
                                             std::vector<std::string>& others)
{
    std::vector<std::filesystem::path> own;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const auto& path = entry.path();
        std::string stem = path.filename().string();
        for (const char* ending : {".gz", ".csv"})
            if (!entry.is_directory() && stem.ends_with(ending)) stem.resize(stem.size() - std::string(ending).size());
        if (entry.is_directory() && stem == name) {
            for (const auto& inner : std::filesystem::directory_iterator(path))
                if (is_table(inner.path())) own.push_back(inner.path());
        } else if (is_table(path) && stem == name) {
            own.push_back(path);
        } else if (entry.is_directory() || is_table(path)) {
            others.push_back(stem);
        }
    }
    std::sort(own.begin(), own.end());
    std::sort(others.begin(), others.end());
    return own;
}

JointLog from_folder(const std::filesystem::path& folder, const LoggedJoint& wanted, const Joint& joint)
{
    JointLog log;
    std::vector<std::string> others;
    for (const auto& table : tables_of(folder, wanted.name, others))
        log.records.push_back(read_record(table, joint, layout_of(table, wanted, joint)));
    if (log.records.empty())
        log.absent = folder.string() + ": has no " + wanted.name + ".csv, it has " +
                     (others.empty() ? "no tables" : files::listed(others)) + files::did_you_mean(wanted.name, others);
    return log;
}

}  // namespace

bool is_table(const std::filesystem::path& file)
{
    const std::string name = file.filename().string();
    return name.ends_with(".csv") || name.ends_with(".csv.gz");
}

bool is_folder_of_a_log(const std::filesystem::path& folder)
{
    return std::filesystem::exists(folder / "joint_list.txt") || std::filesystem::exists(folder / "metadata.yaml");
}

bool is_foreign_log(const std::filesystem::path& log)
{
    std::string ending = log.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    constexpr std::array<std::string_view, 10> known{".mcap", ".db3", ".bag", ".parquet", ".json",
                                                     ".npz",  ".mat", ".h5",  ".hdf5",    ".nc"};
    return std::filesystem::is_directory(log) || std::find(known.begin(), known.end(), ending) != known.end();
}

std::string name_of_log(const std::filesystem::path& log)
{
    return (log.has_filename() ? log : log.parent_path()).filename().string();
}

JointLog read_joint_log(const std::filesystem::path& log, const LoggedJoint& wanted, const Joint& joint,
                        const LogOptions& options)
{
    if (!std::filesystem::exists(log)) throw BadInput(log.string() + ": there is no such file");
    if (!is_foreign_log(log)) return from_table(log, wanted, joint);
    if (std::filesystem::is_directory(log) && !is_folder_of_a_log(log)) return from_folder(log, wanted, joint);
    const ForeignLog converted(log, wanted.name, options);
    JointLog read;
    try {
        read.records.push_back(read_record(converted.table(), joint, layout_of(converted.table(), wanted, joint)));
    } catch (const BadInput& e) {
        throw BadInput(converted.as_of_the_log(e.messages()));
    }
    RecordReading& reading = read.records.back();
    reading.record.name = name_of_log(log);
    if (!reading.no_position.empty()) reading.no_position = converted.as_of_the_log({reading.no_position}).front();
    reading.guesses = converted.guesses();
    return read;
}

}  // namespace stickslip
