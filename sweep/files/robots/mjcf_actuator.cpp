#include "sweep/files/robots/mjcf_actuator.h"

#include <algorithm>
#include <cmath>

namespace stickslip::files {
namespace {

class Reader {
  public:
    explicit Reader(const MjcfInput& input) : input_(input) {}

    /// Classes first, whatever element they state attributes for: to MuJoCo all of them are <general>.
    MjcfActuator read(const pugi::xml_node& node) const
    {
        MjcfActuator a;
        auto defaults = input_.defaults_of(node, "");
        std::reverse(defaults.begin(), defaults.end());
        for (const auto& of_class : defaults)
            for (const auto& element : of_class.children())
                if (is_actuator(element.name())) apply(element, a);
        apply(node, a);
        a.known = is_actuator(a.kind) && a.gear * a.gain != 0;
        return a;
    }

    static bool is_actuator(const std::string& name)
    {
        return name == "general" || name == "motor" || name == "position" || name == "velocity" ||
               name == "intvelocity";
    }

  private:
    double number(const pugi::xml_node& node, const char* name, double standard) const
    {
        const auto values = input_.file.numbers(node, name);
        return values.empty() ? standard : values[0];
    }

    static void text(const pugi::xml_node& node, const char* name, std::string& value)
    {
        value = node.attribute(name).as_string(value.c_str());
    }

    void range(const pugi::xml_node& node, const char* name, const char* limited, MjcfRange& range) const
    {
        const std::string state = node.attribute(limited).as_string("auto");
        const auto values = input_.file.numbers(node, name);
        if (state == "false") range = {};
        if (values.size() == 2 && input_.limited(state)) range = range_of(values);
    }

    void apply(const pugi::xml_node& node, MjcfActuator& a) const
    {
        a.kind = node.name();
        a.gear = number(node, "gear", a.gear);
        a.delay = number(node, "delay", a.delay);
        a.damping = number(node, "damping", a.damping);
        a.armature = number(node, "armature", a.armature);
        range(node, "ctrlrange", "ctrllimited", a.command);
        range(node, "forcerange", "forcelimited", a.force);
        range(node, "actrange", "actlimited", a.activation);
        if (a.kind == "general") return apply_general(node, a);
        if (a.kind == "motor") a.gain = 1, a.dynamics = "none", a.bias_type = "none";
        if (a.kind == "position" || a.kind == "intvelocity") apply_position(node, a);
        if (a.kind == "velocity") {
            a.gain = number(node, "kv", a.gain);
            a.bias = {0, 0, -a.gain};
            a.dynamics = "none", a.bias_type = "affine";
        }
        a.gain_type = "fixed";
    }

    void apply_general(const pugi::xml_node& node, MjcfActuator& a) const
    {
        text(node, "dyntype", a.dynamics);
        text(node, "gaintype", a.gain_type);
        text(node, "biastype", a.bias_type);
        a.time = number(node, "dynprm", a.time);
        a.gain = number(node, "gainprm", a.gain);
        const auto bias = input_.file.numbers(node, "biasprm");
        std::copy_n(bias.begin(), std::min(bias.size(), a.bias.size()), a.bias.begin());
    }

    /// A bias by velocity above zero is a damping ratio.
    void apply_position(const pugi::xml_node& node, MjcfActuator& a) const
    {
        a.gain = number(node, "kp", a.gain);
        a.bias[1] = -a.gain;
        if (node.attribute("kv")) a.bias[2] = -number(node, "kv", 0);
        if (node.attribute("dampratio")) a.bias[2] = number(node, "dampratio", 0);
        if (node.attribute("timeconst")) {
            a.time = number(node, "timeconst", 0);
            a.dynamics = a.time > 0 ? "filterexact" : "none";
        }
        if (a.kind == "intvelocity") a.dynamics = "integrator";
        a.bias_type = "affine";
    }

    const MjcfInput& input_;
};

}  // namespace

MjcfRange range_of(const std::vector<double>& values)
{
    return {std::max(std::abs(values[0]), std::abs(values[1])), values[0] != -values[1]};
}

MjcfActuator read_actuator(const MjcfInput& input, const pugi::xml_node& node)
{
    return Reader(input).read(node);
}

}  // namespace stickslip::files
