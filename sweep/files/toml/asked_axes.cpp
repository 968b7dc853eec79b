#include "sweep/files/toml/asked_axes.h"

#include "analysis/joint/parameters.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/toml_input.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/files/toml/joint_keys.h"
#include "sweep/files/toml/refused_memory.h"
#include "sweep/files/toml/spec_file.h"
#include "sweep/words/symbols.h"

#include <fmt/format.h>

#include <algorithm>

namespace stickslip {
namespace {

constexpr double reach = 100;        ///< of an axis without a range, to either side of the design's value
constexpr double log_from_here = 8;  ///< ratio of the ends from which an axis is logarithmic if nothing is said

Parameter leaf_of(Joint& joint, const std::string& path, const std::string& option)
{
    for (const auto& leaf : parameters(joint))
        if (leaf.value == find_parameter(joint, path)) return leaf;
    throw BadInput(fmt::format("{} {}: is not a parameter of this joint{}", option, path,
                               files::did_you_mean(path, files::numeric_paths(joint))));
}

double number_from(const Joint& joint, const std::string& path, const std::string& text, const std::string& option)
{
    Joint changed = joint;
    try {
        apply_setting(changed, path + "=" + text);
    } catch (const BadInput& bad) {
        std::vector<std::string> messages;
        for (auto m : bad.messages()) messages.push_back(m.replace(0, std::min<std::size_t>(5, m.size()), option));
        throw BadInput(messages);
    }
    return *find_parameter(changed, path);
}

/// Of a number that has no decades about it; a negative one shows the range that its amount would have had.
BadInput without_range(const std::string& option, const std::string& path, double value)
{
    const std::string range = value < 0 ? fmt::format("{}..{}", reach * value, value / reach) : "FROM..TO";
    return BadInput(
        fmt::format("{} {}: is {} in the joint and no axis of the spec, so its range has to be given: {} {}={}", option,
                    path, is_set(value) ? fmt::format("{}", value) : "not set", option, path, range));
}

}  // namespace

Asked read_spec_or_joint(const std::filesystem::path& file, const std::vector<std::string>& settings)
{
    Asked asked;
    if (files::parse_toml(files::read_text(file), file.string()).contains("axes")) {
        asked.spec = read_spec(file);
        asked.design = design_joint(asked.spec);
    } else {
        asked.spec.joint = asked.design = read_joint(file);
        asked.spec.joint_file = file.string();
    }
    if (asked.spec.title.empty()) asked.spec.title = file.stem().string();
    apply_settings(asked.design, settings);
    return asked;
}

Axis axis_from(const Asked& asked, const std::string& text, const std::string& option)
{
    const auto equals = text.find('=');
    const std::string path = text.substr(0, equals);
    Joint joint = asked.design;
    const auto leaf = leaf_of(joint, path, option);
    Axis axis{path, symbol_of(path, units_of(joint)), name_of(path), leaf.quantity, false, {}};
    if (equals == std::string::npos) {
        for (const auto& known : asked.spec.axes)
            if (known.path == path && known.values.size() > 1) {
                axis.log = known.log;
                axis.values = {known.values.front(), known.values.back()};
                return axis;
            }
        const double value = *leaf.value;
        if (!(value > 0)) throw without_range(option, path, value);
        axis.log = true;
        axis.values = {value / reach, value * reach};
        return axis;
    }
    std::string range = text.substr(equals + 1), scale;
    for (const char* name : {":log", ":linear"})
        if (range.ends_with(name)) scale = name, range.resize(range.size() - scale.size());
    const auto dots = range.find("..");
    if (dots == std::string::npos || dots == 0 || dots + 2 == range.size())
        throw BadInput(
            fmt::format("{} {}: got \"{}\", expected a range such as {}=1e3..1e6", option, path, range, path));
    axis.values = {number_from(joint, path, range.substr(0, dots), option),
                   number_from(joint, path, range.substr(dots + 2), option)};
    for (const double end : axis.values) {
        Joint at = asked.design;
        number_at(at, path) = end;
        if (const auto late = files::refused_memory(at.control, at.sensor.delay); !late.path.empty())
            throw BadInput(fmt::format("{} {}: {} {}", option, path, late.path, late.message));
    }
    const double low = axis.values[0], high = axis.values[1];
    if (!(low < high))
        throw BadInput(
            fmt::format("{} {}: runs from {} to {}, expected an end above the start", option, path, low, high));
    axis.log = scale == ":log" || (scale.empty() && low > 0 && high / low >= log_from_here);
    if (axis.log && !(low > 0))
        throw BadInput(fmt::format("{} {}: a log scale needs numbers > 0, the start is {}", option, path, low));
    return axis;
}

}  // namespace stickslip
