// stickslip export: a joint as elements of a simulator's robot description.
#include "sweep/files/json/export_json.h"
#include "sweep/files/simulators/simulator_text.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/gather_records.h"
#include "sweep/program/verbs/number_option.h"
#include "sweep/program/verbs/parallel.h"
#include "sweep/program/verbs/say.h"
#include "sweep/program/verbs/verbs.h"
#include "sweep/program/verbs/word_option.h"
#include "sweep/study/export/gap_left.h"
#include "sweep/words/export_text.h"
#include "sweep/words/plain_text.h"
#include "sweep/words/refusal_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <stdexcept>

namespace stickslip {
namespace {

struct Options {
    std::string joint, to, name = "joint";
    std::vector<std::string> settings, records;
    double timestep = not_set, link_inertia = not_set, speed = not_set;
    bool json = false;
};

Simulator simulator_of(const std::string& name)
{
    for (const auto& s : simulators)
        if (s.name == name) return s.value;
    throw BadInput("--to: got \"" + name + "\"");  // the command line has checked it
}

GapLeft left_on(const Options& options, const Joint& joint, const ExportOptions& wanted)
{
    const auto given = gather_records(options.records, {options.joint, {}, {}}, joint);
    if (!given.gaps.empty()) throw BadInput(given.gaps);
    try {
        return gap_left(joint, simulator_of(options.to), wanted, given.records, parallel_for_each);
    } catch (const std::invalid_argument& e) {
        throw BadInput("--records: " + refusal_text(e));
    }
}

int export_verb(const Options& options)
{
    Joint joint = read_joint(options.joint);
    apply_settings(joint, options.settings);
    ExportOptions wanted;
    wanted.timestep = options.timestep;
    wanted.split.link_inertia = options.link_inertia;
    wanted.split.speed = options.speed;
    ExportAnswer answer;
    try {
        answer = export_joint(joint, simulator_of(options.to), wanted);
    } catch (const std::invalid_argument& e) {
        throw BadInput(fmt::format("--link-inertia: got {}, but {}", options.link_inertia, e.what()));
    }
    if (!options.records.empty()) answer.gap_left = left_on(options, joint, wanted);
    const auto text = simulator_text(answer, options.name);
    const auto why = [&](const NotExpressible& n) { return lost_text(answer, n); };
    if (options.json) {
        fmt::print("{}\n", export_json(answer, text, why).dump(2));
        return exit_done;
    }
    fmt::print("{}", text);
    if (const auto at = read_at_text(answer.joint); !at.empty()) say("{}\n", plain_text(at));
    // the text may go into a file; what is missing in it is for the reader of the terminal
    if (!answer.not_expressible.empty()) say("Not in this text:\n");
    for (const auto& n : answer.not_expressible) say("  {}: {}\n", n.key, why(n));
    if (answer.gap_left)
        say("{}\n", gap_left_text(answer));
    else if (!answer.not_expressible.empty())
        say("What that leaves of the gap: add --records FILE… that the diagnosis has not seen\n");
    return exit_done;
}

}  // namespace

void add_export(CommandLine& line, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto verb = line.add_verb(
        "export", "Write a joint as elements of a robot simulator, and list what the simulator cannot express");
    verb.add_option("JOINT", options->joint, "joint description, TOML")->required();
    std::vector<std::string> names;
    for (const auto& s : simulators) names.emplace_back(s.name);
    verb.add_option("--to", options->to, "which simulator")->required()->check(one_of(names));
    verb.add_option("--set", options->settings, "set a parameter first: path=value");
    verb.add_option("--name", options->name, "name of the joint in the text")->capture_default_str();
    verb.add_option("--timestep", options->timestep,
                    "time step of the simulator in s; default: its usual one, shorter where the joint needs it")
        ->check(positive_number());
    verb.add_option("--link-inertia", options->link_inertia,
                    "one mass: inertia of the robot's links about this axis; the remainder is armature")
        ->check(positive_number());
    verb.add_option("--speed", options->speed,
                    "velocity at which friction without a Coulomb level is evaluated; default: that of sliding, "
                    "control.V0 per sensor.position_scale")
        ->check(positive_number());
    verb.add_option("--records", options->records,
                    "held-out records: the gap that the joint leaves, and the gap that the exported part of it leaves");
    verb.add_flag("--json", options->json, "machine-readable, stable names");
    verb.footer("Example: stickslip export corrected-joint.toml --to mjcf --name elbow > elbow.xml");
    verb.callback([options, &invocation] { invocation.exit_code = export_verb(*options); });
}

}  // namespace stickslip
