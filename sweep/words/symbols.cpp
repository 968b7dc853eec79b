#include "sweep/words/symbols.h"

#include <algorithm>
#include <vector>

#include "analysis/joint/signs.h"

namespace stickslip {
namespace {

struct Split {
    std::string path;    ///< without the index of a list
    std::string number;  ///< of the list element, counted from 1; empty for a single one
};

Split split_index(std::string_view path)
{
    const auto dot = path.rfind('.');
    const std::string_view last = path.substr(dot == std::string_view::npos ? 0 : dot + 1);
    const bool index = dot != std::string_view::npos && !last.empty() && last.size() < 4 &&
                       std::all_of(last.begin(), last.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!index) return {std::string(path), ""};
    return {std::string(path.substr(0, dot)), std::to_string(std::stoi(std::string(last)) + 1)};
}

/// The last `count` keys of a path.
std::vector<std::string> last_keys(std::string_view path, std::size_t count)
{
    std::vector<std::string> keys;
    while (!path.empty() && keys.size() < count) {
        const auto dot = path.rfind('.');
        keys.insert(keys.begin(), std::string(path.substr(dot == std::string_view::npos ? 0 : dot + 1)));
        path = path.substr(0, dot == std::string_view::npos ? 0 : dot);
    }
    return keys;
}

constexpr std::string_view of_pose = "pose.";

/// The name of another joint of a robot, whatever it has in it that charts would take for markup.
std::string robot_joint(std::string_view path)
{
    std::string name(path.substr(of_pose.size()));
    for (char& c : name)
        if (c == '_' || c == '{' || c == '}' || c == '^') c = ' ';
    return name;
}

}  // namespace

std::string symbol_of(std::string_view given, Units units)
{
    if (given.starts_with(of_pose)) return "q_{" + robot_joint(given) + "}";
    const Split split = split_index(given);
    std::string symbol;
    if (const Sign* sign = sign_of(split.path)) {
        symbol = sign->symbol;
        const bool inertia = sign->quantity == Quantity::inertia || sign->quantity == Quantity::rotary_inertia;
        if (units.motion == Motion::revolute && inertia && symbol.front() == 'm') symbol.front() = 'J';
    } else {
        const auto keys = last_keys(split.path, 1);
        const std::string key = keys.empty() ? "" : keys.back();
        const auto underscore = key.find('_');
        symbol = key.substr(0, underscore);
        if (underscore != std::string::npos) symbol += "_{" + key.substr(underscore + 1) + "}";
        std::replace(symbol.begin(), symbol.end(), '_', ' ');
        if (underscore != std::string::npos) symbol[underscore] = '_';
    }
    if (split.number.empty()) return symbol;
    if (symbol.ends_with('}')) return symbol.substr(0, symbol.size() - 1) + "," + split.number + "}";
    return symbol + "_{" + split.number + "}";
}

std::string name_of(std::string_view given)
{
    if (given.starts_with(of_pose)) return "pose of " + robot_joint(given);
    const Split split = split_index(given);
    std::string name;
    if (const Sign* sign = sign_of(split.path)) {
        name = sign->name;
    } else {
        for (const auto& key : last_keys(split.path, 2)) name += (name.empty() ? "" : " ") + key;
        std::replace(name.begin(), name.end(), '_', ' ');
    }
    return split.number.empty() ? name : name + " " + split.number;
}

}  // namespace stickslip
