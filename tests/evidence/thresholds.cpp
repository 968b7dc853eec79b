// Diagnoses blind cases and prints, one line of JSON each, the answer and what every threshold of the policy was
// compared with: thresholds [NAME=VALUE...] CASE... A case is a folder with joint.toml and records. Thresholds with a
// value are changed.
#include "analysis/diagnosis/diagnose.h"
#include "analysis/diagnosis/plant/record_form.h"
#include "sweep/files/records/record_file.h"
#include "sweep/files/toml/joint_file.h"
#include "tests/evidence/comparisons.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace stickslip;
using Json = nlohmann::ordered_json;

void change(const std::string& assignment)
{
    const auto equals = assignment.find('=');
    const std::string name = assignment.substr(0, equals);
    for (const auto& entry : gap::policy::entries) {
        if (name != entry.name || !entry.number) continue;
        entry.number->set(std::stod(assignment.substr(equals + 1)));
        gap::policy::ladder.prior = gap::policy::correction_prior;
        return;
    }
    throw std::invalid_argument(name + ": is no threshold that can be changed");
}

bool is_record(const std::filesystem::path& file)
{
    return file.extension() == ".csv" || file.string().ends_with(".csv.gz");
}

Json diagnosed(const std::filesystem::path& folder)
{
    const auto file = folder / "joint.toml";
    const Joint joint = gap::record_form(read_joint(file.string()));
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (is_record(entry.path())) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<Record> records;
    for (const auto& path : files)
        records.push_back(read_record(path, joint, record_layout_for(path, file, joint)).record);
    const auto one_after_the_other = [](std::size_t n, const std::function<void(std::size_t)>& task) {
        for (std::size_t i = 0; i < n; ++i) task(i);
    };
    const auto d = gap::diagnose(joint, records, one_after_the_other).diagnosis;
    Json line{{"case", folder.filename().string()}, {"verdict", name_of(d.verdict)}, {"effects", Json::array()}};
    for (const auto& cause : d.effects) line["effects"].push_back({cause.names, cause.probability});
    return line;
}

}  // namespace

int main(int count, char** words)
{
    int failed = 0;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        try {
            if (word.find('=') != std::string::npos) {
                change(word);
                continue;
            }
            Json line = diagnosed(word);
            line["thresholds"] = evidence::comparisons();
            std::printf("%s\n", line.dump().c_str());
            std::fflush(stdout);
        } catch (const std::exception& e) {
            std::fprintf(stderr, "%s: %s\n", word.c_str(), e.what());
            failed = 1;
        }
    }
    return failed;
}
