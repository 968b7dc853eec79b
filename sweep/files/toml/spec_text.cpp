// A spec with its joint written into it, so that results can be drawn again from themselves.
#include "sweep/files/toml/joint_file.h"
#include "sweep/files/toml/spec_file.h"

#include <toml++/toml.h>

#include <fstream>
#include <sstream>

namespace stickslip {

std::string self_contained_text(const std::filesystem::path& file)
{
    const Spec spec = read_spec(file);
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (spec.joint_file.empty()) return text.str();

    // the text stays as the user wrote it, order of the axes included; only the line that names the joint's file goes
    const std::string original = text.str();
    const auto joint_line = toml::parse(original)["joint"].node()->source().begin.line;
    std::istringstream lines(original);
    std::string line, kept;
    for (toml::source_index number = 1; std::getline(lines, line); ++number)
        if (number != joint_line) kept += line + "\n";
    return kept + "\n" + joint_text(read_joint(spec.joint_file));
}

}  // namespace stickslip
