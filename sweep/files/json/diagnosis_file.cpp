#include "sweep/files/json/diagnosis_file.h"

#include "analysis/results/point.h"
#include "sweep/files/text/bad_input.h"

#include <fmt/format.h>

#include <fstream>

namespace stickslip {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format_name = "stickslip-diagnosis/2";

/// Of the normal distribution, from the middle to either end of a 95 % interval.
constexpr double errors_to_the_end = 1.959964;

double number_or_nan(const Json& json)
{
    return json.is_null() ? missing : json.get<double>();
}

Verdict verdict_named(const std::string& name)
{
    for (const auto v : {Verdict::gap, Verdict::no_gap, Verdict::unknown, Verdict::insufficient_data})
        if (name_of(v) == name) return v;
    throw std::invalid_argument("verdict is \"" + name + "\", expected gap, no-gap, unknown or insufficient-data");
}

FoundNumber number_from(FoundNumber::Of of, const std::string& name, const Json& json)
{
    return {
        of,
        {name, number_or_nan(json.at("value")), number_or_nan(json.at("stderr")), json.at("unit").get<std::string>()}};
}

void add_cause(const Json& cause, DiagnosisFacts& facts)
{
    facts.causes = cause.at("names").get<std::vector<std::string>>();
    facts.probability = number_or_nan(cause.at("probability"));
    for (const auto& [name, value] : cause.at("values").items()) {
        if (!value.at("pinned").get<bool>()) continue;
        const auto& ends = value.at("interval");
        const double error = (number_or_nan(ends.at(1)) - number_or_nan(ends.at(0))) / (2 * errors_to_the_end);
        facts.numbers.push_back({FoundNumber::Of::sheet,
                                 {name, number_or_nan(value.at("value")), error, value.at("unit").get<std::string>()}});
    }
    for (const auto& [name, value] : cause.at("parameters").items())
        facts.numbers.push_back(number_from(FoundNumber::Of::parameter, name, value));
}

void add_gap(const Json& gap, DiagnosisFacts& facts)
{
    for (const auto& [signal, g] : gap.items()) {
        if (signal == "overall") continue;
        facts.gap.push_back({signal, g.at("unit").get<std::string>(), number_or_nan(g.at("before")),
                             number_or_nan(g.at("after")), number_or_nan(g.at("floor")),
                             number_or_nan(g.at("explained"))});
    }
    const auto& all = gap.at("overall");
    facts.overall.before = number_or_nan(all.at("before"));
    facts.overall.after = number_or_nan(all.at("after"));
    facts.overall.floor = number_or_nan(all.at("floor"));
    facts.overall.explained = number_or_nan(all.at("explained"));
}

DiagnosisFacts facts_from(const Json& json)
{
    DiagnosisFacts facts;
    facts.verdict = verdict_named(json.at("verdict").get<std::string>());
    facts.interrupted = json.value("interrupted", false);
    facts.ambiguous_with = json.at("ambiguous_with").get<std::vector<std::vector<std::string>>>();
    // an answer without a gap that it can name may still list candidates: they were not found
    if (facts.verdict == Verdict::gap && !json.at("effects").empty()) add_cause(json.at("effects").at(0), facts);
    for (const auto& c : json.at("corrections"))
        facts.numbers.push_back(number_from(FoundNumber::Of::correction, c.at("parameter").get<std::string>(), c));
    add_gap(json.at("gap"), facts);
    return facts;
}

}  // namespace

Json read_json(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    if (!in) throw BadInput(file.string() + ": cannot be read");
    try {
        return Json::parse(in);
    } catch (const Json::parse_error& e) {
        throw BadInput(fmt::format("{}: is not complete JSON; reading stopped at byte {}", file.string(), e.byte));
    } catch (const Json::out_of_range&) {
        throw BadInput(file.string() + ": has a number beyond the largest that a double holds, 1.8e308");
    }
}

DiagnosisFacts diagnosis_facts(const Json& json, const std::string& source)
{
    const auto format = json.is_object() && json.contains("format") ? json.at("format").dump() : "missing";
    if (format != fmt::format("\"{}\"", format_name))
        throw BadInput(
            fmt::format("{}: is not a diagnosis: \"format\" is {}, expected \"{}\"", source, format, format_name));
    try {
        auto facts = facts_from(json);
        facts.source = source;
        return facts;
    } catch (const Json::exception&) {  // the library's own words are for programmers
        throw BadInput(source +
                       ": lacks a field of diagnosis.json, or has it in another form; expected what "
                       "docs/schema/diagnosis.schema.json says");
    } catch (const std::invalid_argument& e) {
        throw BadInput(source + ": " + e.what());
    }
}

DiagnosisFacts read_diagnosis(const std::filesystem::path& path)
{
    const auto file = std::filesystem::is_directory(path) ? path / "diagnosis.json" : path;
    if (!std::filesystem::exists(file))
        throw BadInput(file.string() +
                       ": there is no such file; expected diagnosis.json, or the folder that "
                       "`stickslip diagnose -o` wrote");
    return diagnosis_facts(read_json(file), file.string());
}

}  // namespace stickslip
