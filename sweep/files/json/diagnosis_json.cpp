#include "sweep/files/json/diagnosis_json.h"

#include "sweep/files/json/verdict_json.h"
#include "sweep/words/diagnosis_text.h"
#include "sweep/words/experiment_text.h"
#include "sweep/words/signature_text.h"

#include <cmath>
#include <stdexcept>

namespace stickslip {
namespace {

Json interval(const ConfidenceInterval& i)
{
    return Json::array({json_number(i.low), json_number(i.high)});
}

Json number_json(const FittedParameter& p)
{
    return {{"value", json_number(p.value)}, {"stderr", json_number(p.standard_error)}, {"unit", p.unit}};
}

Json parameters_json(const std::vector<FittedParameter>& all)
{
    Json parameters = Json::object();
    for (const auto& p : all) parameters[p.name] = number_json(p);
    return parameters;
}

Json values_json(const std::vector<SheetValue>& all)
{
    Json values = Json::object();
    for (const auto& v : all)
        values[v.key] = {{"value", json_number(v.value)},
                         {"interval", interval(v.interval)},
                         {"unit", v.unit},
                         {"pinned", v.pinned}};
    return values;
}

Json cause_json(const Cause& cause)
{
    Json json = {{"names", cause.names},
                 {"form", cause.form},
                 {"probability", json_number(cause.probability)},
                 {"parameters", parameters_json(cause.parameters)},
                 {"values", values_json(cause.values)},
                 {"heldout_gain", json_number(cause.heldout_gain)},
                 {"heldout_gain_interval", interval(cause.heldout_gain_interval)},
                 {"signature", cause.signature},
                 {"plausible", cause.plausible},
                 {"tell_tale", signature_text(cause.signatures)},
                 {"misfit", json_number(cause.misfit)}};
    if (std::isfinite(cause.force_gain)) {
        json["drive_force_gain"] = json_number(cause.force_gain);
        json["drive_force_gain_interval"] = interval(cause.force_gain_interval);
    }
    return json;
}

Json shares_json(const std::vector<Share>& shares)
{
    Json all = Json::array();
    for (const auto& s : shares)
        all.push_back({{"name", s.name},
                       {"share", json_number(s.share)},
                       {"interval", interval(s.interval)},
                       {"rms", json_number(s.rms)},
                       {"floor", json_number(s.floor)},
                       {"unit", s.unit}});
    return all;
}

/// The second method: rungs, corrections, what is explainable and what remains.
void add_ladder(const Diagnosis& d, Json& json)
{
    json["ladder"] = Json::array();
    for (const auto& rung : d.ladder)
        json["ladder"].push_back({{"names", rung.names},
                                  {"share", json_number(rung.share)},
                                  {"interval", interval(rung.interval)},
                                  {"parameters", parameters_json(rung.parameters)},
                                  {"ambiguous_with", rung.ambiguous_with},
                                  {"probability", json_number(rung.probability)}});
    json["corrections"] = Json::array();
    for (const auto& c : d.corrections) {
        Json correction = number_json(c.number);
        correction["name"] = c.name;
        correction["parameter"] = c.number.name;
        correction["prior"] = json_number(c.prior);
        json["corrections"].push_back(std::move(correction));
    }
    json["corrected_share"] = json_number(d.corrected_share);
    json["ceiling"] = {{"share", json_number(d.ceiling.share)},
                       {"interval", interval(d.ceiling.interval)},
                       {"depends_on", d.ceiling.depends_on}};
    json["remainder"] = {{"share", json_number(d.remainder.share)}, {"structure", d.remainder.structure}};
}

/// Causes that stay possible, and what they promise.
Json set_json(const CauseSet& set)
{
    Json also = Json::array();
    if (set.no_gap) also.push_back("no-gap");
    if (set.none_of_these) also.push_back("none-of-these");
    return {{"names", set.names},
            {"also", also},
            {"coverage", set.coverage},
            {"confidence", set.confidence},
            {"holds", name_of(set.holds)},
            {"cases", set.cases},
            {"uncalibrated", set.uncalibrated},
            {"population", set.population}};
}

/// Of long records: which rows were fitted.
Json rows_json(const FittedRows& rows)
{
    Json stretches = Json::array();
    for (const auto& s : rows.stretches)
        stretches.push_back({{"file", s.file}, {"from", json_number(s.from)}, {"to", json_number(s.to)}});
    return {{"fitted", rows.fitted}, {"all", rows.all}, {"stretches", stretches}};
}

/// Sentences for people, and beside each its code for programs.
void add_notes(Json& json, const char* sentences, const char* codes, const std::vector<Note>& notes)
{
    json[sentences] = Json::array(), json[codes] = Json::array();
    for (const auto& note : notes)
        json[sentences].push_back(note_text(note)), json[codes].push_back(name_of(note.code));
}

}  // namespace

Json windows_json(const StableWindows& w)
{
    if (!w.refused.empty()) return {{"reason", w.refused}, {"reason_code", "not-computed"}};
    Json stable = Json::array();
    for (const auto& i : w.k_p) stable.push_back({json_number(i.low), json_number(i.high)});
    return {{"V0", json_number(w.V0)},
            {"velocity_only_k_v_min", json_number(w.k_v_min)},
            {"state_variable_stable", w.stable},
            {"spectral_abscissa", json_number(w.spectral_abscissa)},
            {"stable_k_p", stable},
            {"k_cr", json_number(w.k_cr)}};
}

Json diagnosis_json(const Diagnosis& d, const WindowsOfBoth& windows)
{
    if (d.verdict == Verdict::gap && d.overall.worse())
        throw std::logic_error("a diagnosis names a cause that makes held-out data worse");
    Json json;
    json["format"] = "stickslip-diagnosis/2";
    json["verdict"] = name_of(d.verdict);
    if (d.interrupted) json["interrupted"] = true;
    add_notes(json, "reasons", "reason_codes", d.reasons);
    json["records"] = Json::array();
    for (const auto& r : d.records) json["records"].push_back({{"file", r.file}, {"role", r.role}});
    if (!d.rows.stretches.empty()) json["rows"] = rows_json(d.rows);
    json["where"] = {{"signals", shares_json(d.signals)}, {"regimes", shares_json(d.regimes)}};
    json["effects"] = Json::array();
    for (const auto& c : d.effects) json["effects"].push_back(cause_json(c));
    json["none_of_these"] = json_number(probability_of_none(d));
    json["ambiguous_with"] = d.ambiguous_with;
    if (d.set) json["set"] = set_json(*d.set);
    Json separates = Json::array();
    for (const auto& [one, two] : d.next_experiment.separates) separates.push_back({one, two});
    json["next_experiment"] = {{"description", motion_text(d.next_experiment.motion)},
                               {"file", d.next_experiment.reference.empty() ? "" : "next-experiment.csv"},
                               {"separates", separates},
                               {"distance", json_number(d.next_experiment.distance)}};
    Json gap = Json::object();
    for (const auto& g : d.gap)
        gap[g.signal] = {{"unit", g.unit},
                         {"before", json_number(g.before)},
                         {"after", json_number(g.after)},
                         {"floor", json_number(g.floor)},
                         {"explained", json_number(g.explained)}};
    gap["overall"] = {{"before", json_number(d.overall.before)},
                      {"after", json_number(d.overall.after)},
                      {"floor", json_number(d.overall.floor)},
                      {"explained", json_number(d.overall.explained)},
                      {"interval", interval(d.overall.interval)}};
    json["gap"] = gap;
    if (d.drive_force.corner > 0)
        json["drive_force"] = {{"unit", d.drive_force.unit},
                               {"below_hz", json_number(d.drive_force.corner)},
                               {"before", json_number(d.drive_force.before)},
                               {"after", json_number(d.drive_force.after)}};
    add_ladder(d, json);
    json["boundary"] = {{"before", windows_json(windows.before)}, {"after", windows_json(windows.after)}};
    add_notes(json, "notes", "note_codes", d.notes);
    return json;
}

}  // namespace stickslip
