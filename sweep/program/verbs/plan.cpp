// stickslip plan: before measuring, what a motion can show of a joint and what it cannot distinguish.
#include "sweep/study/plan.h"

#include "analysis/results/text.h"
#include "sweep/files/json/verdict_json.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/series_file.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/number_option.h"
#include "sweep/program/verbs/parallel.h"
#include "sweep/program/verbs/verbs.h"
#include "sweep/words/effect_words.h"
#include "sweep/words/experiment_text.h"
#include "sweep/words/plain_text.h"
#include "sweep/words/refusal_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

namespace stickslip {
namespace {

struct Options {
    std::string joint, trajectory, directory;
    int threads = 0;
    bool json = false;
};

Json power_json(const gap::Power& power)
{
    Json json = {{"effects", Json::array()}, {"inseparable", Json::array()}};
    for (const auto& e : power.effects)
        json["effects"].push_back({{"name", e.name},
                                   {"least_size", json_number(e.least_size)},
                                   {"unit", e.unit},
                                   {"parameter", e.name + "." + e.parameter}});
    for (const auto& [one, other] : power.inseparable) json["inseparable"].push_back({one, other});
    return json;
}

void write_motion(const std::filesystem::path& file, const gap::SafeMotion& motion)
{
    std::string text = "time,reference_position\n";
    for (std::size_t k = 0; k < motion.time.size(); ++k)
        text += fmt::format("{},{}\n", motion.time[k], motion.position[k]);
    write_whole(file, text);
}

/// "333 µN·m  (amplitude)"
std::string size_text(const gap::EffectPower& e)
{
    const ScaledUnit unit = scaled_unit(std::abs(e.least_size), e.unit == "1" ? "" : e.unit);
    std::string parameter = e.parameter;
    std::ranges::replace(parameter, '_', ' ');
    return plain_text(plain_number(e.least_size / unit.size)) + (unit.text.empty() ? "" : " " + unit.text) + "  (" +
           parameter + ")";
}

void print(const gap::Power& power)
{
    fmt::print("least size that the diagnosis finds in this motion; of a stiffness or a limit the largest\n");
    for (const auto& e : power.effects)
        fmt::print("  {:<30} {}\n", effect_words(e.name), is_set(e.least_size) ? size_text(e) : "not to be found");
    for (const auto& [one, other] : power.inseparable)
        fmt::print("  {} and {} cannot be distinguished by it\n", effect_words(one), effect_words(other));
}

int run(const Options& options)
{
    const Joint joint = read_joint(options.joint);
    const TimeSeries reference =
        read_series(options.trajectory, "reference_position", SeriesQuantity{Quantity::position, units_of(joint)});
    const ThreadLimit limit(options.threads);
    const PlanAnswer answer = [&] {
        try {
            return plan(joint, reference.time, reference.value, !options.directory.empty(), parallel_for_each);
        } catch (const std::invalid_argument& e) {
            throw BadInput(options.joint + ": " + refusal_text(e));
        }
    }();
    Json json = {{"format", "stickslip-plan/1"}};
    json.update(power_json(answer.power));
    if (answer.better) {
        json["better_motion"] = {{"description", motion_text(answer.better->kind)}, {"file", "next-motion.csv"}};
        json["better_motion"].update(power_json(answer.of_better));
    }
    if (!options.directory.empty()) {
        const std::filesystem::path directory = options.directory;
        write_whole(directory / "plan.json", json.dump(2) + "\n");
        std::filesystem::remove(directory / "next-motion.csv");
        if (answer.better) write_motion(directory / "next-motion.csv", *answer.better);
    }
    if (options.json) {
        fmt::print("{}\n", json.dump(2));
        return exit_done;
    }
    print(answer.power);
    if (answer.better) fmt::print("a motion that shows more: {} (next-motion.csv)\n", motion_text(answer.better->kind));
    return exit_done;
}

}  // namespace

void add_plan(CommandLine& line, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto verb = line.add_verb("plan", "List, before measuring, the effects that a motion can show");
    verb.add_option("JOINT", options->joint, "nominal joint, TOML, with control.period and [sensor]")->required();
    verb.add_option("TRAJECTORY", options->trajectory, "CSV or .csv.gz with time and reference_position")->required();
    verb.add_option("-o,--output", options->directory,
                    "write plan.json here and search for a motion that distinguishes more (next-motion.csv)");
    add_threads(verb, options->threads, "number of threads; 0: all cores; the answer does not depend on it");
    verb.add_flag("--json", options->json, "print plan.json");
    verb.footer("Example: stickslip plan joint.toml trajectory.csv --json\nExit codes: 0 done, 2 bad input.");
    verb.callback([options, &invocation] { invocation.exit_code = run(*options); });
}

}  // namespace stickslip
