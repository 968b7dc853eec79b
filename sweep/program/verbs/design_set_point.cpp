#include "sweep/program/verbs/design_set_point.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "analysis/design/set_point_design.h"
#include "sweep/files/json/set_point_design_json.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/files/toml/asked_axes.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/parallel.h"
#include "sweep/program/verbs/terminal.h"
#include "sweep/words/set_point_design_text.h"
#include "sweep/words/verdict_text.h"

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
    return r;
}

Joint designed(Joint joint, const SetPointChoice& c)
{
    joint.control.k_i = c.k_i;
    joint.control.dead_zone = c.dead_zone;
    return joint;
}

}  // namespace

int design_set_point_answer(const SetPointOptions& options)
{
    const auto joint = read_spec_or_joint(options.input, options.settings).design;
    const auto requirements = requirements_of(options);
    const ThreadLimit limit(options.threads);
    SetPointDesign design;
    try {
        design = design_set_point(joint, requirements, parallel_for_each);
    } catch (const std::invalid_argument& e) {
        throw BadInput(fmt::format("{}: {}", options.input, e.what()));
    }
    const auto json = set_point_design_json(design, options.friction_margin);
    if (options.json) {
        fmt::print("{}\n", json.dump(2));
    } else {
        fmt::print("{}\n", plain_text(set_point_design_text(design, joint.mechanism.motion)));
        for (const auto& table : set_point_design_tables(design, joint.mechanism.motion)) print_table(table);
    }
    const auto* best = design.best < 0 ? nullptr : &design.choices[static_cast<std::size_t>(design.best)];
    if (!options.directory.empty()) {
        write_whole(std::filesystem::path(options.directory) / "set-point-design.json", json.dump(1) + "\n");
        if (best)
            write_whole(std::filesystem::path(options.directory) / "designed-joint.toml",
                        joint_text(designed(joint, *best)));
    }
    return best && best->rest_error <= options.rest_error ? exit_done : exit_check_failed;
}

}  // namespace stickslip
