#include "analysis/joint/keys.h"

#include <array>
#include <charconv>
#include <map>

#include "analysis/joint/key_collector.h"

namespace stickslip {

std::string written(double value)
{
    if (!is_set(value)) return "";
    std::array<char, 32> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return {buffer.data(), end};
}

std::string written(const NumberList& list)
{
    if (list.size == 0) return "";
    if (list.size == 1) return written(list[0]);
    std::string text;
    for (const double v : list) text += (text.empty() ? "[" : ", ") + written(v);
    return text + "]";
}

namespace {

/// Gives a joint the choices and lengths of lists of another and leaves everything else as it is. Choices come before
/// the keys that depend on them, so one walk is enough.
struct Chooser : Walk {
    std::map<std::string, std::string> wanted;  ///< word by path
    std::map<std::string, int> lengths;         ///< rows by path; others keep theirs
    std::map<std::string, std::string> before;  ///< words that stood there
    int chosen = 0;

    void number(const Field&, double&) {}
    void numbers(const Field&, NumberList&) {}
    void flag(std::string_view, std::string_view, bool&) {}
    void text(std::string_view, std::string_view, std::string&) {}
    void samples(std::string_view, std::string_view, std::string&, KernelTablePtr&) {}
    template <class Enum, std::size_t n>
    void choice(std::string_view key, std::string_view, Enum& value, const Choice<Enum> (&choices)[n])
    {
        const auto word = wanted.find(path(key));
        Enum now = value;
        for (const auto& c : choices) {
            if (c.value == value) before[path(key)] = c.name;
            if (word != wanted.end() && c.name == word->second) now = c.value, ++chosen;
        }
        value = now;
    }
    template <class Struct>
    void table(std::string_view key, std::string_view, Struct& s)
    {
        enter(key, s, *this);
    }
    template <class Struct, int capacity>
    void rows(std::string_view key, std::string_view, ShortList<Struct, capacity>& list)
    {
        if (const auto length = lengths.find(path(key)); length != lengths.end())
            while (list.size < length->second && list.size < capacity) list.push_back({});
        for (int i = 0; i < list.size; ++i) enter(std::string(key) + "." + std::to_string(i), list[i], *this);
    }
    template <class... Laws>
    void law(std::variant<Laws...>& law)
    {
        if (const auto word = wanted.find(path("law")); word != wanted.end()) {
            const bool same = std::visit([&](auto& l) { return l.info.name == word->second; }, law);
            const int hits = (0 + ... + (Laws::info.name == word->second ? 1 : 0));
            if (!same) ((Laws::info.name == word->second ? void(law = Laws{}) : void()), ...);
            chosen += hits;
        }
        std::visit([this](auto& l) { std::decay_t<decltype(l)>::fields(l, *this); }, law);
    }
};

/// Rows by the path of their list: what stands before the last index of each of them.
std::map<std::string, int> row_counts(const std::vector<Key>& keys)
{
    std::map<std::string, int> lengths;
    for (const auto& key : keys) {
        if (!key.in_row) continue;
        const auto leaf = key.path.rfind('.'), index = key.path.rfind('.', leaf - 1);
        const int row = std::stoi(key.path.substr(index + 1, leaf - index - 1));
        int& length = lengths[key.path.substr(0, index)];
        length = std::max(length, row + 1);
    }
    return lengths;
}

}  // namespace

std::vector<Key> keys(const Joint& given)
{
    Joint joint = given;
    KeyCollector collector;
    Joint::fields(joint, collector);
    // the same joint with nothing said: its words and lists, and the defaults of everything else
    Chooser chooser;
    for (const auto& key : collector.found)
        if (key.kind == KeyKind::choice) chooser.wanted[key.path] = key.value;
    chooser.lengths = row_counts(collector.found);
    Joint untouched;
    Joint::fields(untouched, chooser);
    KeyCollector standard;
    Joint::fields(untouched, standard);
    std::map<std::string, std::string> value;
    for (const auto& key : standard.found) value[key.path] = key.value;
    for (auto& key : collector.found) {
        const bool word = key.kind == KeyKind::choice;
        const auto found = word ? chooser.before.find(key.path) : value.find(key.path);
        if (found != (word ? chooser.before.end() : value.end())) key.standard = found->second;
    }
    return collector.found;
}

bool choose(Joint& joint, const std::string& path, const std::string& word)
{
    Chooser chooser;
    chooser.wanted[path] = word;
    Joint::fields(joint, chooser);
    return chooser.chosen > 0;
}

}  // namespace stickslip
