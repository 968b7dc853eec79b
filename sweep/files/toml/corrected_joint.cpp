#include "sweep/files/toml/corrected_joint.h"

#include "sweep/files/toml/joint_file.h"

#include <fmt/format.h>

#include <cmath>

namespace stickslip {

std::string corrected_joint_text(const Diagnosis& d, const Joint& joint, const Joint& after)
{
    if (d.verdict != Verdict::gap || d.effects.empty() || joint_text(after) == joint_text(joint)) return "";
    std::string head = "# The documented joint with the findings of the diagnosis:";
    for (const auto& name : d.effects.front().names) head += " " + name;
    for (const auto& [name, value, error, unit] : d.effects.front().parameters)
        head += fmt::format("\n#   {} = {:.6g}{} {}", name, value,
                            std::isfinite(error) && error > 0 ? fmt::format(" +- {:.2g}", error) : "",
                            unit == "1" ? "" : unit);
    return head + "\n" + joint_text(after);
}

}  // namespace stickslip
