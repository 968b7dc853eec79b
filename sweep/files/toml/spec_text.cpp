// A spec with its joint and its robot written into it, so that results can be drawn again from themselves.
#include "sweep/files/robots/robot_file.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/files/toml/spec_file.h"

#include <toml++/toml.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>

namespace stickslip {
namespace {

/// Bytes up to a position; columns count letters.
std::size_t offset_of(const std::string& text, const toml::source_position& at)
{
    std::size_t offset = 0;
    for (toml::source_index line = 1; line < at.line; ++line) offset = text.find('\n', offset) + 1;
    for (toml::source_index column = 1; column < at.column && offset < text.size(); ++column) {
        ++offset;
        while (offset < text.size() && (static_cast<unsigned char>(text[offset]) & 0xC0) == 0x80) ++offset;
    }
    return offset;
}

void replace(std::string& text, const toml::source_region& region, const std::string& with)
{
    const auto begin = offset_of(text, region.begin);
    text.replace(begin, offset_of(text, region.end) - begin, with);
}

/// In place of the name of the robot's file what is in it. JSON's text is text of TOML, too.
std::string with_description(std::string text, const std::filesystem::path& folder)
{
    const auto table = toml::parse(text);
    const auto* robot = table["robot"].as_table();
    if (!robot || !robot->contains("file")) return text;
    const auto entry = robot->find("file");
    const auto description = robot_text(folder / entry->second.value_or(std::string()));
    replace(text, entry->second.source(),
            nlohmann::json(description).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
    replace(text, entry->first.source(), "description");
    return text;
}

}  // namespace

std::string self_contained_text(const std::filesystem::path& file)
{
    const Spec spec = read_spec(file);
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    const auto original = with_description(text.str(), file.parent_path());
    if (spec.joint_file.empty()) return original;

    // the text stays as the user wrote it, order of the axes included; only the line that names the joint's file goes
    const auto joint_line = toml::parse(original)["joint"].node()->source().begin.line;
    std::istringstream lines(original);
    std::string line, kept;
    for (toml::source_index number = 1; std::getline(lines, line); ++number)
        if (number != joint_line) kept += line + "\n";
    return kept + "\n" + joint_text(read_joint(spec.joint_file));
}

}  // namespace stickslip
