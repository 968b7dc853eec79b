#include "sweep/files/records/record_header.h"

#include "sweep/files/records/joint_columns.h"
#include "sweep/files/text/csv_cells.h"
#include "sweep/files/text/header_row.h"
#include "sweep/files/text/toml_input.h"
#include "sweep/files/text/units.h"

#include <algorithm>

namespace stickslip::files {
namespace {

class HeaderMatcher {
  public:
    HeaderMatcher(const HeaderPlace& place, const RecordLayout::Rule& rule, const Joint& joint)
        : place_(place), rule_(rule), joint_(joint)
    {
    }

    RecordHeader match(std::string_view line)
    {
        header_.separator = separator_of(line);
        names_ = header_names(line, header_.separator);
        double number = 0;
        if (std::all_of(names_.begin(), names_.end(), [&](const auto& name) { return parse_cell(name, number); })) {
            complain("there is no header row, expected names such as time,reference_position,position");
            return std::move(header_);
        }
        for (auto name = names_.begin(); name != names_.end(); ++name)
            if (std::find(names_.begin(), name, *name) != name)
                complain("column \"" + *name + "\" appears twice in the header");
        header_.columns.resize(names_.size());
        take_layout_columns();
        take_own_columns();
        if (header_.errors.empty()) require_signals();
        return std::move(header_);
    }

  private:
    using Column = RecordHeader::Column;

    std::string placed(const std::string& text) const
    {
        return place_.file + ":" + std::to_string(place_.line) + ":1: " + text;
    }
    void complain(const std::string& text) { header_.errors.push_back(placed(text)); }

    void take_layout_columns()
    {
        for (const auto& column : rule_.columns) {
            const auto found = std::find(names_.begin(), names_.end(), column.name);
            if (found == names_.end()) {
                header_.errors.push_back(column.where + ": record.columns." + column.signal + ": " + place_.file +
                                         " has no column \"" + column.name + "\", its columns are " + listed(names_) +
                                         did_you_mean(column.name, names_));
                continue;
            }
            Column& slot = header_.columns[static_cast<std::size_t>(found - names_.begin())];
            if (slot.signal)
                header_.errors.push_back(column.where + ": record.columns." + column.signal + ": column \"" +
                                         column.name + "\" is already " + std::string(slot.signal->name));
            slot.signal = signal_named(column.signal);
            slot.scaling = column.scaling;
            mapped_.push_back(column.signal);
            if (!column.scaling.changes()) warn_of_unit_in_name(column.name, *slot.signal);
        }
    }

    void take_own_columns()
    {
        const auto is_mapped = [&](std::string_view signal) {
            return std::find(mapped_.begin(), mapped_.end(), signal) != mapped_.end();
        };
        const bool duty = joint_.actuator.kind == ActuatorKind::dc_motor && joint_.actuator.signal == DriveSignal::duty;
        std::vector<std::string> ignored, known;
        for (const auto& s : signals()) known.emplace_back(s.name);
        for (std::size_t i = 0; i < names_.size(); ++i) {
            if (header_.columns[i].signal || is_of_another(names_[i])) continue;
            const auto [name, unit] = name_and_unit(names_[i]);
            const Signal* signal = signal_named(name);
            if (signal && !is_mapped(signal->name))
                take(i, *signal, unit);
            else
                ignored.push_back(names_[i]);
        }
        // one drive signal: the one that the joint's actuator takes
        Column* drives[2] = {nullptr, nullptr};
        for (auto& slot : header_.columns)
            if (slot.signal && slot.signal->column == &Record::drive) drives[slot.signal->name == "duty"] = &slot;
        if (drives[0] && drives[1]) {
            Column& unused = *drives[duty ? 0 : 1];
            ignored.emplace_back(unused.signal->name);
            unused.signal = nullptr;
        }
        std::string text;
        for (const auto& name : ignored) text += (text.empty() ? "" : ", ") + name + did_you_mean_signal(name, known);
        if (!text.empty()) header_.warnings.push_back("columns that are not read: " + text);
    }

