// Diagnoses blind cases and prints, one line of JSON each, the answer and what every threshold of the policy was
// compared with: thresholds [NAME=VALUE...] [seconds=S] CASE... A case is a folder with joint.toml and records.
// Thresholds with a value are changed. A case that takes more seconds of a processor ends as "unfinished", with what
// was compared until then.
#include "analysis/diagnosis/diagnose.h"
#include "analysis/diagnosis/plant/record_form.h"
#include "sweep/files/records/record_file.h"
#include "sweep/files/toml/joint_file.h"
#include "tests/evidence/change.h"
#include "tests/evidence/comparisons.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace stickslip;
using Json = nlohmann::ordered_json;

bool is_record(const std::filesystem::path& file)
{
    return file.extension() == ".csv" || file.string().ends_with(".csv.gz");
}

struct TakesLonger {};

double processor_seconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

Json line_of(const std::filesystem::path& folder, std::string_view verdict)
{
    return {{"case", folder.filename().string()}, {"verdict", verdict}, {"effects", Json::array()}};
}

Json diagnosed(const std::filesystem::path& folder, double seconds)
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
    const double end = processor_seconds() + seconds;
    const auto one_after_the_other = [&](std::size_t n, const std::function<void(std::size_t)>& task) {
        for (std::size_t i = 0; i < n; ++i) {
            if (processor_seconds() > end) throw TakesLonger{};
            task(i);
        }
    };
    const auto d = gap::diagnose(joint, records, one_after_the_other).diagnosis;
    Json line = line_of(folder, name_of(d.verdict));
    for (const auto& cause : d.effects) line["effects"].push_back({cause.names, cause.probability});
    return line;
}

}  // namespace

int main(int count, char** words)
{
    int failed = 0;
    double seconds = std::numeric_limits<double>::infinity();
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        try {
            if (word.starts_with("seconds=")) {
                seconds = std::stod(word.substr(word.find('=') + 1));
                continue;
            }
            if (word.find('=') != std::string::npos) {
                evidence::change(word);
                continue;
            }
            Json line;
            try {
                line = diagnosed(word, seconds);
            } catch (const TakesLonger&) {
                line = line_of(word, "unfinished");
            }
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
