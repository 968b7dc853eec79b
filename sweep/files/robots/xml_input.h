// XML with line numbers and complaints. Internal to sweep/files.
#pragma once
#include <Eigen/Geometry>
#include <pugixml.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace stickslip::files {

class XmlFile {
  public:
    /// Throws BadInput where the file cannot be read or is no XML.
    explicit XmlFile(const std::filesystem::path& file);
    /// The same of text; `name` is what messages call it.
    XmlFile(std::string name, std::string text);

    pugi::xml_node root() const { return document_.document_element(); }
    /// Puts a copy of a node of another file before one of this; it keeps the place where it was written.
    void insert_before(const pugi::xml_node& child, const XmlFile& other, const pugi::xml_node& node);
    /// The whole document as it now is.
    std::string text() const;
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
    void keep_places(const XmlFile& other, const pugi::xml_node& node, const pugi::xml_node& copy);

    std::string name_, text_;
    pugi::xml_document document_;
    std::map<std::size_t, std::string> places_;  ///< of copies from other files, by the hash of the node
};

/// Symmetric matrix; complains unless it can be the inertia of a body.
void check_inertia(const XmlFile& file, const pugi::xml_node& node, double mass, const Eigen::Matrix3d& inertia);

}  // namespace stickslip::files
