#include "sweep/files/toml/boundary_table.h"

#include "analysis/joint/parameters.h"
#include "sweep/files/toml/joint_keys.h"

#include <algorithm>

namespace stickslip::files {
namespace {

struct Text {
    std::string text;
    Place place;
};

/// One text or a list of them.
std::vector<Text> texts_at(const toml::table& table, const std::string& key, Complaints& complaints)
{
    const auto* node = table.get(key);
    if (!node) return {};
    std::vector<Text> texts;
    const auto add = [&](const toml::node& one) {
        if (const auto* text = one.as_string())
            texts.push_back({text->get(), Place(one.source())});
        else
            complaints.add(Place(one.source()), "boundary." + key,
                           "is " + describe(one) + ", expected text in quotes or a list of it");
    };
    if (const auto* list = node->as_array())
        for (const auto& one : *list) add(one);
    else
        add(*node);
    return texts;
}

}  // namespace

void read_boundary_lists(const toml::table& table, const Joint& given, BoundarySpec& spec, Complaints& complaints)
{
    std::vector<std::string> kinds;
    for (const auto kind : boundary_kinds) kinds.emplace_back(name_of(kind));
    for (const auto& [text, place] : texts_at(table, "kind", complaints)) {
        const auto at = std::find(kinds.begin(), kinds.end(), text);
        if (at != kinds.end())
            spec.kinds.push_back(boundary_kinds[at - kinds.begin()]);
        else
            complaints.add(place, "boundary.kind",
                           "is \"" + text + "\", expected " + listed(kinds) + did_you_mean(text, kinds));
    }
    Joint joint = given;
    // ranges behind the paths are checked where axes are made of them
    const auto paths = [&](const std::string& key) {
        std::vector<std::string> found;
        for (const auto& [text, place] : texts_at(table, key, complaints)) {
            const std::string path = text.substr(0, text.find('='));
            if (find_parameter(joint, path))
                found.push_back(text);
            else
                complaints.add(place, "boundary." + key,
                               "is \"" + path + "\", which is not a parameter of this joint" +
                                   did_you_mean(path, numeric_paths(joint)));
        }
        return found;
    };
    for (const char* key : {"axis", "along"})
        for (auto& text : paths(key)) spec.along.push_back(std::move(text));
    const std::size_t before = complaints.count();
    spec.over = paths("over");
    if (complaints.count() == before && !spec.over.empty() && spec.over.size() != 2)
        complaints.add(Place(table.get("over")->source()), "boundary.over",
                       "has " + std::to_string(spec.over.size()) +
                           " entries, expected two axes, x then y, such as [\"control.k_p\", \"control.k_v\"]");
}

}  // namespace stickslip::files
