#include "sweep/files/json/baseline_file.h"

#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/whole_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <sstream>

namespace stickslip {
namespace {

using Json = nlohmann::ordered_json;
constexpr const char *format_name = "stickslip-baseline/1", *earlier_name = "stickslip baseline 1";

Json json_of(const WatchedBoundary& w)
{
    Json at = Json::object();
    for (const auto& [path, value] : w.at) at[path] = value;
    return {{"theory", w.theory},
            {"axis", w.axis},
            {"number", w.number},
            {"at", at},
            {"value", w.point.value},
            {"unit", w.unit},
            {"low", w.point.low},
            {"high", w.point.high},
            {"direction", w.point.direction},
            {"tolerance", w.tolerance}};
}

WatchedBoundary boundary_from(const Json& json)
{
    WatchedBoundary w;
    w.theory = json.at("theory").get<std::string>();
    w.axis = json.at("axis").get<std::string>();
    w.number = json.at("number").get<int>();
    for (const auto& [path, value] : json.at("at").items()) w.at.emplace_back(path, value.get<double>());
    w.point.value = json.at("value").get<double>();
    w.unit = json.at("unit").get<std::string>();
    w.point.low = json.at("low").get<double>();
    w.point.high = json.at("high").get<double>();
    w.point.direction = json.at("direction").get<int>();
    w.tolerance = json.at("tolerance").get<double>();
    if (!std::isfinite(w.point.value) || !(w.tolerance >= 0))
        throw std::invalid_argument("value and tolerance must be finite, tolerance ≥ 0");
    if (!(w.point.low <= w.point.value && w.point.value <= w.point.high))
        throw std::invalid_argument(
            fmt::format("low ≤ value ≤ high is wanted, got {} ≤ {} ≤ {}", w.point.low, w.point.value, w.point.high));
    return w;
}

const char* side(const WatchedBoundary& w)
{
    return w.point.direction < 0 ? "above" : w.point.direction > 0 ? "below" : "on an unknown side, at";
}

}  // namespace

std::string escaped_xml(const std::string& text)
{
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '"')
            out += "&quot;";
        else
            out += c;
    }
    return out;
}

std::vector<WatchedBoundary> read_baseline(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    if (!in) throw BadInput(fmt::format("{}: cannot be read; write a first baseline with --update", file.string()));
    std::vector<WatchedBoundary> watched;
    try {
        const Json json = Json::parse(in);
        if (json.at("format") != format_name && json.at("format") != earlier_name)
            throw BadInput(fmt::format("{}: is not a baseline of this program: \"format\" is {}, expected \"{}\"",
                                       file.string(), json.at("format").dump(), format_name));
        const auto& entries = json.at("boundaries");
        for (const auto& entry : entries) {
            try {
                watched.push_back(boundary_from(entry));
            } catch (const Json::exception& e) {
                throw std::invalid_argument(e.what());
            }
        }
    } catch (const Json::exception& e) {
        const auto* broken = dynamic_cast<const Json::parse_error*>(&e);  // the library's own words are for programmers
        const std::size_t at_byte = broken ? broken->byte : 0;
        throw BadInput(
            fmt::format("{}: is not a baseline of this program: it is not complete JSON, or lacks a field{}; write "
                        "it anew with --update",
                        file.string(), at_byte > 0 ? fmt::format("; reading stopped at byte {}", at_byte) : ""));
    } catch (const std::invalid_argument& e) {
        throw BadInput(fmt::format("{}: boundaries[{}]: {}", file.string(), watched.size(), e.what()));
    }
    return watched;
}

std::map<std::string, double> read_baseline_numbers(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    std::map<std::string, double> numbers;
    try {
        const Json json = Json::parse(in);
        if (!json.contains("numbers")) return {};
        for (const auto& [path, value] : json.at("numbers").items()) numbers[path] = value.get<double>();
    } catch (const Json::exception&) {
        throw BadInput(fmt::format(
            "{}: numbers: is not a list of paths with a number each; write it anew with --update", file.string()));
    }
    return numbers;
}

