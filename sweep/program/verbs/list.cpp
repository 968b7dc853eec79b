// stickslip list: what there is to choose from.
#include "analysis/diagnosis/fit/effect.h"
#include "analysis/joint/keys.h"
#include "analysis/joint/parameters.h"
#include "sweep/files/json/export_json.h"
#include "sweep/files/reference/reference_text.h"
#include "sweep/files/toml/commented_text.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/program/verbs/columns.h"
#include "sweep/program/verbs/verbs.h"
#include "sweep/program/verbs/word_option.h"
#include "sweep/study/start/starting_joint.h"
#include "sweep/words/signature_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace stickslip {
namespace {

using Json = nlohmann::ordered_json;

/// With the properties of §2 of the paper that each law declares, and what else chooses its solver.
Json law_list()
{
    Json json = Json::array();
    for (const auto& law : laws())
        json.push_back({{"name", law.name},
                        {"steady_state_dependence", law.steady_state_dependence},
                        {"direct_effect", law.direct_effect},
                        {"slip_distance", law.slip_distance},
                        {"formula", law.formula},
                        {"source", law.source},
                        {"validity", law.validity},
                        {"set_valued_at_rest", law.set_valued_at_rest},
                        {"needs_motion", law.needs_motion},
                        {"linear_only", law.linear_only}});
    return json;
}

struct JointKind {
    const char *figure, *bodies, *feedback, *reduces_to;
};

JointKind kind_of(Model model)
{
    switch (model) {
        case Model::single_mass:
            return {"Fig. 7a, 7b", "inertia", "the mass itself", "nothing"};
        case Model::two_mass:
            return {"Fig. 6", "motor_inertia, link_inertia", "motor or link",
                    "single-mass: ideal motor (7a, 7b), or rigid transmission"};
        case Model::three_mass:
            return {"Fig. 5", "motor_inertia, transmission_inertia, link_inertia", "motor or link",
                    "two-mass: transmission at the motor, or at the joint"};
        case Model::lever:
            return {"Fig. 4", "motor_inertia, transmission_inertia, lever_arm, link_inertia", "motor or link",
                    "three-mass: reflected by the table of section 3"};
    }
    return {};
}

Json joint_list()
{
    Json json = Json::array();
    for (const auto& model : models) {
        const auto kind = kind_of(model.value);
        json.push_back({{"name", model.name},
                        {"figure", kind.figure},
                        {"bodies", kind.bodies},
                        {"feedback", kind.feedback},
                        {"control", "position or force"},
                        {"reduces_to", kind.reduces_to}});
    }
    return json;
}

/// The catalogue of the diagnosis; a parameter's name is the effect's name, a dot, and its own.
Json effect_list(bool with_parameters)
{
    Json json = Json::array();
    for (const auto& effect : gap::effects()) {
        Json entry{{"name", effect.name},
                   {"stage", gap::name_of(effect.stage)},
                   {"form", effect.form},
                   {"source", effect.source},
                   {"signature", signature_text({std::string(effect.name)})}};
        const auto targets = targets_of(effect);
        for (std::size_t i = 0; i < targets.size() && !with_parameters; ++i)
            entry[std::string(simulators[i].name)] = name_of(targets[i].says);
        if (with_parameters) {
            entry["simulators"] = effect_targets_json(targets);
            entry["confusable_with"] = effect.confusable;
            entry["parameters"] = Json::array();
            const auto list = [&](const gap::EffectForm& form) {
                for (const auto& p : form.parameters)
                    entry["parameters"].push_back({{"name", std::string(effect.name) + "." + std::string(p.name)},
                                                   {"form", form.name},
                                                   {"unit_prismatic", unit_of(p.quantity, Units(Motion::prismatic))},
                                                   {"unit_revolute", unit_of(p.quantity, Units(Motion::revolute))},
                                                   {"help", p.help}});
            };
            std::ranges::for_each(effect.forms, list);
            std::ranges::for_each(effect.flexible, list);
        }
        json.push_back(entry);
    }
    return json;
}

/// A law with one row in each of its lists, so that the numbers of a row are listed, too.
void set_law(Joint& joint, const std::string& law)
{
    apply_setting(joint, "friction.law=" + law);
    const auto row = [&](const char* setting) { apply_setting(joint, setting); };
    std::visit(
        [&](const auto& l) {
            if constexpr (requires { l.B; }) row("friction.B=[1]"), row("friction.L=[1]");
            if constexpr (requires { l.elements; }) row("friction.elements=[{stiffness=1, yield=1}]");
            if constexpr (requires { l.exponentials; }) {
                row("friction.exponentials=[{weight=1, rate=1}]");
                row("friction.delays=[{weight=1, time=1}]");
            }
        },
        FrictionLaw(joint.friction.law));
}

/// Every number of a joint: of the given file, or of a single mass with the given law.
Json parameter_list(const std::string& file, const std::string& law)
{
    Joint joint;
    if (!file.empty())
        joint = read_joint(file);
    else
        set_law(joint, law);
    Json json = Json::array();
    for (const auto& p : parameters(joint))
        json.push_back({{"path", p.path},
                        {"unit", unit_of(p.quantity, units_of(joint))},
                        {"range", describe(p.range)},
                        {"required", p.need == Need::required},
                        {"help", p.help}});
    return json;
}

/// Every key, numbers and words, with its default: of the given file, or of a model with a law on every body. JSON also
/// has what that joint says, and the unit alone.
Json key_list(const std::string& file, const std::string& model, const std::string& law, bool with_values)
{
    const auto chosen =
        std::find_if(std::begin(models), std::end(models), [&](const auto& m) { return m.name == model; });
    const Joint joint = file.empty() ? starting_joint(chosen->value, law, Motion::prismatic) : read_joint(file);
    Json json = Json::array();
    for (const auto& key : keys(joint)) {
        Json entry{{"path", key.path}};
        if (with_values) {
            entry["value"] = key.value;
            entry["unit"] = unit_of(key.quantity, units_of(joint));
        }
        entry["default"] = key.need == Need::required ? "required" : key.standard.empty() ? "-" : key.standard;
        entry["allowed"] = allowed_values(key, units_of(joint));
        entry["help"] = key.help;
        json.push_back(std::move(entry));
    }
    return json;
}

struct Options {
    std::string what, joint, law = "rate-and-state", model = "single-mass";
    bool json = false, markdown = false;
};

}  // namespace

