#include "sweep/files/json/drawn_charts.h"

#include "sweep/files/text/whole_file.h"

#include <fmt/format.h>
#include <xxhash.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace stickslip {
namespace {

using Json = nlohmann::ordered_json;

constexpr char index_name[] = "drawn.json";

std::optional<std::string> bytes_of(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file) return std::nullopt;
    std::string bytes(static_cast<std::size_t>(file.tellg()), '\0');
    file.seekg(0);
    if (!file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) return std::nullopt;
    return bytes;
}

std::string sum(const std::string& bytes)
{
    return fmt::format("{:016x}", XXH3_64bits(bytes.data(), bytes.size()));
}

Json json_of(const PlotArea& area)
{
    return {area.left, area.top, area.width, area.height};
}

PlotArea area_of(const Json& json)
{
    return {json.at(0), json.at(1), json.at(2), json.at(3)};
}

}  // namespace

DrawnCharts::DrawnCharts(std::filesystem::path folder) : folder_(std::move(folder))
{
    const auto text = bytes_of(folder_ / index_name);
    const auto json = text ? Json::parse(*text, nullptr, false) : Json();
    if (!json.is_object() || json.value("format", Json()) != drawn_charts_format || !json.contains("charts")) return;
    for (const auto& [id, chart] : json["charts"].items()) said_[id] = chart.dump();
}

std::optional<RenderedFigure> DrawnCharts::kept(const std::string& id, const std::string& key) const
{
    const auto said = said_.find(id);
    if (said == said_.end()) return std::nullopt;
    try {
        const auto chart = Json::parse(said->second);
        if (chart.at("key") != key) return std::nullopt;
        RenderedFigure figure;
        for (const auto& [name, checksum] : chart.at("files").items()) {
            auto bytes = bytes_of(folder_ / (id + "." + name));
            if (!bytes || checksum != sum(*bytes)) return std::nullopt;
            if (name == "svg") figure.svg = std::move(*bytes);
            if (name == "csv") figure.csv = std::move(*bytes);
        }
        figure.width = chart.at("width"), figure.height = chart.at("height");
        figure.plot = area_of(chart.at("plot"));
        for (const auto& panel : chart.at("panels")) figure.panels.push_back(area_of(panel));
        return figure;
    } catch (const Json::exception&) {
        return std::nullopt;  // not as this program writes it: drawn again
    }
}

std::string DrawnCharts::write(const std::string& id, const std::string& key, const RenderedFigure& figure) const
{
    Json files = Json::object();
    const auto add = [&](const char* name, const std::string& bytes) {
        if (bytes.empty()) return;
        write_whole(folder_ / (id + "." + name), bytes);
        files[name] = sum(bytes);
    };
    add("png", png(figure));
    add("svg", figure.svg);
    add("csv", figure.csv);
    Json panels = Json::array();
    for (const auto& panel : figure.panels) panels.push_back(json_of(panel));
    return Json{{"key", key},
                {"files", files},
                {"width", figure.width},
                {"height", figure.height},
                {"plot", json_of(figure.plot)},
                {"panels", panels}}
        .dump();
}

void DrawnCharts::write_index(const std::map<std::string, std::string>& written,
                              const std::vector<std::string>& same) const
{
    std::map<std::string, std::string> all = written;
    for (const auto& id : same) all[id] = said_.at(id);
    std::string text = fmt::format("{{\"format\": \"{}\", \"charts\": {{", drawn_charts_format);
    for (const char* comma = "\n"; const auto& [id, chart] : all) {
        text += fmt::format("{}{}: {}", comma, Json(id).dump(), chart);
        comma = ",\n";
    }
    write_whole(folder_ / index_name, text + "}}\n");
}

}  // namespace stickslip
