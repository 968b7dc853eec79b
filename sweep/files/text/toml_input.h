// TOML text with positions, and the list of complaints about it. Internal to sweep/files: other code sees plain
// structs.
#pragma once
#include <toml++/toml.h>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/base/number_text.h"
#include "sweep/files/text/names.h"

namespace stickslip::files {

/// Line and column of a node, both from 1; line 0 means that the value did not come from a file.
struct Place {
    unsigned line = 0, column = 0;

    Place() = default;
    Place(const toml::source_region& region) : line(region.begin.line), column(region.begin.column) {}
    Place or_else(const Place& other) const { return line > 0 ? *this : other; }
};

/// Everything that is wrong with one input, so that a user sees all of it at once.
class Complaints {
  public:
    explicit Complaints(std::string source) : source_(std::move(source)) {}

    /// `path` may be empty. The message is `source:line:column: path: text`.
    void add(const Place& place, std::string_view path, std::string_view text);
    /// Takes over complaints about another input; they stand first.
    void add_foreign(const std::vector<std::string>& messages);
    std::size_t count() const { return entries_.size() + foreign_.size(); }
    bool empty() const { return count() == 0; }
    const std::string& source() const { return source_; }
    /// In order of position.
    std::vector<std::string> messages() const;
    /// Throws BadInput unless empty.
    void throw_if_any() const;

  private:
    struct Entry {
        Place place;
        std::string text;
    };
    std::string source_;
    std::vector<Entry> entries_;
    std::vector<std::string> foreign_;
};

/// The whole file. Throws BadInput where it cannot be read or is larger than any description of a joint.
std::string read_text(const std::filesystem::path& file);

/// Throws BadInput with the position of a syntax error. `name` is what messages call the text.
toml::table parse_toml(std::string_view text, const std::string& name);

/// "a number", "text", "a list" …: what a node is, for messages; numbers and short texts with their value.
std::string describe(const toml::node& node);

/// The shortest text that reads back as the same number.
using stickslip::number_text;

/// The table under a key; nothing if it is absent, or after a complaint that it is something else. `path` is what
/// messages call `parent`, empty for the whole file.
const toml::table* table_at(const toml::table& parent, const std::string& key, const std::string& path,
                            Complaints& complaints);

/// Reads text under a key, if there is any; complains about anything else.
void read_text_at(const toml::table& parent, const std::string& key, const std::string& path, std::string& value,
                  Complaints& complaints);

/// Complains about every key that is not allowed, with the nearest one that is.
void complain_unknown_keys(const toml::table& table, const std::vector<std::string>& allowed, const std::string& path,
                           Complaints& complaints);

/// The keys of a table in the order of the file (the parser sorts them by name).
std::vector<std::pair<std::string, const toml::node*>> in_file_order(const toml::table& table);

}  // namespace stickslip::files
