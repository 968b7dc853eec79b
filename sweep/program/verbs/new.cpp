// stickslip new: a commented file that runs, to be filled with the numbers of a real joint.
#include "analysis/friction/law.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/files/toml/asked_axes.h"
#include "sweep/files/toml/commented_text.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/verbs.h"
#include "sweep/program/verbs/word_option.h"
#include "sweep/study/start/starting_joint.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace stickslip {
namespace {

struct Options {
    std::string what, model = "single-mass", law = "rate-and-state", motion = "prismatic", from, file;
    std::vector<std::string> settings;
    bool force = false, plain = false;
};

template <class Enum, std::size_t n>
std::vector<std::string> names_of(const Choice<Enum> (&choices)[n])
{
    std::vector<std::string> names;
    for (const auto& c : choices) names.emplace_back(c.name);
    return names;
}

template <class Enum, std::size_t n>
Enum value_of(const Choice<Enum> (&choices)[n], const std::string& name)
{
    return std::find_if(choices, choices + n, [&](const auto& c) { return c.name == name; })->value;
}

int new_file(const Options& options)
{
    Joint joint = options.from.empty()
                      ? starting_joint(value_of(models, options.model), options.law, value_of(motions, options.motion))
                      : read_spec_or_joint(options.from, {}).design;
    apply_settings(joint, options.settings);
    joint.pose = {};  // of a spec's robot: its numbers are written, the robot is no part of a joint file
    if (options.plain && options.what == "spec")
        throw BadInput("--plain: is for joints; a new spec has comments that say what it may contain");
    const std::string text = options.plain             ? joint_text(joint)
                             : options.what == "joint" ? commented_joint(joint)
                                                       : commented_spec(joint);
    if (options.file.empty()) {
        fmt::print("{}", text);
        return exit_done;
    }
    if (std::filesystem::exists(options.file) && !options.force)
        throw BadInput(options.file + ": exists already; choose another name with -o, or --force to replace it");
    write_whole(options.file, text);
    fmt::print("{}: try it with  stickslip {} {}\n", options.file, options.what == "joint" ? "evaluate" : "sweep",
               options.file);
    return exit_done;
}

}  // namespace

void add_new(CommandLine& line, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto verb = line.add_verb("new", "Write a commented joint or sweep file that runs, to fill in");
    verb.add_option("WHAT", options->what, "joint | spec")->required()->check(one_of({"joint", "spec"}));
    verb.add_option("--model", options->model, "lumped model")->check(one_of(names_of(models)))->capture_default_str();
    std::vector<std::string> names;
    for (const auto& law : laws()) names.emplace_back(law.name);
    verb.add_option("--law", options->law, "friction law, on every body")->check(one_of(names))->capture_default_str();
    verb.add_option("--motion", options->motion, "what the joint does")
        ->check(one_of(names_of(motions)))
        ->capture_default_str();
    verb.add_option("--from", options->from, "start from this joint or spec instead of an example");
    verb.add_option("--set", options->settings, "set a number or word: path=value");
    verb.add_flag("--plain", options->plain, "only what differs from its default, without comments");
    verb.add_option("-o,--output", options->file, "file to write; default: standard output");
    verb.add_flag("--force", options->force, "replace the file if it exists");
    verb.footer(
        "Example: stickslip new joint --motion revolute --model two-mass --law stribeck -o joint.toml\n"
        "Example: stickslip new joint --from joint.toml --set control.k_p=2e4 --plain -o stiffer.toml");
    verb.callback([options, &invocation] { invocation.exit_code = new_file(*options); });
}

}  // namespace stickslip
