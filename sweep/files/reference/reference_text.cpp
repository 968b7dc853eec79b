#include "sweep/files/reference/reference_text.h"

#include "analysis/joint/key_collector.h"
#include "analysis/joint/parameters.h"
#include "analysis/results/point.h"
#include "sweep/files/records/signals.h"
#include "sweep/files/reference/every_key.h"
#include "sweep/files/toml/hand_keys.h"
#include "sweep/files/toml/requirements_file.h"
#include "sweep/study/spec.h"

#include <fmt/format.h>

#include <algorithm>

namespace stickslip {
namespace {

constexpr std::string_view nothing = "–";

/// "N/m (N·m/rad)": of prismatic joints, and of revolute ones where it differs.
std::string units(Quantity quantity)
{
    const auto prismatic = unit_of(quantity, Units(Motion::prismatic)),
               revolute = unit_of(quantity, Units(Motion::revolute));
    if (prismatic != revolute) return fmt::format("{} ({})", prismatic, revolute);
    return std::string(prismatic == "1" ? nothing : prismatic);
}

std::string code(std::string_view text)
{
    return fmt::format("`{}`", text);
}

/// What stands between the bars of a table cannot hold a bar.
std::string cell(std::string text)
{
    for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.replace(at, 1, "\\|");
    return text;
}

std::string row(const std::vector<std::string>& cells)
{
    std::string line = "|";
    for (const auto& one : cells) line += " " + cell(one) + " |";
    return line + "\n";
}

std::string heading(const std::vector<std::string>& names)
{
    return row(names) + row(std::vector<std::string>(names.size(), "---"));
}

std::string allowed(const Key& key)
{
    if (key.kind == KeyKind::flag) return "true, false";
    if (key.kind == KeyKind::text) return "text";
    if (key.kind == KeyKind::choice) return fmt::format("`{}`", fmt::join(key.words, "`, `"));
    return describe(key.range) + (key.kind == KeyKind::numbers ? ", or a list" : "");
}

std::string standard(const Key& key)
{
    if (key.need == Need::required) return "required";
    return key.standard.empty() ? std::string(nothing) : code(key.standard);
}

/// Its unit follows from another key.
bool unit_by_kind(const Key& key)
{
    return key.path == "nonlinear.disturbance.size";
}

std::string unit(const Key& key)
{
    if (key.kind != KeyKind::number && key.kind != KeyKind::numbers) return std::string(nothing);
    return unit_by_kind(key) ? "of its kind" : units(key.quantity);
}

/// "; with `control.structure` = `pid`". The law of a section needs no mention in it.
std::string condition(const ListedKey& entry, std::string_view unmentioned)
{
    std::string text;
    for (const auto& [choice, words] : entry.only_with)
        if (choice != unmentioned) text += fmt::format("; with {} = `{}`", code(choice), fmt::join(words, "`, `"));
    return text;
}

std::string key_row(const ListedKey& entry, std::string_view unmentioned = "")
{
    const Key& key = entry.key;
    return row({code(key.path), unit(key), allowed(key), standard(key), key.help + condition(entry, unmentioned)});
}

const std::string key_heading = heading({"Key", "Unit", "Takes", "Default", "Meaning"});

bool of_some_laws(const ListedKey& entry)
{
    return entry.only_with.contains("friction.law");
}

struct Table {
    const char *name, *about;
};
constexpr Table joint_tables[] = {
    {"joint", "Bodies and what connects them."},
    {"load", "External forces on the link."},
    {"control",
     "The loop: continuous without `control.period`, sampled with one. What it puts out is an effort; before a DC "
     "motor "
     "it is the drive's signal, and gains are V/m, V·s/m, V/(m·s) (V/rad, V·s/rad, V/(rad·s)) on voltage, and 1/m, "
     "s/m, "
     "1/(m·s) (1/rad, s/rad, 1/(rad·s)) on duty."},
    {"friction",
     "Joints with several bodies have these keys under `[friction.motor]`, `[friction.transmission]` and "
     "`[friction.link]`; `law = \"time-lag\"` has those of its law under `[friction.curve]`. The laws' own keys follow "
     "below."},
    {"actuator", "From the command to the effort: dead time, lag, gain, limit."},
    {"sensor", "Encoder and measurement noise."},
    {"normal", "A normal force that depends on the motion."},
    {"neighbour", "Joints that the mass matrix couples to this one: `[[neighbour]]`, at most six."},
};

template <std::size_t n>
std::string hand_rows(const files::HandKey (&keys)[n], std::string_view table)
{
    std::string text;
    for (const auto& key : keys) {
        if (key.table != table) continue;
        const std::string path = key.table.empty() ? std::string(key.name) : fmt::format("{}.{}", key.table, key.name);
        const std::string value = key.standard == "-" ? std::string(nothing) : std::string(key.standard);
        text += row({code(path), std::string(nothing), std::string(key.takes), value, std::string(key.help)});
    }
    return text;
}

std::string joint_sections(const std::vector<ListedKey>& all)
{
    std::string text = "## Joint files\n";
    for (const auto& table : joint_tables) {
        text += fmt::format("\n### `[{}]`\n\n{}\n\n{}", table.name, table.about, key_heading);
        for (const auto& entry : all) {
            const auto end = entry.key.path.find_first_of(".[");
            if (entry.key.path.substr(0, end) == table.name && !of_some_laws(entry)) text += key_row(entry);
        }
        text += hand_rows(files::joint_keys, table.name);
        if (table.name != std::string_view("friction")) continue;
        for (const auto& law : laws()) {
            text +=
                fmt::format("\n#### `law = \"{}\"`\n\n`{}`. {}\n\n{}", law.name, law.formula, law.source, key_heading);
            for (const auto& entry : all) {
                if (!of_some_laws(entry)) continue;
                const auto& of = entry.only_with.at("friction.law");
                if (std::find(of.begin(), of.end(), law.name) != of.end()) text += key_row(entry, "friction.law");
            }
        }
    }
    return text;
}

std::string spec_sections()
{
    using files::spec_keys;
    const auto declared = [](const std::vector<Key>& keys) {
        std::string rows;
        for (const auto& key : keys) rows += key_row({key, {}});
        return rows;
    };
    std::string text = "\n## Specs\n\n" + key_heading + hand_rows(spec_keys, "");
    text +=
        "\n### `[axes]`\n\nOne entry for each number that varies, under its path: `\"control.k_p\" = { from = 1e4, to "
        "= "
        "1e5, points = 31 }`, or a list of values.\n\n" +
        key_heading + hand_rows(spec_keys, "axes");
    text +=
        "\n### `[robot]`\n\nThe joint as one of a robot: its inertia and gravity are those of the pose of the other "
        "joints, "
        "whose coordinates (rad, or m of those that slide) are numbers of the joint, such as `pose.elbow`: an axis, or "
        "a "
        "value in `[design]`. Others stand at their zero. In place of `joint.inertia` (several masses: "
        "`joint.link_inertia`), `load.gravity_amplitude` and `load.gravity_phase`, of a sliding joint `load.constant`, "
        "the numbers of the pose hold.\n\n" +
        key_heading + hand_rows(spec_keys, "robot");
    text +=
        "\n### `[design]`\n\nThe marked point: a value under the path of any number of the joint. It holds for the "
        "whole sweep unless it is an axis.\n";
    text += "\n### `[nonlinear]`\n\n" + key_heading + declared(keys_of(NonlinearSpec{}, "nonlinear"));
    text += "\n### `[boundary]`\n\n" + key_heading + hand_rows(spec_keys, "boundary") +
            declared(keys_of(BoundarySpec{}, "boundary"));
    text += "\n### `[check]`\n\n" + key_heading + declared(keys_of(CheckSpec{}, "check"));
    text += "\n### `[report]`\n\n" + key_heading + hand_rows(spec_keys, "report");
    text +=
        "\n### `[requirements]`\n\nOf `stickslip design`. Defaults come from the joint's `[sensor]`, `[control]` and "
        "`[actuator]`.\n\n" +
        key_heading + declared(requirement_keys()) + hand_rows(spec_keys, "requirements");
    return text;
}

std::string record_sections()
{
    std::string text =
        "\n## Records\n\n### `[record]`\n\nIn the joint file, or in `record.toml` beside the records.\n\n" +
        key_heading + hand_rows(files::record_keys, "record") +
        hand_rows(files::record_column_keys, "record.columns.SIGNAL");
    text += "\n### Columns of a record\n\nA record needs `time` and one measured signal.\n\n" +
            heading({"Column", "Unit", "Measured", "Meaning"});
    for (const auto& signal : signals())
        text += row({code(signal.name), signal.any_unit ? "its own" : units(signal.quantity),
                     signal.measured ? "yes" : std::string(nothing), std::string(signal.help)});
    text +=
        "\n### Columns of a table of outcomes\n\nA table with a column `outcome` is one measured verdict a row.\n\n" +
        heading({"Column", "Unit", "Meaning"}) +
        row({"a number of the joint, by its path or last name", "its own, or in brackets: `V0 [mm/s]`",
             "the setting at which the joint was tried"}) +
        row({code("outcome"), std::string(nothing), "`stable` (or 0), `stick-slip` (or 1)"}) +
        row({code("amplitude"), units(Quantity::position), "of the stick-slip, half peak to peak; may be empty"});
    return text;
}

std::string result_sections()
{
    std::string text = "\n## Columns of results.nc\n\nOne value for each point of the sweep.\n\n" +
                       heading({"Variable", "Unit", "Meaning", "Codes from 0"});
    for (const auto& column : columns()) {
        std::string codes(column.meanings);
        for (auto& c : codes)
            if (c == ' ') c = ',';
        for (std::size_t at = 0; (at = codes.find(',', at)) != std::string::npos; at += 2) codes.replace(at, 1, ", ");
        text += row({code(column.name), units(column.quantity),
                     std::string(column.long_name) + (column.nonlinear ? "; with `nonlinear.enabled`" : ""),
                     codes.empty() ? std::string(nothing) : codes});
    }
    return text;
}

}  // namespace

std::string reference_text()
{
    return joint_sections(every_joint_key()) + spec_sections() + record_sections() + result_sections();
}

}  // namespace stickslip
