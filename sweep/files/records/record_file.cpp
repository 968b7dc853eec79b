#include "sweep/files/records/record_file.h"

#include "analysis/diagnosis/audit/prepare.h"
#include "sweep/files/records/impossible_signals.h"
#include "sweep/files/records/record_checks.h"
#include "sweep/files/records/record_header.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/csv_cells.h"
#include "sweep/files/text/header_row.h"
#include "sweep/files/text/toml_input.h"
#include "sweep/words/suspicion_text.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace files {
namespace {

constexpr std::size_t max_errors = 20;

class RecordReader {
  public:
    RecordReader(const std::filesystem::path& file, const Joint& joint, const RecordLayout& layout,
                 const RecordLimits& limits)
        : name_(file.string()),
          joint_(joint),
          rule_(layout.rule_for(file.filename().string())),
          limits_(limits),
          lines_(file)
    {
        reading_.record.name = file.filename().string();
        reading_.record.overrides = rule_.overrides;
        if (rule_.at_rest_at_start) reading_.record.at_rest_at_start = *rule_.at_rest_at_start;
    }

    RecordReading read()
    {
        try {
            read_header();
            read_rows();
            fail_if_any();
            finish();
        } catch (const BadInput&) {
            if (rows_ <= limits_.rows) lines_.verify_archive();
            throw;
        }
        return std::move(reading_);
    }

  private:
    /// A column of the file that is read: which signal, and where its values go.
    struct Slot {
        const Signal* signal = nullptr;
        Scaling scaling;
        std::vector<double>* values = nullptr;
        std::uint64_t missing = 0, first_missing_line = 0, first_missing_column = 0;
    };

