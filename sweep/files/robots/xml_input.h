// XML with line numbers and complaints. Internal to sweep/files.
#pragma once
#include <Eigen/Geometry>
#include <pugixml.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace stickslip::files {

class XmlFile {
  public:
    /// Throws BadInput where the file cannot be read or is no XML.
    explicit XmlFile(const std::filesystem::path& file);

    pugi::xml_node root() const { return document_.document_element(); }
    pugi::xml_document& document() { return document_; }
    /// "robot.urdf:12"
    std::string place(const pugi::xml_node& node) const;
    [[noreturn]] void fail(const pugi::xml_node& node, const std::string& text) const;

    /// Numbers of an attribute; absent: nothing. Throws where they are no finite numbers.
    std::vector<double> numbers(const pugi::xml_node& node, const char* name) const;
    /// The same with a fixed count; `standard` where absent.
    double number(const pugi::xml_node& node, const char* name, double standard) const;
    Eigen::Vector3d vector(const pugi::xml_node& node, const char* name, const Eigen::Vector3d& standard) const;
    /// Text of an attribute that must be there.
    std::string required(const pugi::xml_node& node, const char* name) const;

  private:
    std::string name_, text_;
    pugi::xml_document document_;
};

/// Symmetric matrix; complains unless it can be the inertia of a body.
void check_inertia(const XmlFile& file, const pugi::xml_node& node, double mass, const Eigen::Matrix3d& inertia);

}  // namespace stickslip::files
