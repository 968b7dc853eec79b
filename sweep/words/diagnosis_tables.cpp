#include "sweep/words/diagnosis_tables.h"

#include "analysis/results/point.h"
#include "analysis/results/text.h"
#include "sweep/words/cause_text.h"
#include "sweep/words/diagnosis_text.h"
#include "sweep/words/effect_words.h"
#include "sweep/words/signature_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

std::string number(double value)
{
    return plain_number(value, 4);
}

ShareBar bar_of(double share)
{
    return {share, missing, missing};
}

std::string ranged(double value, const ConfidenceInterval& interval)
{
    if (!std::isfinite(value)) return "–";
    if (!std::isfinite(interval.low)) return whole_percent(value);
    return fmt::format("{} ({} … {})", whole_percent(value), whole_percent(interval.low), whole_percent(interval.high));
}

/// "178.5 µm": in the unit that suits a number of another size, so that a row has one.
std::string with_prefix(double value, double like, const std::string& unit)
{
    const ScaledUnit scaled = scaled_unit(std::abs(like), unit);
    return number(value / scaled.size) + (scaled.text.empty() ? "" : " " + scaled.text);
}

/// How the data were held out: no fault of theirs.
bool is_of_method(const Note& note)
{
    using Code = Note::Code;
    constexpr Code method[] = {Code::held_out_in_turn, Code::thirds_in_turn, Code::rest_held_out,
                               Code::rig_blocks_in_turn, Code::fifths_in_turn};
    return std::ranges::find(method, note.code) != std::end(method);
}

}  // namespace

std::string signal_words(const std::string& column)
{
    if (column == "effort_command") return "commanded effort";
    if (column == "effort_measured") return "measured effort";
    std::string words = column;
    std::ranges::replace(words, '_', ' ');
    return words;
}

std::string parameter_words(const std::string& name)
{
    const auto dot = name.find('.');
    if (dot == std::string::npos) return name;
    std::string own = name.substr(dot + 1);
    std::ranges::replace(own, '_', ' ');
    return effect_words(name.substr(0, dot)) + ": " + own;
}

std::string together(const std::vector<std::string>& names)
{
    std::string text;
    for (const auto& name : names) text += (text.empty() ? "" : " with ") + effect_words(name);
    return text;
}

std::string whole_percent(double part)
{
    return std::isfinite(part) ? fmt::format("{:.0f} %", 100 * part) : "–";
}

Table causes_table(const Diagnosis& d)
{
    Table t{"Causes, most probable first",
            {"cause", "probability", "held-out gain", "its signature is present", "plausible", "form",
             "misfit (0 is noise)"},
            {}};
    t.bar_column = 1;
    const bool forces = d.drive_force.corner > 0;
    if (forces)
        t.columns.insert(t.columns.begin() + 3,
                         fmt::format("of the drive force below {:.0f} Hz", d.drive_force.corner));
    for (const auto& c : d.effects) {
        const bool held = std::isfinite(c.heldout_gain_interval.low) || c.heldout_gain != 0;
        t.rows.push_back({together(c.names), fmt::format("{:.3f}", c.probability),
                          held ? ranged(c.heldout_gain, c.heldout_gain_interval) : "not held out",
                          c.signature ? "yes" : "no", c.plausible ? "yes" : "no",
                          c.form.empty() ? "–" : effect_words(c.form), number(c.misfit)});
        t.bars.push_back(bar_of(c.probability));
        if (forces) {
            auto& row = t.rows.back();
            row.insert(row.begin() + 3, ranged(c.force_gain, c.force_gain_interval));
        }
    }
    constexpr double visible = 5e-4;
    if (const double none = probability_of_none(d); none > visible) {
        t.rows.push_back({"none of these", fmt::format("{:.3f}", none)});
        t.bars.push_back(bar_of(none));
        t.rows.back().resize(t.columns.size(), "–");
    }
    return t;
}

Table parameters_table(const Diagnosis& d)
{
    Table t{"Parameters of the first cause, ± standard error", {"parameter", "value"}, {}};
    if (!d.effects.empty())
        for (const auto& p : d.effects[0].parameters)
            t.rows.push_back({parameter_words(p.name), with_error(p.value, p.standard_error, p.unit)});
    return t;
}

