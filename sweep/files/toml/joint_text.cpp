// The joint as a TOML file.
#include "analysis/joint/parameters.h"
#include "sweep/files/text/toml_input.h"
#include "sweep/files/toml/joint_file.h"

#include <map>

namespace stickslip {
namespace {

/// A double as TOML reads it: a long whole number would be an integer there, and overflow.
std::string toml_number(double value)
{
    std::string text = files::number_text(value);
    const bool whole = text.find_first_not_of("+-0123456789") == std::string::npos;
    return whole && text.size() > 15 ? text + ".0" : text;
}

std::string toml_string(std::string_view text)
{
    std::string out = "\"";
    for (const char c : text) {
        constexpr std::string_view hex = "0123456789ABCDEF";
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            out += {'\\', c};
        else if (byte < 0x20 || byte == 0x7f)
            out += std::string("\\u00") + hex[byte >> 4] + hex[byte & 15];
        else
            out += c;
    }
    return out + "\"";
}

/// Writes one struct: its own lines first, then its tables, since TOML has no way back out of a table.
class Writer {
  public:
    Writer(Units units, std::string path) : units_(units), path_(std::move(path)) {}

    void number(const Field& f, double& value)
    {
        if (is_set(value)) line(f.key, toml_number(value), unit_comment(f.quantity));
    }
    void numbers(const Field& f, NumberList& list)
    {
        if (list.size == 0) return;
        std::string text;
        for (double v : list) text += (text.empty() ? "" : ", ") + toml_number(v);
        line(f.key, list.size == 1 ? text : "[" + text + "]", unit_comment(f.quantity));
    }
    void flag(std::string_view key, std::string_view, bool& value) { line(key, value ? "true" : "false"); }
    void text(std::string_view key, std::string_view, std::string& value)
    {
        if (!value.empty()) line(key, toml_string(value));
    }
    template <class Enum, std::size_t n>
    void choice(std::string_view key, std::string_view, Enum& value, const Choice<Enum> (&choices)[n])
    {
        for (const auto& c : choices)
            if (c.value == value) choices_ += std::string(key) + " = " + toml_string(c.name) + "\n";
    }
    template <class Struct>
    void table(std::string_view key, std::string_view, Struct& s)
    {
        const std::string path = path_.empty() ? std::string(key) : path_ + "." + std::string(key);
        Struct standard{};
        Writer writer(units_, path), by_default(units_, path);
        Struct::fields(s, writer);
        Struct::fields(standard, by_default);
        if (writer.all() == by_default.all()) return;
        tables_ += writer.without(by_default, "[" + path + "]\n");
    }
    template <class Struct, int capacity>
    void rows(std::string_view key, std::string_view, ShortList<Struct, capacity>& list)
    {
        const std::string path = path_.empty() ? std::string(key) : path_ + "." + std::string(key);
        for (auto& row : list) {
            Writer writer(units_, path);
            Struct::fields(row, writer);
            tables_ += "\n[[" + path + "]]\n" + writer.all();
        }
    }
    template <class... Laws>
    void law(std::variant<Laws...>& law)
    {
        std::visit(
            [this](auto& l) {
                law_ = l.info.name;
                choices_ += "law = " + toml_string(l.info.name) + "\n";
                std::decay_t<decltype(l)>::fields(l, *this);
            },
            law);
    }

    std::string all() const
    {
        std::string text = choices_;
        for (const auto& [key, value] : lines_) text += value;
        return text + tables_;
    }

  private:
    void line(std::string_view key, const std::string& value, const std::string& comment = "")
    {
        lines_.emplace_back(std::string(key), std::string(key) + " = " + value + comment + "\n");
    }
    std::string unit_comment(Quantity quantity) const
    {
        const auto unit = unit_of(quantity, units_);
        return unit == "1" ? "" : "   # " + std::string(unit);
    }
    /// Leaves out the lines that the defaults have too; the header is needed only for lines of its own.
    std::string without(const Writer& by_default, const std::string& header) const
    {
        std::map<std::string, std::string> standard;
        // another law has defaults of its own under the same keys
        if (law_ == by_default.law_) standard.insert(by_default.lines_.begin(), by_default.lines_.end());
        std::string text = choices_;
        for (const auto& [key, value] : lines_)
            if (const auto found = standard.find(key); found == standard.end() || found->second != value) text += value;
        return (text.empty() ? "" : "\n" + header + text) + tables_;
    }

    Units units_;
    std::string path_;
    std::string choices_, law_;
    std::vector<std::pair<std::string, std::string>> lines_;
    std::string tables_;
};

}  // namespace

std::string joint_text(const Joint& given)
{
    Joint joint = given;
    joint.pose = {};  // no part of a joint file, which has the numbers of the pose
    Writer writer(units_of(joint), "");
    Joint::fields(joint, writer);
    const std::string text = writer.all();
    return text.starts_with('\n') ? text.substr(1) : text;
}

}  // namespace stickslip
