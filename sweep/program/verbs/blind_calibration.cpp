#include "sweep/program/verbs/blind_calibration.h"

#include "sweep/engine/build.h"
#include "sweep/files/json/calibration_json.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/program/verbs/gather_records.h"
#include "sweep/program/verbs/guarantee_option.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace stickslip {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> records_of(const fs::path& folder)
{
    std::vector<std::string> files;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const auto name = entry.path().filename().string();
        if (name.ends_with(".csv") || name.ends_with(".csv.gz")) files.push_back(entry.path().string());
    }
    std::ranges::sort(files);
    return files;
}

std::string hash_of_files(const std::vector<std::string>& files)
{
    std::string bytes;
    for (const auto& file : files) {
        std::ifstream in(file, std::ios::binary);
        bytes.append(std::istreambuf_iterator<char>(in), {});
    }
    return fmt::format("{:016x}", XXH3_64bits(bytes.data(), bytes.size()));
}

}  // namespace

void write_calibration(const fs::path& file, const std::string& population, const std::vector<fs::path>& cases,
                       const std::map<std::string, blind::Answer>& answers,
                       const std::map<std::string, blind::Truth>& truths)
{
    guarantee::Calibration calibration{method_hash(), {population}, "", {}};
    for (const auto& folder : cases) {
        const auto name = folder.filename().string();
        const auto answer = answers.find(name);
        const auto truth = truths.find(name);
        if (answer == answers.end() || truth == truths.end()) continue;
        auto files = records_of(folder);
        const auto joint_file = (folder / "joint.toml").string();
        const Joint joint = read_joint(joint_file);
        const auto given = gather_records(files, {joint_file, "", {}}, joint);
        files.push_back(joint_file);
        calibration.cases.push_back(
            {hash_of_files(files), truth->second, answer->second, place_among(joint, given.records)});
    }
    write_whole(file, calibration_json(calibration));
}

}  // namespace stickslip
