#include "sweep/words/diagnosis_tables.h"

#include "analysis/results/point.h"
#include "analysis/results/text.h"
#include "sweep/words/cause_text.h"
#include "sweep/words/diagnosis_text.h"
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

}  // namespace

std::string together(const std::vector<std::string>& names)
{
    return fmt::format("{}", fmt::join(names, " with "));
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
                          c.signature ? "yes" : "no", c.plausible ? "yes" : "no", c.form.empty() ? "–" : c.form,
                          number(c.misfit)});
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
            t.rows.push_back({p.name, with_error(p.value, p.standard_error, p.unit)});
    return t;
}

std::string value_text(const SheetValue& v)
{
    if (!v.pinned) return "not pinned by these records";
    // as many digits as show the interval
    constexpr int least = 4, most = 9;
    const double parts = std::min(std::abs(v.value) / (v.interval.high - v.interval.low), std::pow(10, most));
    const int digits = parts > 1 ? std::clamp(static_cast<int>(std::log10(parts)) + 2, least, most) : least;
    const auto text = [&](double value) { return plain_number(value, digits); };
    const auto unit = v.unit.empty() ? "" : " " + v.unit;
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
    Table t{title, {"where", "share of the gap", "95 % interval", "RMS", "prediction floor", "unit"}, {}};
    t.bar_column = 1;
    for (const auto& s : shares) {
        t.rows.push_back({s.name, whole_percent(s.share),
                          whole_percent(s.interval.low) + " … " + whole_percent(s.interval.high), number(s.rms),
                          number(s.floor), s.unit});
        t.bars.push_back({s.share, s.interval.low, s.interval.high});
    }
    return t;
}

Table gap_table(const Diagnosis& d)
{
    Table t{"Measured against simulated, held-out data",
            {"signal", "before", "after", "noise floor", "explained", "unit"},
            {}};
    constexpr double beyond_floor = 1.1;  // less is no gap, and a part of it no number
    for (const auto& g : d.gap)
        t.rows.push_back({g.signal, number(g.before), number(g.after), number(g.floor),
                          g.before > beyond_floor * g.floor ? whole_percent(g.explained) : "no gap here", g.unit});
    t.rows.push_back({"overall", number(d.overall.before), number(d.overall.after), number(d.overall.floor),
                      ranged(d.overall.explained, d.overall.interval), "× noise floor"});
    if (d.drive_force.corner > 0)
        t.rows.push_back({fmt::format("drive force below {:.0f} Hz, the nuisance parameters of the joint refitted",
                                      d.drive_force.corner),
                          number(d.drive_force.before), number(d.drive_force.after), "–",
                          whole_percent(1 - d.drive_force.after / d.drive_force.before) + " of the RMS",
                          d.drive_force.unit});
    return t;
}

Table records_table(const Diagnosis& d)
{
    Table t{"Records", {"file", "role"}, {}};
    for (const auto& r : d.records) t.rows.push_back({r.file, r.role});
    return t;
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
        if (said_as_reason(note)) continue;
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
                            ? note_text(*c.first)
                            : fmt::format("{} of {} records: {}", c.count, d.records.size(), note_text(c.common)));
    return notes;
}

}  // namespace stickslip