std::string value_text(const SheetValue& v)
{
    if (!v.pinned) return "not pinned by these records";
    const double largest = std::max({std::abs(v.value), std::abs(v.interval.low), std::abs(v.interval.high)});
    const ScaledUnit scaled = scaled_unit(largest, v.unit);
    // two digits of the interval's width, so that value and ends stand with the same decimals
    constexpr int most_decimals = 6, digits = 4;
    constexpr double longest = 1e6;
    const double width = (v.interval.high - v.interval.low) / scaled.size;
    const int decimals = width > 0 ? 1 - static_cast<int>(std::floor(std::log10(width))) : most_decimals + 1;
    const bool fixed = decimals <= most_decimals && largest / scaled.size < longest;
    const auto text = [&](double value) {
        const double shown = value / scaled.size;
        if (!fixed) return plain_number(shown, digits);
        const std::string number = fmt::format("{:.{}f}", std::abs(shown), std::max(decimals, 0));
        const bool zero = number.find_first_of("123456789") == std::string::npos;
        return (shown < 0 && !zero ? "−" : "") + number;
    };
    const auto unit = scaled.text.empty() ? "" : " " + scaled.text;
    return fmt::format("{} ({} … {}){}", text(v.value), text(v.interval.low), text(v.interval.high), unit);
}

Table values_table(const Diagnosis& d)
{
    Table t{"Parameters of the joint with the first cause", {"parameter", "value, 95 % interval"}, {}};
    if (!d.effects.empty())
        for (const auto& v : d.effects[0].values) t.rows.push_back({sheet_label(v.key), value_text(v)});
    return t;
}

Table shares_table(const char* title, const std::vector<Share>& shares)
{
    const bool multiples = std::ranges::all_of(shares, [](const Share& s) { return s.unit == "floors"; });
    Table t{title, {"where", "share of the gap", "95 % interval"}, {}};
    t.bar_column = 1;
    if (multiples)
        t.columns.emplace_back("RMS, × the prediction floor");
    else
        t.columns.insert(t.columns.end(), {"RMS", "prediction floor"});
    for (const auto& s : shares) {
        t.rows.push_back(
            {s.name, whole_percent(s.share), whole_percent(s.interval.low) + " … " + whole_percent(s.interval.high)});
        t.bars.push_back({s.share, s.interval.low, s.interval.high});
        if (multiples)
            t.rows.back().push_back(plain_number(s.rms, 3));
        else
            for (const double value : {s.rms, s.floor}) t.rows.back().push_back(with_prefix(value, value, s.unit));
    }
    return t;
}

Table gap_table(const Diagnosis& d)
{
    Table t{"Measured against simulated, held-out data", {"signal", "before", "after", "noise floor", "explained"}, {}};
    constexpr double beyond_floor = 1.1;  // less is no gap, and a part of it no number
    for (const auto& g : d.gap)
        t.rows.push_back({signal_words(g.signal), with_prefix(g.before, g.before, g.unit),
                          with_prefix(g.after, g.before, g.unit), with_prefix(g.floor, g.before, g.unit),
                          g.before > beyond_floor * g.floor ? whole_percent(g.explained) : "no gap here"});
    t.rows.push_back({"overall, × the noise floor", number(d.overall.before), number(d.overall.after),
                      number(d.overall.floor), ranged(d.overall.explained, d.overall.interval)});
    if (d.drive_force.corner > 0)
        t.rows.push_back({fmt::format("drive force below {:.0f} Hz, the nuisance parameters of the joint refitted",
                                      d.drive_force.corner),
                          with_prefix(d.drive_force.before, d.drive_force.before, d.drive_force.unit),
                          with_prefix(d.drive_force.after, d.drive_force.before, d.drive_force.unit), "–",
                          whole_percent(1 - d.drive_force.after / d.drive_force.before) + " of the RMS"});
    return t;
}

Table records_table(const Diagnosis& d)
{
    Table t{"Records", {"file", "role"}, {}};
    for (const auto& r : d.records) t.rows.push_back({r.file, r.role});
    return t;
}

std::string method_text(const Diagnosis& d)
{
    std::string text;
    for (const auto& note : d.notes)
        if (is_of_method(note)) text += (text.empty() ? "" : " ") + note_sentence(note);
    return text;
}

std::vector<std::string> gathered_notes(const Diagnosis& d)
{
    const auto one_of_several = [&](const Note& note) {
        return std::any_of(d.records.begin(), d.records.end(), [&](const auto& r) { return r.file == note.record; });
    };
    const auto said_as_reason = [&](const Note& note) {
        return std::find(d.reasons.begin(), d.reasons.end(), note) != d.reasons.end();
    };
    struct Counted {
        Note common;  ///< without the record
        const Note* first;
        int count;
    };
    std::vector<Counted> counted;
    for (const auto& note : d.notes) {
        if (said_as_reason(note) || is_of_method(note)) continue;
        Note common = note;
        if (one_of_several(note)) common.record.clear();
        const auto same =
            std::find_if(counted.begin(), counted.end(), [&](const auto& other) { return other.common == common; });
        if (same != counted.end())
            ++same->count;
        else
            counted.push_back({std::move(common), &note, 1});
    }
    std::vector<std::string> notes;
    for (const auto& c : counted)
        notes.push_back(c.count == 1
                            ? note_sentence(*c.first)
                            : fmt::format("{} of {} records: {}.", c.count, d.records.size(), note_text(c.common)));
    return notes;
}

}  // namespace stickslip