std::optional<bool> read_baseline_design(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    const Json json = Json::parse(in, nullptr, false);
    if (!json.is_object() || !json.contains("design_stable") || json["design_stable"].is_null()) return {};
    if (!json["design_stable"].is_boolean())
        throw BadInput(fmt::format("{}: design_stable: is {}, expected true, false or null", file.string(),
                                   json["design_stable"].dump()));
    return json["design_stable"].get<bool>();
}

void write_baseline(const std::filesystem::path& file, const std::string& title,
                    const std::vector<WatchedBoundary>& watched, const std::map<std::string, double>& numbers,
                    std::optional<bool> design_stable)
{
    Json json = {{"format", format_name},
                 {"title", title},
                 {"numbers", numbers},
                 {"design_stable", design_stable ? Json(*design_stable) : Json(nullptr)},
                 {"boundaries", Json::array()}};
    for (const auto& w : watched) json["boundaries"].push_back(json_of(w));
    write_whole(file, json.dump(1) + "\n");
}

std::string describe(const Deviation& d)
{
    const auto& s = d.stored;
    switch (d.kind) {
        case Deviation::Kind::vanished:
            return fmt::format("vanished: was at {:.9g} {}", s.point.value, s.unit);
        case Deviation::Kind::appeared:
            return fmt::format("appeared at {:.9g} {}: not in the baseline", d.now.point.value, d.now.unit);
        case Deviation::Kind::moved:
            return fmt::format("moved by {:.1e} (allowed {:.1e}): {:.9g} → {:.9g} {}", d.relative, s.tolerance,
                               s.point.value, d.now.point.value, s.unit);
        case Deviation::Kind::changed:
            return s.unit != d.now.unit
                       ? fmt::format("changed: the baseline counts in {}, this program in {}: {:.9g} → {:.9g}", s.unit,
                                     d.now.unit, s.point.value, d.now.point.value)
                       : fmt::format("changed: stable {} {:.9g} {}, now {}", side(s), s.point.value, s.unit,
                                     side(d.now));
        case Deviation::Kind::coarser:
            return fmt::format("in place, but its bracket has grown to {:.1e} (allowed {:.1e})",
                               d.now.point.precision(), s.tolerance);
        case Deviation::Kind::refined:
            return fmt::format("refined: bracket {:.1e} → {:.1e}, moved by {:.1e} of {:.1e} allowed",
                               s.point.precision(), d.now.point.precision(), d.relative, s.tolerance);
        case Deviation::Kind::within:
            break;
    }
    return fmt::format("within: {:.1e} of {:.1e} allowed, {:.9g} {}", d.relative, s.tolerance, s.point.value, s.unit);
}

void write_junit(const std::filesystem::path& file, const std::string& title, const std::vector<Deviation>& deviations,
                 bool design_lost)
{
    std::size_t failed = design_lost;
    std::string cases = fmt::format("  <testcase classname=\"{}\" name=\"the design itself\"{}\n", escaped_xml(title),
                                    design_lost ? "><failure message=\"was stable, is not\"/></testcase>" : "/>");
    for (const auto& d : deviations) {
        const bool appeared = d.kind == Deviation::Kind::appeared, within = d.passes();
        failed += !within;
        cases += fmt::format("  <testcase classname=\"{}\" name=\"{}\"", escaped_xml(title),
                             escaped_xml((appeared ? d.now : d.stored).name()));
        cases += within ? "/>\n" : fmt::format("><failure message=\"{}\"/></testcase>\n", escaped_xml(describe(d)));
    }
    write_whole(file, fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"{}\" tests=\"{}\" "
                                  "failures=\"{}\">\n{}</testsuite>\n",
                                  escaped_xml(title), deviations.size() + 1, failed, cases));
}

}  // namespace stickslip
