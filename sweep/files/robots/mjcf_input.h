// What elements of MJCF share: defaults by class, angles, orientations, included files. Internal to sweep/files.
#pragma once
#include "sweep/files/robots/xml_input.h"

#include <map>
#include <set>

namespace stickslip::files {

class MjcfInput {
  public:
    /// `folder` is where included files are looked up.
    MjcfInput(XmlFile xml, const std::filesystem::path& folder);

    XmlFile file;
    bool autolimits = true, degrees = true;
    std::string inertia_from_geoms = "auto";
    double first_group = 0, last_group = 5;  ///< of geoms that make the inertia of their body

    /// Gives the element the attributes of its class that it does not have itself. `childclass` is that of the bodies
    /// around it.
    void apply_defaults(pugi::xml_node node, const std::string& childclass) const;
    /// The same where the class has the attributes under another name: `as`.
    void apply_defaults(pugi::xml_node node, const std::string& childclass, const char* as) const;
    /// The <default> of the element's class and those around it, innermost first.
    std::vector<pugi::xml_node> defaults_of(const pugi::xml_node& node, const std::string& childclass) const;
    /// Whether <flag> leaves this part of the physics on.
    bool acts(const std::string& flag) const { return !disabled_.count(flag); }
    /// Whether a range holds: `limited` of the element says so, or leaves it to the range that is there.
    bool limited(const std::string& limited) const { return limited == "true" || (limited != "false" && autolimits); }
    /// pos and orientation.
    Eigen::Isometry3d frame(const pugi::xml_node& node) const;
    Eigen::Matrix3d orientation(const pugi::xml_node& node) const;
    double angle(double written) const;

  private:
    void read_compiler();
    void read_flags();
    void collect(const pugi::xml_node& element, const std::string& parent);

    std::string sequence_ = "xyz";
    std::map<std::string, pugi::xml_node> classes_;
    std::map<std::string, std::string> parents_;
    std::set<std::string> disabled_;
};

}  // namespace stickslip::files
