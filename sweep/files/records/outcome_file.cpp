#include "sweep/files/records/outcome_file.h"

#include "analysis/joint/parameters.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/csv_cells.h"
#include "sweep/files/text/header_row.h"
#include "sweep/files/text/toml_input.h"
#include "sweep/files/text/units.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace stickslip {
namespace files {
namespace {

constexpr std::size_t max_errors = 20, most_rows = 2000;

struct Cell {
    std::string_view text;
    std::size_t column = 1;
};

std::vector<Cell> cells_of(std::string_view line, char separator)
{
    std::vector<Cell> cells;
    std::size_t from = 0;
    while (true) {
        const std::size_t to = std::min(line.size(), line.find(separator, from));
        std::string_view text = trimmed(line.substr(from, to - from));
        if (text.size() > 1 && text.front() == '"' && text.back() == '"')
            text = trimmed(text.substr(1, text.size() - 2));
        cells.push_back({text, from + 1});
        if (to == line.size()) return cells;
        from = to + 1;
    }
}

std::optional<bool> outcome_of(std::string_view word)
{
    for (const char* slides : {"stable", "stable-sliding", "smooth", "0"})
        if (word == slides) return false;
    for (const char* sticks : {"stick-slip", "limit-cycle", "reversal", "period-n", "irregular", "1"})
        if (word == sticks) return true;
    return std::nullopt;
}

class OutcomeReader {
  public:
    OutcomeReader(const std::filesystem::path& file, const Joint& joint, std::vector<std::string>& warnings)
        : name_(file.string()), joint_(joint), warnings_(warnings), lines_(file)
    {
        table_.name = file.filename().string();
    }

    OutcomeTable read()
    {
        try {
            read_table();
        } catch (const BadInput&) {
            lines_.verify_archive();
            throw;
        }
        return std::move(table_);
    }

  private:
    void read_table()
    {
        std::string_view line;
        if (!next_header(lines_, line))
            throw BadInput(name_ + ": is empty, expected a header row such as k_p,k_v,V0,outcome");
        separator_ = separator_of(line);
        read_header(line);
        fail_if_any();
        while (lines_.next(line))
            if (!trimmed(line).empty() && !trimmed(line).starts_with('#')) read_row(line);
        fail_if_any();
        if (table_.rows.empty()) throw BadInput(name_ + ": has a header and no rows");
    }

    enum class Role { unread, outcome, amplitude, setting };
    struct Column {
        Role role = Role::unread;
        std::string name;
        Unit unit;
        Range range;
    };

    void complain(std::size_t column, const std::string& text)
    {
        errors_.push_back(name_ + ":" + std::to_string(lines_.line_number()) + ":" + std::to_string(column) + ": " +
                          text);
        if (errors_.size() == max_errors) fail_if_any();
    }
    void fail_if_any() const
    {
        if (!errors_.empty()) throw BadInput(errors_);
    }

    void read_header(std::string_view line)
    {
        Joint joint = joint_;
        const auto known = parameters(joint);
        std::string ignored;
        bool outcome = false;
        for (const auto& cell : cells_of(line, separator_)) {
            const auto [name, unit] = name_and_unit(cell.text);
            Column column;
            column.name = name;
            Quantity quantity = Quantity::number;
            if (name == "outcome") {
                column.role = Role::outcome;
                outcome = true;
            } else if (name == "amplitude") {
                column.role = Role::amplitude, quantity = Quantity::position, column.range = positive;
            } else {
                std::vector<const Parameter*> found;
                for (const auto& p : known)
                    if (p.path == name || (name.find('.') == std::string::npos && p.path.ends_with("." + name)))
                        found.push_back(&p);
                if (found.size() > 1)
                    complain(cell.column, "\"" + name + "\" is not one number of the joint, write its whole path");
                if (found.size() == 1) {
                    if (std::find(table_.paths.begin(), table_.paths.end(), found[0]->path) != table_.paths.end())
                        complain(cell.column, "column \"" + name + "\" appears twice in the header");
                    column.role = Role::setting, quantity = found[0]->quantity, column.range = found[0]->range;
                    table_.paths.push_back(found[0]->path);
                } else if (found.empty()) {
                    ignored += (ignored.empty() ? "" : ", ") + name;
                }
            }
            if (!unit.empty() && column.role != Role::unread) {
                const auto reading = unit_for(unit, quantity, units_of(joint_));
                if (!reading.error.empty()) complain(cell.column, name + ": " + reading.error);
                column.unit = reading.unit;
            }
            columns_.push_back(std::move(column));
        }
        if (!outcome) complain(1, "has no column outcome");
        if (table_.paths.empty()) complain(1, "has no setting of the joint, expected columns such as k_p, k_v and V0");
        if (!ignored.empty()) warnings_.push_back("columns that are not read: " + ignored);
    }

