#include "sweep/files/json/comparison_json.h"

#include "sweep/files/json/baseline_file.h"
#include "sweep/files/json/diagnosis_file.h"
#include "sweep/files/json/verdict_json.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/words/comparison_text.h"
#include "sweep/words/plain_text.h"

#include <fmt/format.h>

namespace stickslip {
namespace {

constexpr const char* baseline_format = "stickslip-gap-baseline/1";

Json number_json(const std::optional<FittedParameter>& number)
{
    if (!number) return nullptr;
    return {{"value", json_number(number->value)}, {"stderr", json_number(number->standard_error)}};
}

Json change_json(const NumberChange& c)
{
    return {{"name", c.name},
            {"of", name_of(c.of)},
            {"unit", c.unit},
            {"before", number_json(c.before)},
            {"after", number_json(c.after)},
            {"change", json_number(c.change)},
            {"standard_errors", json_number(c.standard_errors)},
            {"moved", c.moved(standard_errors_of_a_move)}};
}

}  // namespace

std::string name_of(GapRegression::Kind kind)
{
    using Kind = GapRegression::Kind;
    switch (kind) {
        case Kind::new_gap:
            return "new-gap";
        case Kind::grown:
            return "grown";
        case Kind::remainder:
            return "remainder";
        case Kind::new_cause:
            return "new-cause";
        case Kind::number_moved:
            return "number-moved";
        case Kind::no_answer:
            break;
    }
    return "no-answer";
}

std::string name_of(FoundNumber::Of of)
{
    if (of == FoundNumber::Of::sheet) return "sheet";
    return of == FoundNumber::Of::parameter ? "parameter" : "correction";
}

Json facts_json(const DiagnosisFacts& facts)
{
    Json json = {{"file", facts.source},
                 {"verdict", name_of(facts.verdict)},
                 {"interrupted", facts.interrupted},
                 {"causes", facts.causes},
                 {"probability", facts.causes.empty() ? Json() : json_number(facts.probability)},
                 {"ambiguous_with", facts.ambiguous_with},
                 {"gap",
                  {{"before", json_number(facts.overall.before)},
                   {"after", json_number(facts.overall.after)},
                   {"floor", json_number(facts.overall.floor)},
                   {"explained", json_number(facts.overall.explained)}}}};
    json["numbers"] = Json::array();
    for (const auto& found : facts.numbers)
        json["numbers"].push_back({{"name", found.number.name},
                                   {"of", name_of(found.of)},
                                   {"unit", found.number.unit},
                                   {"value", json_number(found.number.value)},
                                   {"stderr", json_number(found.number.standard_error)}});
    return json;
}

Json comparison_json(const DiagnosisComparison& c)
{
    Json json = {{"format", "stickslip-comparison/1"}, {"sentence", plain_text(comparison_sentence(c))}};
    json["gap"] = name_of(c.gap);
    json["causes"] = {
        {"appeared", c.appeared}, {"gone", c.gone}, {"kept", c.kept}, {"perhaps_the_same", c.perhaps_same_cause}};
    json["numbers"] = Json::array();
    for (const auto& change : c.numbers) json["numbers"].push_back(change_json(change));
    json["before"] = facts_json(c.before);
    json["after"] = facts_json(c.after);
    return json;
}

Json gap_check_json(const GapCheck& check)
{
    Json json = {{"format", "stickslip-gap-check/1"}, {"passes", check.passes()}};
    json["tolerance"] = {{"number", check.tolerance.number},
                         {"gap", check.tolerance.gap},
                         {"standard_errors", check.tolerance.standard_errors}};
    json["regressions"] = Json::array();
    for (const auto& r : check.regressions)
        json["regressions"].push_back(
            {{"kind", name_of(r.kind)}, {"name", r.name}, {"text", plain_text(regression_text(r, check.comparison))}});
    json["changed_joint"] = check.changed_joint;
    json["comparison"] = comparison_json(check.comparison);
    return json;
}

GapBaseline read_gap_baseline(const std::filesystem::path& file)
{
    if (!std::filesystem::exists(file))
        throw BadInput(file.string() + ": cannot be read; write a first baseline with --update");
    const Json json = read_json(file);
    const auto format = json.is_object() && json.contains("format") ? json.at("format").dump() : "missing";
    if (format != fmt::format("\"{}\"", baseline_format))
        throw BadInput(
            fmt::format("{}: is not a gap baseline: \"format\" is {}, expected \"{}\"; write it anew with "
                        "--update",
                        file.string(), format, baseline_format));
    try {
        return {json.at("joint").get<std::string>(), diagnosis_facts(json.at("diagnosis"), file.string())};
    } catch (const Json::exception&) {
        throw BadInput(file.string() + ": lacks joint or diagnosis; write it anew with --update");
    }
}

void write_gap_baseline(const std::filesystem::path& file, const std::string& joint, const std::string& diagnosis)
{
    const Json json = {{"format", baseline_format}, {"joint", joint}, {"diagnosis", Json::parse(diagnosis)}};
    write_whole(file, json.dump(1) + "\n");
}

void write_gap_junit(const std::filesystem::path& file, const std::string& joint, const GapCheck& check)
{
    std::string cases;
    for (const auto& r : check.regressions)
        cases += fmt::format("  <testcase classname=\"gap\" name=\"{}\"><failure message=\"{}\"/></testcase>\n",
                             escaped_xml(r.name.empty() ? name_of(r.kind) : r.name),
                             escaped_xml(regression_text(r, check.comparison)));
    if (check.passes()) cases = "  <testcase classname=\"gap\" name=\"no regression\"/>\n";
    const std::size_t failed = check.regressions.size();
    write_whole(file, fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"{}\" tests=\"{}\" "
                                  "failures=\"{}\">\n{}</testsuite>\n",
                                  escaped_xml(joint), failed ? failed : 1, failed, cases));
}

}  // namespace stickslip
