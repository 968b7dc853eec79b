// What elements of MJCF share: defaults by class, angles, orientations, included files. Internal to sweep/files.
#pragma once
#include "sweep/files/robots/xml_input.h"

#include <map>

namespace stickslip::files {

class MjcfInput {
  public:
    explicit MjcfInput(const std::filesystem::path& path);

    XmlFile file;
    bool autolimits = true, degrees = true;
    std::string inertia_from_geoms = "auto";

    /// Gives the element the attributes of its class that it does not have itself. `childclass` is that of the bodies
    /// around it.
    void apply_defaults(pugi::xml_node node, const std::string& childclass) const;
    /// pos and orientation.
    Eigen::Isometry3d frame(const pugi::xml_node& node) const;
    Eigen::Matrix3d orientation(const pugi::xml_node& node) const;
    double angle(double written) const;

  private:
    void include(pugi::xml_node node, const std::filesystem::path& folder, int depth);
    void read_compiler();
    void collect(const pugi::xml_node& element, const std::string& parent);

    std::string sequence_ = "xyz";
    std::map<std::string, pugi::xml_node> classes_;
    std::map<std::string, std::string> parents_;
};

}  // namespace stickslip::files
