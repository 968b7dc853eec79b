#include "sweep/program/verbs/held_answer.h"

#include "sweep/engine/run_directory.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <string_view>
#include <vector>

namespace stickslip {
namespace {

namespace fs = std::filesystem;

/// An answer that a verb writes into the folder of its -o, by the name in its `format`.
struct StoredAnswer {
    std::string_view name, command;
    std::string_view page = "report.html";  ///< empty: it has none
};
constexpr StoredAnswer stored_answers[] = {
    {"boundary", "boundary"},  {"margins", "margins"},
    {"design", "design"},      {"set-point-design", "design --set-point"},
    {"motion", "simulate"},    {"robot-diagnosis", "diagnose --all-joints", "robot.html"},
    {"diagnosis", "diagnose"}, {"comparison", "compare"},
    {"gap-check", "check"},    {"timeline", "timeline"},
    {"plan", "plan", ""},
};

/// "diagnosis" of "stickslip-diagnosis/2"; nothing of a file that is no answer of ours.
std::string format_name(const fs::path& file)
{
    constexpr std::string_view ours = "stickslip-";
    std::ifstream in(file);
    const auto json = nlohmann::json::parse(in, nullptr, false);
    if (!json.is_object() || !json.contains("format") || !json["format"].is_string()) return "";
    const auto format = json["format"].get<std::string>();
    if (!format.starts_with(ours)) return "";
    return format.substr(ours.size(), format.find('/') - ours.size());
}

std::string of_answer(const fs::path& folder, const fs::path& file, const StoredAnswer& answer)
{
    std::string text = fmt::format("{}: holds {} of `stickslip {}`, not a sweep", folder.string(),
                                   file.filename().string(), answer.command);
    if (answer.page.empty()) return text + "; it has no page";
    const auto page = folder / answer.page;
    if (fs::exists(page)) return text + fmt::format("; its page is {}, which that command draws", page.string());
    return text + fmt::format("; that command draws its page, {}, when it runs again", page.string());
}

}  // namespace

std::string instead_of_a_sweep(const fs::path& folder)
{
    std::error_code failed;
    if (fs::is_regular_file(folder, failed)) return folder.string() + ": is a file, expected the folder of a sweep";
    if (!fs::is_directory(folder, failed)) return folder.string() + ": there is no such folder";
    if (fs::exists(folder / run_files::journals, failed))
        return fmt::format(
            "{0}: holds a sweep that is not finished; the same stickslip sweep SPEC -o {0} continues it, and stickslip "
            "merge {0} joins its shards",
            folder.string());
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder, failed))
        if (entry.path().extension() == ".json" && entry.is_regular_file(failed)) files.push_back(entry.path());
    std::ranges::sort(files);
    for (const auto& answer : stored_answers)
        for (const auto& file : files)
            if (format_name(file) == answer.name) return of_answer(folder, file, answer);
    if (const auto page = folder / "report.html"; fs::exists(page, failed))
        return fmt::format("{}: holds a page, {}, and no sweep (results.nc) to draw another from", folder.string(),
                           page.string());
    return fmt::format("{0}: holds no finished sweep (results.nc); make one with: stickslip sweep SPEC -o {0}",
                       folder.string());
}

}  // namespace stickslip
