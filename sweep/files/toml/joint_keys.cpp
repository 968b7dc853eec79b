#include "sweep/files/toml/joint_keys.h"

#include "analysis/joint/parameters.h"
#include "sweep/files/text/toml_input.h"

#include <algorithm>

namespace stickslip::files {
namespace {

/// Walks a joint and lists every key, optionally with one of its choices (a model, a kind, a law) changed.
struct KeyWalker {
    struct Option {
        std::string path;
        std::vector<std::string> names;
    };

    std::string override_path;
    std::size_t override_index = 0;
    std::string prefix;
    std::vector<std::string> keys;
    std::vector<Option> options;

    std::string path(std::string_view key) const
    {
        return prefix.empty() ? std::string(key) : prefix + "." + std::string(key);
    }
    void note(std::string_view key) { keys.push_back(path(key)); }

    void number(const Field& f, double&) { note(f.key); }
    void numbers(const Field& f, NumberList&) { note(f.key); }
    void flag(std::string_view key, std::string_view, bool&) { note(key); }
    void text(std::string_view key, std::string_view, std::string&) { note(key); }

    template <class Enum, std::size_t n>
    void choice(std::string_view key, std::string_view, Enum& value, const Choice<Enum> (&choices)[n])
    {
        note(key);
        options.push_back({path(key), {}});
        for (const auto& c : choices) options.back().names.emplace_back(c.name);
        if (path(key) == override_path) value = choices[override_index].value;
    }
    template <class Struct>
    void table(std::string_view key, std::string_view, Struct& s)
    {
        note(key);
        const std::string outer = prefix;
        prefix = path(key);
        Struct::fields(s, *this);
        prefix = outer;
    }
    template <class Struct, int capacity>
    void rows(std::string_view key, std::string_view help, ShortList<Struct, capacity>& list)
    {
        note(key);
        if (list.size == 0) list.push_back({});  // so that the keys of a row are known
        for (int i = 0; i < list.size; ++i) table(std::string(key) + "." + std::to_string(i), help, list[i]);
    }
    template <class... Laws>
    void law(std::variant<Laws...>& law)
    {
        note("law");
        options.push_back({path("law"), {std::string(Laws::info.name)...}});
        if (path("law") == override_path) {
            std::size_t i = 0;
            ((i++ == override_index ? void(law = Laws{}) : void()), ...);
        }
        std::visit([this](auto& l) { std::decay_t<decltype(l)>::fields(l, *this); }, law);
    }
};

KeyWalker walk(Joint joint, const std::string& override_path = "", std::size_t override_index = 0)
{
    KeyWalker walker{override_path, override_index, {}, {}, {}};
    Joint::fields(joint, walker);
    return walker;
}

std::string parent_of(const std::string& path)
{
    return path.substr(0, path.rfind('.') == std::string::npos ? 0 : path.rfind('.'));
}

}  // namespace

std::string explain_unknown_key(const Joint& joint, const std::string& path, const std::vector<std::string>& siblings)
{
    const KeyWalker here = walk(joint);
    std::string owners;
    for (const auto& option : here.options) {
        for (std::size_t i = 0; i < option.names.size(); ++i) {
            const auto keys = walk(joint, option.path, i).keys;
            if (std::find(keys.begin(), keys.end(), path) == keys.end()) continue;
            owners += (owners.empty() ? "" : " or ") + option.path + " = \"" + option.names[i] + "\"";
        }
    }
    std::string text = "unknown key";
    if (!owners.empty()) text += " (it belongs to " + owners + ")";
    text += siblings.empty() ? "" : ", expected " + listed(siblings);
    if (!owners.empty()) return text;

    const std::string given = path.substr(parent_of(path).empty() ? 0 : parent_of(path).size() + 1);
    const std::string near = did_you_mean(given, siblings);
    return text + (near.empty() ? did_you_mean(given, here.keys) : near);
}

std::vector<std::string> numeric_paths(const Joint& given)
{
    Joint joint = given;
    std::vector<std::string> paths;
    for (const auto& p : parameters(joint)) paths.push_back(p.path);
    return paths;
}

}  // namespace stickslip::files
