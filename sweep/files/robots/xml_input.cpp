#include "sweep/files/robots/xml_input.h"

#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/toml_input.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace stickslip::files {
namespace {

std::string line_of(const std::string& text, std::ptrdiff_t offset)
{
    if (offset < 0) return "";
    const auto end = text.begin() + std::min<std::ptrdiff_t>(offset, static_cast<std::ptrdiff_t>(text.size()));
    return ":" + std::to_string(1 + std::count(text.begin(), end, '\n'));
}

}  // namespace

XmlFile::XmlFile(const std::filesystem::path& file) : XmlFile(file.string(), read_text(file)) {}

XmlFile::XmlFile(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text))
{
    const auto result = document_.load_buffer(text_.data(), text_.size());
    if (!result) throw BadInput(name_ + line_of(text_, result.offset) + ": is not XML: " + result.description());
}

std::string XmlFile::place(const pugi::xml_node& node) const
{
    if (const auto found = places_.find(node.hash_value()); found != places_.end()) return found->second;
    return name_ + line_of(text_, node.offset_debug());
}

void XmlFile::insert_before(const pugi::xml_node& child, const XmlFile& other, const pugi::xml_node& node)
{
    keep_places(other, node, child.parent().insert_copy_before(node, child));
}

void XmlFile::keep_places(const XmlFile& other, const pugi::xml_node& node, const pugi::xml_node& copy)
{
    places_[copy.hash_value()] = other.place(node);
    auto part = copy.first_child();
    for (const auto& original : node.children()) keep_places(other, original, part), part = part.next_sibling();
}

std::string XmlFile::text() const
{
    std::ostringstream text;
    document_.save(text, " ");
    return text.str();
}

void XmlFile::fail(const pugi::xml_node& node, const std::string& text) const
{
    const std::string name = node.attribute("name").as_string();
    throw BadInput(place(node) + ": <" + node.name() + (name.empty() ? "" : " \"" + name + "\"") + ">: " + text);
}

std::vector<double> XmlFile::numbers(const pugi::xml_node& node, const char* name) const
{
    std::vector<double> values;
    const std::string text = node.attribute(name).as_string();
    const char *at = text.data(), *end = at + text.size();
    const auto space = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
    while (true) {
        while (at < end && space(*at)) ++at;
        if (at < end && *at == '+') ++at;
        if (at == end) return values;
        double value = 0;
        const auto read = std::from_chars(at, end, value);
        if (read.ec != std::errc() || !std::isfinite(value) || (read.ptr < end && !space(*read.ptr))) {
            const bool macro = text.find("${") != std::string::npos;
            fail(node, std::string(name) + " is \"" + text + "\", expected finite numbers" +
                           (macro ? "; this is a xacro file: run xacro on it first" : ""));
        }
        values.push_back(value);
        at = read.ptr;
    }
}

double XmlFile::number(const pugi::xml_node& node, const char* name, double standard) const
{
    const auto values = numbers(node, name);
    if (values.empty()) return standard;
    if (values.size() > 1)
        fail(node, std::string(name) + " is \"" + node.attribute(name).as_string() + "\", expected one number");
    return values[0];
}

Eigen::Vector3d XmlFile::vector(const pugi::xml_node& node, const char* name, const Eigen::Vector3d& standard) const
{
    const auto values = numbers(node, name);
    if (values.empty()) return standard;
    if (values.size() != 3)
        fail(node, std::string(name) + " is \"" + node.attribute(name).as_string() + "\", expected three numbers");
    return {values[0], values[1], values[2]};
}

std::string XmlFile::required(const pugi::xml_node& node, const char* name) const
{
    const std::string text = node.attribute(name).as_string();
    if (text.empty()) fail(node, std::string("has no ") + name);
    return text;
}

void check_inertia(const XmlFile& file, const pugi::xml_node& node, double mass, const Eigen::Matrix3d& inertia)
{
    if (mass < 0) file.fail(node, "has a mass of " + number_text(mass) + ", expected a number ≥ 0");
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(inertia, Eigen::EigenvaluesOnly);
    const Eigen::Vector3d& moments = principal.eigenvalues();  // ascending
    if (moments[0] < -1e-9 * std::abs(moments[2]))
        file.fail(node, "has a principal inertia of " + number_text(moments[0]) + ", expected numbers ≥ 0");
}

}  // namespace stickslip::files
