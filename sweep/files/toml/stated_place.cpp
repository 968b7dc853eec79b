#include "sweep/files/toml/stated_place.h"

#include "sweep/files/text/csv_cells.h"
#include "sweep/files/text/toml_input.h"

#include <fmt/format.h>

namespace stickslip {

std::string stated_place(const std::filesystem::path& file, const std::vector<std::string>& settings,
                         std::string_view path)
{
    for (const auto& setting : settings)
        if (files::trimmed(std::string_view(setting).substr(0, setting.find('='))) == path) return "--set";
    const auto root = files::parse_toml(files::read_text(file), file.string());
    if (const auto node = root.at_path(path)) {
        const files::Place place(node.node()->source());
        return fmt::format("{}:{}:{}", file.string(), place.line, place.column);
    }
    if (const auto* joint = root.get_as<std::string>("joint"))
        return stated_place(file.parent_path() / joint->get(), {}, path);
    return file.string();
}

}  // namespace stickslip
