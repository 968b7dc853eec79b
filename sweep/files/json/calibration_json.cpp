#include "sweep/files/json/calibration_json.h"

#include "analysis/results/point.h"
#include "sweep/files/json/verdict_json.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/toml/joint_file.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace stickslip {
namespace {

using guarantee::Calibration;
using guarantee::CalibrationCase;
using guarantee::Place;

constexpr const char* format = "stickslip-calibration/1";

Json place_json(const Place& p)
{
    return {{"kind", p.kind},
            {"columns", p.columns},
            {"noise_documented", p.noise_documented},
            {"records", p.records},
            {"duration", json_number(p.duration)},
            {"period", json_number(p.period)},
            {"step", json_number(p.step)},
            {"noise", json_number(p.noise)},
            {"bandwidth", json_number(p.bandwidth)}};
}

double number_of(const Json& j, const char* key)
{
    const auto& value = j.at(key);
    return value.is_null() ? missing : value.get<double>();
}

Place place_from(const Json& j)
{
    Place p;
    p.kind = j.at("kind");
    p.columns = j.at("columns").get<std::vector<std::string>>();
    p.noise_documented = j.at("noise_documented");
    p.records = number_of(j, "records");
    p.duration = number_of(j, "duration");
    p.period = number_of(j, "period");
    p.step = number_of(j, "step");
    p.noise = number_of(j, "noise");
    p.bandwidth = number_of(j, "bandwidth");
    return p;
}

Json case_json(const CalibrationCase& c)
{
    Json numbers = Json::array();
    for (const double p : c.answer.probabilities) numbers.push_back(json_number(p));
    return {{"name", c.name},
            {"truth",
             {{"verdict", c.truth.verdict},
              {"effects", c.truth.effects},
              {"equivalent", c.truth.equivalent},
              {"dirty", c.truth.dirty}}},
            {"answer", {{"verdict", c.answer.verdict}, {"effects", c.answer.ranked}, {"probabilities", numbers}}},
            {"joint", place_json(c.place)}};
}

CalibrationCase case_from(const Json& j)
{
    CalibrationCase c;
    c.name = j.at("name");
    const auto& truth = j.at("truth");
    c.truth.verdict = truth.at("verdict");
    c.truth.effects = truth.at("effects").get<blind::EffectSet>();
    c.truth.equivalent = truth.at("equivalent").get<blind::EffectSet>();
    c.truth.dirty = truth.at("dirty");
    const auto& answer = j.at("answer");
    c.answer.verdict = answer.at("verdict");
    c.answer.ranked = answer.at("effects").get<std::vector<blind::EffectSet>>();
    for (const auto& p : answer.at("probabilities"))
        c.answer.probabilities.push_back(p.is_null() ? 0 : p.get<double>());
    c.place = place_from(j.at("joint"));
    return c;
}

std::string text_of(const std::string& file)
{
    std::ifstream in(file, std::ios::binary);
    if (!in) throw BadInput(file + ": cannot be read");
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

}  // namespace

std::string calibration_json(const Calibration& calibration)
{
    Json json = {{"format", format},
                 {"method", calibration.method},
                 {"population", calibration.population()},
                 {"joint", calibration.joint},
                 {"cases", Json::array()}};
    for (const auto& c : calibration.cases) json["cases"].push_back(case_json(c));
    return json.dump(1) + "\n";
}

Calibration parse_calibration(const std::string& text)
{
    try {
        const Json json = Json::parse(text);
        if (json.value("format", "") != format)
            throw std::invalid_argument(
                fmt::format("format: got \"{}\", expected \"{}\"", json.value("format", ""), format));
        Calibration c;
        c.method = json.at("method");
        c.populations = {json.at("population").get<std::string>()};
        c.joint = json.at("joint");
        for (const auto& one : json.at("cases")) c.cases.push_back(case_from(one));
        return c;
    } catch (const nlohmann::json::exception& e) {
        throw std::invalid_argument(std::string("is not a calibration: ") + e.what());
    }
}

Calibration read_calibrations(const std::vector<std::string>& files)
{
    Calibration all;
    for (std::size_t i = 0; i < files.size(); ++i) {
        try {
            auto one = parse_calibration(text_of(files[i]));
            if (i == 0)
                all = std::move(one);
            else
                merge(all, one);
        } catch (const std::invalid_argument& e) {
            throw BadInput(files[i] + ": " + e.what());
        }
    }
    return all;
}

std::string hash_of(const Joint& joint)
{
    const auto text = joint_text(joint);
    return fmt::format("{:016x}", XXH3_64bits(text.data(), text.size()));
}

}  // namespace stickslip
