#include "sweep/program/verbs/design_set_point.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <stdexcept>

#include "analysis/design/set_point_design.h"
#include "sweep/files/json/set_point_design_json.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/files/toml/asked_axes.h"
#include "sweep/files/toml/changed_lines.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/parallel.h"
#include "sweep/program/verbs/say.h"
#include "sweep/program/verbs/stage_line.h"
#include "sweep/program/verbs/stoppable.h"
#include "sweep/program/verbs/terminal.h"
#include "sweep/program/verbs/with_version.h"
#include "sweep/report/pages/set_point_design_report.h"
#include "sweep/report/write_report.h"
#include "sweep/study/set_point_scan.h"
#include "sweep/words/plain_text.h"
#include "sweep/words/set_point_design_text.h"

namespace stickslip {
namespace {

SetPointRequirements requirements_of(const SetPointOptions& options)
{
    SetPointRequirements r;
    r.friction_margin = options.friction_margin;
    r.k_i = options.integral_gain;
    r.push_speed = options.push_speed;
    if (options.over.empty()) return r;
    const auto asked = [&](const char* path) {
        return std::find(options.over.begin(), options.over.end(), path) != options.over.end();
    };
    r.over_k_i = asked("control.k_i");
    r.over_dead_zone = asked("control.dead_zone");
    r.over_push = asked("push");
    r.over_dither = asked("control.dither");
    return r;
}

}  // namespace

int design_set_point_answer(const SetPointOptions& options, Invocation& invocation)
{
    const auto joint = read_spec_or_joint(options.input, options.settings).design;
    const auto requirements = requirements_of(options);
    const ThreadLimit limit(options.threads);
    SetPointDesign design;
    std::optional<StageLine> line(std::in_place, "", std::chrono::seconds(1));
    line->stage("the least error at rest of each way to hold the set point");
    try {
        design = design_set_point(joint, requirements, parallel_for_each);
    } catch (const std::invalid_argument& e) {
        throw BadInput(fmt::format("{}: {}", options.input, e.what()));
    }
    line.reset();
    const auto json = set_point_design_json(design, options.friction_margin);
    if (options.json) {
        fmt::print("{}\n", json.dump(2));
    } else {
        print_sentence(set_point_design_text(design, units_of(joint)));
        for (const auto& table : set_point_design_tables(design, units_of(joint))) print_table(table);
    }
    const auto* best = design.best < 0 ? nullptr : &design.choices[static_cast<std::size_t>(design.best)];
    if (!options.directory.empty()) {
        const std::filesystem::path directory = options.directory;
        write_whole(directory / "set-point-design.json", json.dump(1) + "\n");
        std::vector<Snippet> snippets;
        if (best) {
            const auto text = joint_text(with_choice(joint, *best));
            write_whole(directory / "designed-joint.toml", text);
            snippets = {{"For the joint file", changed_lines(joint_text(joint), text), ""},
                        {"The whole joint file with these numbers", text, "designed-joint.toml"}};
        }
        catch_interrupts(invocation);  // from here on there is something to keep
        try {
            const auto scan = set_point_scan(joint, requirements, design,
                                             until_interrupted(invocation.interrupted, parallel_for_each));
            const auto page =
                write_report(with_version(set_point_design_report(
                                 {invocation.command, joint, options.friction_margin, options.rest_error, design, scan},
                                 std::move(snippets))),
                             options.directory);
            if (!options.json) fmt::print("\nreport: {}\n", page.string());
        } catch (const Stopped&) {
            say("interrupted: the design is written, its page is not\n");
            return exit_interrupted;
        }
    }
    return best && best->rest_error <= options.rest_error ? exit_done : exit_not_met;
}

}  // namespace stickslip