void add_list(CommandLine& line, Invocation&)
{
    auto options = std::make_shared<Options>();
    auto verb = line.add_verb("list", "List friction laws, joints, effects, parameters or keys");
    verb.add_option("WHAT", options->what,
                    "laws | joints | effects | parameters | keys (numbers and words, with defaults)")
        ->required()
        ->check(one_of({"laws", "joints", "effects", "parameters", "keys"}));
    verb.add_option("--joint", options->joint, "list the parameters or keys of this joint file");
    std::vector<std::string> law_names, model_names;
    for (const auto& law : laws()) law_names.emplace_back(law.name);
    for (const auto& model : models) model_names.emplace_back(model.name);
    verb.add_option("--law", options->law, "without a file: list those of a joint with this law")
        ->check(one_of(law_names))
        ->capture_default_str();
    verb.add_option("--model", options->model, "without a file: list the keys of this model")
        ->check(one_of(model_names))
        ->capture_default_str();
    verb.add_flag("--json", options->json, "machine-readable, stable names");
    verb.add_flag("--markdown", options->markdown, "with keys: every key of every file, and the columns, as a page");
    verb.footer(
        "Example: stickslip list parameters --law stribeck\n"
        "Example: stickslip list keys --model two-mass --law lugre");
    verb.callback([options] {
        if (options->markdown && options->what != "keys")
            refuse_option("--markdown", "is for keys: stickslip list keys --markdown");
        if (options->markdown) return fmt::print("{}", reference_text());
        const Json list = options->what == "laws"      ? law_list()
                          : options->what == "joints"  ? joint_list()
                          : options->what == "effects" ? effect_list(options->json)
                          : options->what == "keys"
                              ? key_list(options->joint, options->model, options->law, options->json)
                              : parameter_list(options->joint, options->law);
        if (options->json)
            fmt::print("{}\n",
                       Json{{"format", "stickslip-list/1"}, {"what", options->what}, {"entries", list}}.dump(2));
        else
            fmt::print("{}", columns_text(list));
    });
}

}  // namespace stickslip
