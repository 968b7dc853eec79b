#include "sweep/engine/plan_file.h"

#include <nlohmann/json.hpp>

#include <stdexcept>

namespace stickslip {
namespace {

using Json = nlohmann::ordered_json;
constexpr char format[] = "stickslip-sweep-plan/1";

Json axis_json(const Axis& axis, Units units)
{
    return {{"path", axis.path},
            {"name", axis.name},
            {"symbol", axis.symbol},
            {"unit", unit_of(axis.quantity, units)},
            {"scale", axis.log ? "log" : "linear"},
            {"values", axis.values}};
}

Axis axis_from(const Json& json, Units units)
{
    Axis axis;
    json.at("path").get_to(axis.path);
    json.at("name").get_to(axis.name);
    json.at("symbol").get_to(axis.symbol);
    axis.quantity = quantity_in(json.at("unit").get<std::string>(), units);
    axis.log = json.at("scale") == "log";
    json.at("values").get_to(axis.values);
    return axis;
}

}  // namespace

Quantity quantity_in(std::string_view unit, Units units)
{
    constexpr int last = static_cast<int>(Quantity::cubic_stiffness);  // of the enumeration
    for (int i = 0; i <= last; ++i)
        if (unit_of(static_cast<Quantity>(i), units) == unit) return static_cast<Quantity>(i);
    throw std::runtime_error("no quantity is written in \"" + std::string(unit) + "\"");
}

std::string to_json(const Plan& plan)
{
    Json axes = Json::array();
    for (const Axis& axis : plan.axes) axes.push_back(axis_json(axis, plan.units));
    const Json json = {{"format", format},
                       {"id", to_text(plan.id)},
                       {"points", plan.points},
                       {"chunk_size", plan.chunk_size},
                       {"motion", plan.units.motion == Motion::revolute ? "revolute" : "prismatic"},
                       {"drive_signal", name_of(plan.units.command)},
                       {"nonlinear", plan.nonlinear},
                       {"build", plan.build},
                       {"version", plan.version},
                       {"title", plan.title},
                       {"command", plan.command},
                       {"options", plan.options},
                       {"joint", plan.joint},
                       {"spec", plan.spec},
                       {"axes", axes}};
    // A spec that is not UTF-8 was refused when it was read; a command line may still hold such a file name.
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Plan plan_from_json(std::string_view text)
{
    Plan plan;
    std::string id;
    try {
        const Json json = Json::parse(text);
        if (json.at("format") != format) throw std::runtime_error("the plan is of another format version");
        json.at("id").get_to(id);
        json.at("points").get_to(plan.points);
        json.at("chunk_size").get_to(plan.chunk_size);
        plan.units = Units(json.at("motion") == "revolute" ? Motion::revolute : Motion::prismatic,
                           command_named(json.value("drive_signal", "effort")));
        json.at("nonlinear").get_to(plan.nonlinear);
        json.at("build").get_to(plan.build);
        json.at("version").get_to(plan.version);
        json.at("title").get_to(plan.title);
        json.at("command").get_to(plan.command);
        json.at("options").get_to(plan.options);
        json.at("joint").get_to(plan.joint);
        json.at("spec").get_to(plan.spec);
        for (const Json& axis : json.at("axes")) plan.axes.push_back(axis_from(axis, plan.units));
    } catch (const Json::exception& e) {
        throw std::runtime_error(std::string("the plan cannot be read: ") + e.what());
    }
    plan.id = id_of(plan);
    if (to_text(plan.id) != id)
        throw std::runtime_error("the plan does not agree with its id: it was edited, or made by another version");
    if (plan.chunk_size == 0 || plan.points == 0) throw std::runtime_error("the plan has no points");
    return plan;
}

}  // namespace stickslip
