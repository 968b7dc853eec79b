// stickslip list: what there is to choose from.
#include "analysis/gap/effect.h"
#include "analysis/joint/parameters.h"
#include "sweep/files/joint_file.h"
#include "sweep/verbs/verbs.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace stickslip {
namespace {

using Json = nlohmann::ordered_json;

Json law_list()
{
    Json json = Json::array();
    for (const auto& law : laws())
        json.push_back({{"name", law.name},
                        {"formula", law.formula},
                        {"source", law.source},
                        {"validity", law.validity},
                        {"steady_state_dependence", law.steady_state_dependence},
                        {"direct_effect", law.direct_effect},
                        {"slip_distance", law.slip_distance}});
    return json;
}

Json joint_list()
{
    Json json = Json::array();
    for (const auto& model : models) json.push_back({{"name", model.name}});
    return json;
}

/// The catalogue of the diagnosis; a parameter's name is the effect's name, a dot, and its own.
Json effect_list(bool with_parameters)
{
    Json json = Json::array();
    for (const auto& effect : gap::effects()) {
        Json entry{{"name", effect.name},
                   {"stage", effect.stage},
                   {"form", effect.form},
                   {"source", effect.source},
                   {"signature", effect.signature}};
        if (with_parameters) {
            entry["confusable_with"] = effect.confusable;
            entry["parameters"] = Json::array();
            for (const auto& form : effect.forms)
                for (const auto& p : form.parameters)
                    entry["parameters"].push_back({{"name", std::string(effect.name) + "." + std::string(p.name)},
                                                   {"form", form.name},
                                                   {"unit_prismatic", unit_of(p.quantity, Motion::prismatic)},
                                                   {"unit_revolute", unit_of(p.quantity, Motion::revolute)},
                                                   {"help", p.help}});
        }
        json.push_back(entry);
    }
    return json;
}

/// Every number of a joint: of the given file, or of a single mass with the given law.
Json parameter_list(const std::string& file, const std::string& law)
{
    Joint joint;
    if (!file.empty())
        joint = read_joint(file);
    else
        apply_setting(joint, "friction.law=" + law);
    Json json = Json::array();
    for (const auto& p : parameters(joint))
        json.push_back({{"path", p.path},
                        {"unit", unit_of(p.quantity, joint.mechanism.motion)},
                        {"range", describe(p.range)},
                        {"required", p.need == Need::required},
                        {"help", p.help}});
    return json;
}

/// One line an entry, columns as wide as their widest text.
void print_columns(const Json& list)
{
    std::vector<std::size_t> widths;
    const auto cell = [](const Json& v) {
        return v.is_boolean() ? std::string(v.get<bool>() ? "yes" : "no") : v.get<std::string>();
    };
    for (const auto& entry : list) {
        std::size_t column = 0;
        for (const auto& value : entry) {
            if (widths.size() <= column) widths.push_back(0);
            widths[column] = std::max(widths[column], cell(value).size());
            ++column;
        }
    }
    for (const auto& entry : list) {
        std::size_t column = 0;
        for (const auto& value : entry) fmt::print("{:<{}}  ", cell(value), widths[column++]);
        fmt::print("\n");
    }
}

struct Options {
    std::string what, joint, law = "rate-and-state";
    bool json = false;
};

}  // namespace

void add_list(CLI::App& app, Invocation&)
{
    auto options = std::make_shared<Options>();
    auto* verb = app.add_subcommand("list", "What there is: friction laws, joints, effects, parameters");
    verb->add_option("WHAT", options->what, "laws | joints | effects | parameters")
        ->required()
        ->check(CLI::IsMember({"laws", "joints", "effects", "parameters"}));
    verb->add_option("--joint", options->joint, "list the parameters of this joint file");
    verb->add_option("--law", options->law, "list the parameters of a single mass with this law")
        ->capture_default_str();
    verb->add_flag("--json", options->json, "machine-readable, stable names");
    verb->footer("Example: stickslip list parameters --law stribeck");
    verb->callback([options] {
        const Json list = options->what == "laws"      ? law_list()
                          : options->what == "joints"  ? joint_list()
                          : options->what == "effects" ? effect_list(options->json)
                                                       : parameter_list(options->joint, options->law);
        if (options->json)
            fmt::print("{}\n", list.dump(2));
        else
            print_columns(list);
    });
}

}  // namespace stickslip