    void complain(std::uint64_t line, std::size_t column, const std::string& text)
    {
        if (errors_.size() == max_errors) {
            errors_.push_back(name_ + ": and more; only the first " + std::to_string(max_errors) + " errors are shown");
            fail_if_any();
        }
        errors_.push_back(name_ + ":" + std::to_string(line) + ":" + std::to_string(column) + ": " + text);
    }
    void fail_if_any() const
    {
        if (!errors_.empty()) throw BadInput(errors_);
    }
    /// A wrong file is named as such, not as a thousand cells that are no numbers.
    void reject_binary(std::string_view text, std::uint64_t line)
    {
        std::size_t column = 1;
        for (std::size_t i = 0; i < text.size(); ++i, ++column) {
            const auto c = static_cast<unsigned char>(text[i]);
            if (c == '\n') {
                ++line;
                column = 0;
            } else if (c < 0x20 && c != '\t' && c != '\r') {
                if (c == 0 && (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")))
                    throw BadInput(name_ + ": is written in UTF-16, expected UTF-8; save it again with that encoding");
                throw BadInput(name_ + ":" + std::to_string(line) + ":" + std::to_string(column) +
                               ": is not text, expected a CSV table (plain or gzip)");
            }
        }
    }

    void read_header()
    {
        reject_binary(lines_.head(), 1);
        std::string_view line;
        if (!next_header(lines_, line))
            throw BadInput(name_ + ": is empty, expected a header row such as time,position");
        RecordHeader header = match_header(line, {name_, lines_.line_number()}, rule_, joint_);
        if (!header.errors.empty()) throw BadInput(header.errors);
        separator_ = header.separator;
        reading_.warnings = std::move(header.warnings);
        reading_.no_position = std::move(header.no_position);
        for (const auto& column : header.columns) slots_.push_back({column.signal, column.scaling});
    }

    void read_rows()
    {
        for (auto& slot : slots_)
            if (slot.signal) slot.values = &(reading_.record.*slot.signal->column);
        std::string_view line;
        while (lines_.next(line)) {
            if (trimmed(line).empty() || trimmed(line).starts_with('#')) continue;
            if (line == last_line_) {  // a logger that held a row says nothing new
                ++repeated_;
                continue;
            }
            last_line_ = line;
            if (++rows_ > limits_.rows)
                throw BadInput(name_ + ":" + std::to_string(lines_.line_number()) + ":1: has more than " +
                               std::to_string(limits_.rows) + " rows, split the record or keep every n-th row");
            read_row(line);
        }
        if (rows_ == 0 && errors_.empty()) throw BadInput(name_ + ": has a header and no rows");
        if (repeated_ > 0)
            reading_.warnings.push_back(std::to_string(repeated_) +
                                        " rows repeat the row before, its time included: they were removed");
    }

    void read_row(std::string_view line)
    {
        std::size_t i = 0, from = 0;
        bool more = true;
        while (more) {
            std::size_t to = line.find(separator_, from);
            more = to != std::string_view::npos;
            if (!more) to = line.size();
            if (i < slots_.size() && slots_[i].signal) read_cell(line.substr(from, to - from), from + 1, slots_[i]);
            from = to + 1;
            ++i;
        }
        if (i != slots_.size()) {
            reject_binary(line, lines_.line_number());
            const bool commas = separator_ == ',' && i == 2 * slots_.size();
            complain(lines_.line_number(), 1,
                     "has " + std::to_string(i) + " cells, the header has " + std::to_string(slots_.size()) +
                         (commas ? decimal_commas : ""));
        }
    }

    void read_cell(std::string_view cell, std::size_t column, Slot& slot)
    {
        double value = 0;
        if (!parse_cell(cell, value)) {
            reject_binary(cell, lines_.line_number());
            complain(lines_.line_number(), column,
                     std::string(slot.signal->name) + ": is \"" + std::string(cell.substr(0, 40)) +
                         "\", expected a finite number or an empty cell" +
                         (has_decimal_comma(cell) ? decimal_commas : ""));
        } else if (std::isnan(value)) {
            if (slot.missing++ == 0) slot.first_missing_line = lines_.line_number(), slot.first_missing_column = column;
        } else {
            value = slot.scaling(value);
        }
        if (slot.values == &reading_.record.time) check_time(value, column);
        if (slot.values == &reading_.record.torque_enable && !std::isnan(value) && value != 0 && value != 1)
            complain(lines_.line_number(), column, "torque_enable: is " + number_text(value) + ", expected 0 and 1");
        slot.values->push_back(value);
    }

    void check_time(double time, std::size_t column)
    {
        if (std::isnan(time)) return complain(lines_.line_number(), column, "time: is missing, every row needs one");
        if (time <= last_time_)
            complain(lines_.line_number(), column,
                     "time: is " + number_text(time) +
                         (time == last_time_ ? ", the same as in the row before"
                                             : ", earlier than " + number_text(last_time_) + " before") +
                         "; expected ascending time");
        last_time_ = time;
    }

    void finish()
    {
        Record& record = reading_.record;
        bool measured = false;
        for (const auto& slot : slots_) {
            if (!slot.signal || slot.missing == 0) {
                measured = measured || (slot.signal && slot.signal->measured);
                continue;
            }
            const bool all = slot.missing == rows_;
            if (all) slot.values->clear();  // a column without a value was not logged
            measured = measured || (slot.signal->measured && !all);
            const std::string signal(slot.signal->name);
            if (!all)
                reading_.missing.emplace_back(signal, name_ + ":" + std::to_string(slot.first_missing_line) + ":" +
                                                          std::to_string(slot.first_missing_column) + ": " + signal +
                                                          ": is missing, as in " + std::to_string(slot.missing) +
                                                          " of " + std::to_string(rows_) + " rows");
            reading_.warnings.push_back(
                signal + ": " +
                (all ? "every cell is" : std::to_string(slot.missing) + " of " + std::to_string(rows_) + " cells are") +
                " missing");
        }
        if (!measured) throw BadInput(name_ + ": every measured signal is missing in every row");
        for (const auto& [signal, value] : rule_.constants) {
            auto& values = record.*signal_named(signal)->column;
            if (values.empty())
                values.assign(record.rows(), value);
            else
                reading_.warnings.push_back(
                    signal + ": the file has this column, the constant of [record.constants] is not used");
        }
        if (!record.position.empty()) reading_.no_position.clear();
        const auto named = [this](std::string_view signal) {  // its unit
            return std::ranges::any_of(rule_.columns, [&](auto& c) { return c.signal == signal && c.unit_named; });
        };
        auto& found = reading_.suspicions = impossible_signals(record, gap::joint_in(record, joint_), named("time"));
        if (found.empty()) found = suspicions(record, joint_, named("position"));  // every rate would be doubtful, too
    }

    std::string name_;
    const Joint& joint_;
    RecordLayout::Rule rule_;
    RecordLimits limits_;
    LineStream lines_;
    RecordReading reading_;
    std::vector<std::string> errors_;
    std::vector<Slot> slots_;
    char separator_ = ',';
    std::uint64_t rows_ = 0, repeated_ = 0;
    std::string last_line_;
    double last_time_ = -infinity;
};

}  // namespace
}  // namespace files

std::vector<std::string> RecordReading::sentences() const
{
    auto all = warnings;
    for (const auto& suspicion : suspicions) all.push_back(suspicion_text(suspicion));
    return all;
}

RecordReading read_record(const std::filesystem::path& file, const Joint& joint, const RecordLayout& layout,
                          const RecordLimits& limits)
{
    return files::RecordReader(file, joint, layout, limits).read();
}

}  // namespace stickslip
