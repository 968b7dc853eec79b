// A spec with its joint written into it, so that results can be drawn again from themselves.
#include "sweep/files/joint_file.h"
#include "sweep/files/spec_file.h"

#include <toml++/toml.h>

#include <sstream>

namespace stickslip {

std::string self_contained_text(const std::filesystem::path& file)
{
    const Spec spec = read_spec(file);
    toml::table table = toml::parse_file(file.string());
    if (!spec.joint_file.empty()) {
        table.erase("joint");
        Joint joint = read_joint(spec.joint_file);
        for (auto&& [key, node] : toml::parse(joint_text(joint))) table.insert(key, node);
    }
    std::ostringstream text;
    text << table << "\n";
    return text.str();
}

}  // namespace stickslip