    void read_row(std::string_view line)
    {
        if (table_.rows.size() == most_rows) {
            complain(1, "is row " + std::to_string(most_rows + 1) + ", expected at most " + std::to_string(most_rows));
            return fail_if_any();
        }
        const auto cells = cells_of(line, separator_);
        if (cells.size() != columns_.size()) {
            const bool commas = separator_ == ',' && cells.size() == 2 * columns_.size();
            return complain(1, "has " + std::to_string(cells.size()) + " cells, the header has " +
                                   std::to_string(columns_.size()) + (commas ? decimal_commas : ""));
        }
        OutcomeRow row;
        row.line = lines_.line_number();
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const Column& column = columns_[i];
            if (column.role == Role::unread) continue;
            if (column.role == Role::outcome) {
                const auto outcome = outcome_of(cells[i].text);
                if (!outcome)
                    complain(cells[i].column, "outcome: is \"" + std::string(cells[i].text.substr(0, 40)) +
                                                  "\", expected stable, stick-slip, 0 and 1");
                row.stick_slip = outcome.value_or(false);
                continue;
            }
            double value = 0;
            if (!parse_cell(cells[i].text, value)) {
                complain(cells[i].column, column.name + ": is \"" + std::string(cells[i].text.substr(0, 40)) +
                                              "\", expected a finite number" +
                                              (has_decimal_comma(cells[i].text) ? decimal_commas : ""));
                continue;
            }
            if (std::isfinite(value)) value = column.unit.to_si(value);
            if (column.role == Role::amplitude) {
                if (std::isfinite(value) && value < 0)
                    complain(cells[i].column, "amplitude: is " + number_text(value) + ", expected ≥ 0");
                row.amplitude = value;
                continue;
            }
            if (std::isnan(value))
                complain(cells[i].column, column.name + ": is missing, every row needs its settings");
            else if (!column.range.holds(value))
                complain(cells[i].column,
                         column.name + ": is " + number_text(value) + ", expected " + describe(column.range));
            row.settings.push_back(value);
        }
        table_.rows.push_back(std::move(row));
    }

    std::string name_;
    const Joint& joint_;
    std::vector<std::string>& warnings_;
    LineStream lines_;
    OutcomeTable table_;
    std::vector<Column> columns_;
    std::vector<std::string> errors_;
    char separator_ = ',';
};

}  // namespace
}  // namespace files

bool is_outcome_file(const std::filesystem::path& file)
{
    files::LineStream lines(file);
    std::string_view line;
    if (!files::next_header(lines, line)) return false;
    bool outcome = false;
    for (const auto& cell : files::cells_of(line, files::separator_of(line))) {
        if (cell.text == "time") return false;
        outcome = outcome || cell.text == "outcome";
    }
    return outcome;
}

OutcomeTable read_outcomes(const std::filesystem::path& file, const Joint& joint, std::vector<std::string>& warnings)
{
    return files::OutcomeReader(file, joint, warnings).read();
}

}  // namespace stickslip
