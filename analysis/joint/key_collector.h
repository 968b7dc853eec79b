// Visits any self-describing struct (analysis/base/field.h) and keeps every key with its value. For joints use keys().
#pragma once
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/joint/keys.h"

namespace stickslip {

/// A number as a file has it; empty where it is not set.
std::string written(double value);
std::string written(const NumberList& list);

/// The path that grows and shrinks while tables are entered and left.
class Walk {
  public:
    template <class Struct>
    void enter(std::string_view key, Struct& s, auto& visitor)
    {
        const std::string outer = prefix_;
        prefix_ = path(key);
        Struct::fields(s, visitor);
        prefix_ = outer;
    }
    std::string path(std::string_view key) const
    {
        return prefix_.empty() ? std::string(key) : prefix_ + "." + std::string(key);
    }

  private:
    std::string prefix_;
};

/// Keeps every key with its value.
struct KeyCollector : Walk {
    std::vector<Key> found;
    int rows_deep = 0;

    Key& add(std::string_view key, KeyKind kind, std::string_view help, std::string value)
    {
        Key entry;
        entry.path = path(key);
        entry.kind = kind;
        entry.help = help;
        entry.value = std::move(value);
        entry.in_row = rows_deep > 0;
        return found.emplace_back(std::move(entry));
    }
    Key& add(const Field& f, KeyKind kind, std::string value)
    {
        Key& entry = add(f.key, kind, f.help, std::move(value));
        entry.quantity = f.quantity;
        entry.range = f.range;
        entry.need = f.need;
        return entry;
    }
    void number(const Field& f, double& value) { add(f, KeyKind::number, written(value)); }
    void numbers(const Field& f, NumberList& list) { add(f, KeyKind::numbers, written(list)); }
    void flag(std::string_view key, std::string_view help, bool& value)
    {
        add(key, KeyKind::flag, help, value ? "true" : "false");
    }
    void text(std::string_view key, std::string_view help, std::string& value) { add(key, KeyKind::text, help, value); }
    void samples(std::string_view key, std::string_view help, std::string& name, KernelTablePtr&)
    {
        add(key, KeyKind::text, help.empty() ? "file with two columns, time and g" : help, name);
    }
    template <class Enum, std::size_t n>
    void choice(std::string_view key, std::string_view help, Enum& value, const Choice<Enum> (&choices)[n])
    {
        Key& entry = add(key, KeyKind::choice, help, "");
        for (const auto& c : choices) {
            entry.words.emplace_back(c.name);
            if (c.value == value) entry.value = c.name;
        }
    }
    template <class Struct>
    void table(std::string_view key, std::string_view, Struct& s)
    {
        enter(key, s, *this);
    }
    template <class Struct, int capacity>
    void rows(std::string_view key, std::string_view, ShortList<Struct, capacity>& list)
    {
        ++rows_deep;
        for (int i = 0; i < list.size; ++i) enter(std::string(key) + "." + std::to_string(i), list[i], *this);
        --rows_deep;
    }
    template <class... Laws>
    void law(std::variant<Laws...>& law)
    {
        Key& entry = add("law", KeyKind::choice, "friction law", "");
        entry.need = Need::required;
        entry.words = {std::string(Laws::info.name)...};
        entry.value = std::visit([](auto& l) { return std::string(l.info.name); }, law);
        std::visit([this](auto& l) { std::decay_t<decltype(l)>::fields(l, *this); }, law);
    }
};

/// Keys of a struct that stands under `path` in its file, each as it is: `standard` is its value.
template <class Struct>
std::vector<Key> keys_of(Struct s, const std::string& path)
{
    KeyCollector collector;
    collector.table(path, "", s);
    for (auto& key : collector.found) key.standard = key.value;
    return collector.found;
}

}  // namespace stickslip
