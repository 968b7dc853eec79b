// Fills any self-describing struct (analysis/base/field.h) from a TOML table and complains about everything that does
// not fit: unknown and missing keys, wrong types, units and ranges. Internal to sweep/files.
#pragma once
#include "analysis/base/field.h"
#include "analysis/friction/law.h"
#include "analysis/joint/parameters.h"
#include "sweep/files/text/toml_input.h"
#include "sweep/files/toml/refused_memory.h"

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace stickslip::files {

/// What a missing key means: an error in a file, "leave as it is" in a setting.
enum class Mode { whole, change };

class StructReader {
  public:
    /// Says why a key is unknown and which was meant, given its full path and its known siblings.
    using Explain = std::function<std::string(const std::string& path, const std::vector<std::string>& siblings)>;

    using UnitsNow = std::function<Units()>;

    /// `units` is asked whenever a unit is needed, so that it may depend on what is being read. Files that a value
    /// names are looked up from `folder`.
    StructReader(Complaints& complaints, UnitsNow units, Mode mode, Explain explain, std::filesystem::path folder = {})
        : complaints_(complaints),
          units_(std::move(units)),
          mode_(mode),
          explain_(std::move(explain)),
          folder_(std::move(folder))
    {
    }

    /// Numbers and choices that stand in the input by other keys, by their paths; stating them, too, is an error.
    void fill(std::map<std::string, double> numbers, std::map<std::string, std::string> choices, std::string by)
    {
        numbers_ = std::move(numbers), choices_ = std::move(choices), filled_by_ = std::move(by);
    }
    /// Keys that someone else reads, by their paths.
    void allow(std::vector<std::string> paths) { read_elsewhere_ = std::move(paths); }

    /// Reads one struct; `also_allowed` are keys of this table that someone else reads.
    template <class Struct>
    void read(const toml::table& table, const std::string& path, Struct& s,
              const std::vector<std::string>& also_allowed = {})
    {
        read_at(table, Place(table.source()).or_else(frame_.place), path, s, also_allowed);
    }

    // the visitor's side
    void number(const Field& f, double& value);
    void numbers(const Field& f, NumberList& list);
    void flag(std::string_view key, std::string_view help, bool& value);
    void text(std::string_view key, std::string_view help, std::string& value);
    void samples(std::string_view key, std::string_view help, std::string& name, KernelTablePtr& table);

    template <class Enum, std::size_t n>
    void choice(std::string_view key, std::string_view, Enum& value, const Choice<Enum> (&choices)[n])
    {
        std::vector<std::string> names;
        for (const auto& c : choices) names.emplace_back(c.name);
        const toml::node* node = find(key);
        if (const auto filled = choices_.find(path(key)); filled != choices_.end()) {
            if (node) complain_filled(*node, key);
            for (const auto& c : choices)
                if (c.name == filled->second) value = c.value;
            return;
        }
        if (!node) return;
        if (const int i = index_of(*node, key, names); i >= 0)
            value = choices[i].value;
        else
            frame_.uncertain = true;
    }

    template <class Struct>
    void table(std::string_view key, std::string_view, Struct& s)
    {
        static const toml::table nothing;
        const toml::node* node = find(key);
        if (node && !node->is_table()) {
            complain(*node, key, "is " + describe(*node) + ", expected a table");
            return;
        }
        if (!node && mode_ == Mode::change) return;
        // an absent table is read as an empty one: its required numbers are then missing by name
        const Place place = node ? Place(node->source()).or_else(frame_.place) : frame_.place;
        // which friction tables there are depends on joint.model: without it they cannot be judged
        const bool doubtful = model_doubtful_ && path(key) == "friction";
        const bool choice_failed = read_at(node ? *node->as_table() : nothing, place, path(key), s, {}, doubtful);
        if (choice_failed && path(key) == "joint") model_doubtful_ = true;
    }

    template <class Struct, int capacity>
    void rows(std::string_view key, std::string_view, ShortList<Struct, capacity>& list)
    {
        const toml::node* node = find(key);
        if (!node) return;
        if (const auto* indexed = indexed_table(*node)) {
            for (auto&& [index, row] : *indexed) {
                const int i = row_index(index, key, list.size);
                if (i >= 0 && row.is_table())
                    read_at(*row.as_table(), frame_.place, path(key) + "." + std::to_string(i), list[i], {});
                else if (i >= 0)
                    complain(row, key, "is " + describe(row) + ", expected a table");
            }
            return;
        }
        const auto tables = tables_of(*node, key, capacity);
        if (tables.empty()) return;
        list = {};
        for (std::size_t i = 0; i < tables.size(); ++i) {
            list.push_back({});
            read_at(*tables[i], Place(tables[i]->source()).or_else(frame_.place), path(key) + "." + std::to_string(i),
                    list[static_cast<int>(i)], {});
        }
    }

    template <class... Laws>
    void law(std::variant<Laws...>& law)
    {
        const std::vector<std::string> names{std::string(Laws::info.name)...};
        const toml::node* node = find("law");
        int index = mode_ == Mode::change ? static_cast<int>(law.index()) : -1;
        if (node)
            index = index_of(*node, "law", names);
        else if (index < 0 && !frame_.uncertain)
            complain_missing("law", "expected " + listed(names));
        if (index < 0) {
            frame_.uncertain = true;
            return;
        }
        if (mode_ == Mode::whole || index != static_cast<int>(law.index())) emplace(law, index);
        const std::size_t before = complaints_.count();
        std::visit(
            [&](auto& l) {
                std::decay_t<decltype(l)>::fields(l, *this);
                check_rules(l, before);
            },
            law);
    }

  private:
    /// What is known while one table is read. `uncertain`: a choice in it failed, so its keys cannot be judged.
    struct Frame {
        const toml::table* table = nullptr;
        std::string path;
        Place place;
        std::vector<std::string> known;
        bool uncertain = false;
    };

    template <class Struct>
    bool read_at(const toml::table& table, const Place& place, const std::string& path, Struct& s,
                 const std::vector<std::string>& also_allowed, bool uncertain = false)
    {
        Frame outer = std::move(frame_);
        frame_ = {&table, path, place, also_allowed, uncertain};
        const std::size_t before = complaints_.count();
        Struct::fields(s, *this);
        // messages list the keys of the struct first
        std::rotate(frame_.known.begin(), frame_.known.begin() + static_cast<std::ptrdiff_t>(also_allowed.size()),
                    frame_.known.end());
        complain_unknown();
        check_rules(s, before);
        const bool doubtful = frame_.uncertain;
        frame_ = std::move(outer);
        return doubtful;
    }

    /// Rules beyond ranges (`problem()`), checked only in a struct whose parts are sound and, in a change, complete.
    template <class Struct>
    void check_rules(const Struct& s, std::size_t complaints_before)
    {
        if constexpr (requires { s.problem(); }) {
            if (complaints_.count() > complaints_before || mode_ == Mode::change) return;
            if constexpr (std::is_same_v<Struct, Control>)
                if (complain_refused(refused_memory(s, 0), "control.")) return;
            if constexpr (std::is_same_v<Struct, Joint>)
                if (complain_refused(refused_memory(s.control, s.sensor.delay), "")) return;
            if (const std::string problem = s.problem(); !problem.empty())
                complaints_.add(frame_.place, frame_.path, problem);
        }
    }

    /// At the key in this table, whose own path the problem's begins with.
    bool complain_refused(const Problem& problem, std::string_view own)
    {
        if (problem.message.empty()) return false;
        const auto node = frame_.table->at_path(problem.path.substr(own.size()));
        complaints_.add(node ? Place(node.node()->source()).or_else(frame_.place) : frame_.place, problem.path,
                        problem.message);
        return true;
    }

    template <class... Laws>
    static void emplace(std::variant<Laws...>& law, int index)
    {
        int i = 0;
        ((i++ == index ? void(law = Laws{}) : void()), ...);
    }

    std::string path(std::string_view key) const
    {
        return frame_.path.empty() ? std::string(key) : frame_.path + "." + std::string(key);
    }
    const toml::node* find(std::string_view key);
    void complain(const toml::node& node, std::string_view key, const std::string& text);
    void complain_missing(std::string_view key, const std::string& text);
    void complain_filled(const toml::node& node, std::string_view key);
    void complain_unknown();
    int index_of(const toml::node& node, std::string_view key, const std::vector<std::string>& names);
    bool take_number(const toml::node& node, std::string_view key, const Field& f, double& value);
    const toml::table* indexed_table(const toml::node& node) const;
    int row_index(const toml::key& index, std::string_view key, int size);
    std::vector<const toml::table*> tables_of(const toml::node& node, std::string_view key, int capacity);

    Complaints& complaints_;
    UnitsNow units_;
    Mode mode_;
    Explain explain_;
    std::filesystem::path folder_;
    Frame frame_;
    bool model_doubtful_ = false;
    std::map<std::string, double> numbers_;
    std::map<std::string, std::string> choices_;
    std::string filled_by_;
    std::vector<std::string> read_elsewhere_;
};

/// "a number in N/m, > 0": what a numeric leaf takes.
std::string allowed_text(const Field& field, Units units);

/// Reads a number, plain (SI) or as text with a unit, and checks its range. Returns what is wrong, or nothing; `value`
/// is changed only then. Where it is infinite before (a limit that is absent by default), infinity is allowed.
std::string read_number(const toml::node& node, const Field& field, Units units, double& value);

}  // namespace stickslip::files
