#include "sweep/files/toml/commented_text.h"

#include "analysis/joint/key_collector.h"
#include "analysis/joint/parameters.h"
#include "sweep/study/spec.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// Keys that stand under one header.
struct TableText {
    std::string path;
    bool in_list = false;
    std::string lines;
    bool anything_set = false;
};

/// "friction.elements.1" is the second [[friction.elements]].
std::string header(const TableText& table)
{
    if (!table.in_list) return "[" + table.path + "]";
    return "[[" + table.path.substr(0, table.path.rfind('.')) + "]]";
}

std::string value_text(const Key& key, const std::string& value)
{
    return key.kind == KeyKind::choice || key.kind == KeyKind::text ? "\"" + value + "\"" : value;
}

}  // namespace

std::string allowed_values(const Key& key, Units units)
{
    if (key.kind == KeyKind::flag) return "true, false";
    if (key.kind == KeyKind::text) return "text";
    if (key.kind == KeyKind::choice) return fmt::format("{}", fmt::join(key.words, ", "));
    const auto unit = unit_of(key.quantity, units);
    const std::string range = describe(key.range);
    const std::string list = key.kind == KeyKind::numbers ? ", or a list" : "";
    return (unit == "1" ? "" : std::string(unit) + ", ") + range + list;
}

std::string commented_toml(const std::vector<Key>& keys, Units units)
{
    std::vector<TableText> tables;
    for (const auto& key : keys) {
        const auto dot = key.path.rfind('.');
        const std::string path = key.path.substr(0, dot), name = key.path.substr(dot + 1);
        auto table = std::find_if(tables.begin(), tables.end(), [&](const TableText& t) { return t.path == path; });
        if (table == tables.end()) {
            tables.push_back({path, key.in_row});
            table = tables.end() - 1;
        }
        const bool set =
            !key.value.empty() && (key.in_force() || key.kind == KeyKind::choice || key.need == Need::required);
        const bool of_note = set && (key.in_force() || key.need == Need::required);
        std::string line = (set ? "" : "# ") + name + " = " + value_text(key, set ? key.value : key.standard);
        if (key.kind != KeyKind::text && !set && key.standard.empty()) line = "# " + name + " =";
        table->lines += fmt::format("{:<32} # {}: {}\n", line, allowed_values(key, units), key.help);
        table->anything_set = table->anything_set || of_note;
    }
    std::string text;
    for (const auto& table : tables) {
        text += text.empty() ? "" : "\n";
        if (table.anything_set) {
            text += header(table) + "\n" + table.lines;
            continue;
        }
        // a table in which nothing is said is absent; so are its words
        text += "# " + header(table) + "\n";
        for (std::size_t at = 0; at < table.lines.size();) {
            const auto end = table.lines.find('\n', at);
            const auto line = table.lines.substr(at, end - at);
            text += (line.starts_with("# ") ? line : "# " + line) + "\n";
            at = end + 1;
        }
    }
    return text;
}

std::string commented_joint(const Joint& joint)
{
    return "# A joint for stickslip, SI units. Lines that begin with # are keys at their default: remove the # to set "
           "them,\n"
           "# and that of the [table] above them. The numbers are an example: put in those of your joint.\n\n" +
           commented_toml(keys(joint), units_of(joint));
}

std::string commented_spec(const Joint& joint)
{
    const auto& c = joint.control;
    const auto axis = [](const std::string& path, double low, double high, int points) {
        return fmt::format("\"{}\" = {{ from = {:g}, to = {:g}, points = {}, scale = \"log\" }}\n", path, low, high,
                           points);
    };
    const double k_v = c.k_v > 0 ? c.k_v : 1;
    std::string text =
        "# A sweep for stickslip: a joint, the axes to vary, and what to compute at each point. SI units.\n"
        "# In place of the joint's own tables the file may say  joint = \"joint.toml\"  here, above all tables.\n"
        "title = \"New sweep\"\n\n";
    text += commented_toml(keys(joint), units_of(joint));
    text += "\n[axes]                           # any numbers of the joint: see stickslip list keys\n";
    text += axis("control.k_p", c.k_p / 100, c.k_p * 100, 41);
    text += axis("control.k_v", k_v / 10, k_v * 1000, 31);
    text += "\n# [design]                       # the marked point; default: the values of the joint\n";
    text += fmt::format("# \"control.k_p\" = {:g}\n", c.k_p);
    auto rest = keys_of(NonlinearSpec{}, "nonlinear");
    for (auto more : {keys_of(BoundarySpec{}, "boundary"), keys_of(CheckSpec{}, "check")})
        rest.insert(rest.end(), more.begin(), more.end());
    text += "\n" + commented_toml(rest, units_of(joint));
    text += "\n# [report]\n# charts = [[\"control.k_p\", \"control.k_v\"]]   # pairs of axes to draw\n";
    return text;
}

}  // namespace stickslip