    void take(std::size_t i, const Signal& signal, const std::string& unit)
    {
        Column& slot = header_.columns[i];
        for (std::size_t k = 0; k < i; ++k)
            if (header_.columns[k].signal == &signal && names_[k] != names_[i])
                complain(std::string(signal.name) + " appears twice in the header");
        slot.signal = &signal;
        if (unit.empty()) return;
        const auto reading = signal.any_unit ? parse_unit(unit) : unit_for(unit, signal.quantity, units_of(joint_));
        if (!reading.error.empty()) complain("column \"" + names_[i] + "\": " + reading.error);
        slot.scaling = scaling_of(reading.unit);
    }

    /// A near miss of a signal that the file lacks is worth a word.
    std::string did_you_mean_signal(const std::string& name, std::vector<std::string> known) const
    {
        std::erase_if(known,
                      [&](const std::string& k) { return std::find(names_.begin(), names_.end(), k) != names_.end(); });
        std::string hint = did_you_mean(name, known);
        return hint.empty() ? "" : " (" + hint.substr(2) + ")";
    }

    bool is_of_another(const std::string& name) const
    {
        return std::find(rule_.others.begin(), rule_.others.end(), name) != rule_.others.end();
    }

    void warn_of_unit_in_name(const std::string& column, const Signal& signal)
    {
        const auto from = column.find_last_of("_ ([/");
        if (from == std::string::npos || signal.any_unit) return;
        std::string token = column.substr(from + 1);
        while (!token.empty() && (token.back() == ')' || token.back() == ']')) token.pop_back();
        const auto reading = unit_for(token, signal.quantity, units_of(joint_));
        if (reading.error.empty() &&
            (reading.unit.factor != 1 || reading.unit.decimals != 0 || reading.unit.offset != 0))
            header_.warnings.push_back("suspected unit: column \"" + column + "\" is read as " +
                                       std::string(unit_of(signal.quantity, units_of(joint_))) + ", its name says " +
                                       token);
    }

    /// Of what the file has in place of a signal that it lacks: its columns, the nearest names, the joints in them.
    std::string has_instead(const std::vector<std::string>& wanted) const
    {
        std::string columns;
        for (std::size_t i = 0; i < names_.size(); ++i) {
            const bool known = header_.columns[i].signal || !joints_named_in({names_[i]}).empty();
            columns += (i ? ", " : "") + names_[i] + (known ? "" : did_you_mean_signal(names_[i], wanted));
        }
        std::string text = "; its columns are " + columns + ", [record.columns] can give them other names";
        const auto joints = joints_named_in(names_);
        if (!joints.empty())
            text += "; they name the joint" + std::string(joints.size() > 1 ? "s " : " ") + listed(joints) +
                    ": diagnose --joint " + joints.front() + " reads its columns";
        return text;
    }

    void require_signals()
    {
        bool time = false, measured = false, position = false;
        for (const auto& slot : header_.columns) {
            if (!slot.signal) continue;
            time = time || slot.signal->name == "time";
            position = position || slot.signal->name == "position";
            measured = measured || slot.signal->measured;
        }
        std::vector<std::string> names;
        for (const auto& s : signals())
            if (s.measured) names.emplace_back(s.name);
        if (!time)
            complain("has no column time" + has_instead({"time"}) + "; a table of outcomes has a column outcome");
        if (!measured) complain("has no measured signal, expected one of " + listed(names) + has_instead(names));
        header_.no_position = position ? place_.file + ": every cell of its column position is empty"
                                       : placed("has no column position" + has_instead({"position"}));
    }

    const HeaderPlace& place_;
    const RecordLayout::Rule& rule_;
    const Joint& joint_;
    RecordHeader header_;
    std::vector<std::string> names_, mapped_;
};

}  // namespace

RecordHeader match_header(std::string_view line, const HeaderPlace& place, const RecordLayout::Rule& rule,
                          const Joint& joint)
{
    return HeaderMatcher(place, rule, joint).match(line);
}

}  // namespace stickslip::files
