#include "analysis/joint/signs.h"

#include <map>

#include "analysis/joint/joint.h"
#include "analysis/joint/key_collector.h"

namespace stickslip {
namespace {

using Signs = std::map<std::string, Sign, std::less<>>;

std::string replaced(std::string_view text, const std::string& with)
{
    std::string out;
    for (const char c : text) out += c == '#' ? with : std::string(1, c);
    return out;
}

/// "motor-transmission" and "m-tr" of the table "motor_transmission".
std::string joined_words(std::string_view table, bool shortened)
{
    constexpr std::pair<std::string_view, std::string_view> bodies[] = {
        {"motor", "m"}, {"transmission", "tr"}, {"link", "l"}};
    std::string text;
    while (!table.empty()) {
        const std::string_view word = table.substr(0, table.find('_'));
        table.remove_prefix(std::min(table.size(), word.size() + 1));
        std::string shown(word);
        for (const auto& [body, letters] : bodies)
            if (shortened && word == body) shown = letters;
        text += (text.empty() ? "" : "-") + shown;
    }
    return text;
}

/// Visits a joint as its readers do, and every law that a body may have rather than the one that it has.
struct SignCollector : Walk {
    Signs& found;
    std::string_view table_key = {};

    explicit SignCollector(Signs& signs) : found(signs) {}
    void add(const Field& f)
    {
        if (f.symbol.empty()) return;
        found.try_emplace(path(f.key), Sign{replaced(f.symbol, joined_words(table_key, true)),
                                            replaced(f.name, joined_words(table_key, false)), f.quantity});
    }
    void number(const Field& f, double&) { add(f); }
    void numbers(const Field& f, NumberList&) { add(f); }
    void flag(std::string_view, std::string_view, bool&) {}
    void text(std::string_view, std::string_view, std::string&) {}
    template <class Enum, std::size_t n>
    void choice(std::string_view, std::string_view, Enum&, const Choice<Enum> (&)[n])
    {
    }
    template <class Struct>
    void table(std::string_view key, std::string_view, Struct& s)
    {
        const std::string_view outer = table_key;
        table_key = key;
        enter(key, s, *this);
        table_key = outer;
    }
    template <class Struct, int capacity>
    void rows(std::string_view, std::string_view, ShortList<Struct, capacity>&)
    {
    }
    template <class... Laws>
    void law(std::variant<Laws...>&)
    {
        (any_law<Laws>(), ...);
    }
    template <class Law>
    void any_law()
    {
        Law law{};
        Law::fields(law, *this);
    }
};

Signs collected()
{
    Signs signs;
    for (const auto& model : models)
        for (const auto& structure : structures)
            for (const auto& kind : actuator_kinds) {
                Joint joint;
                joint.mechanism.model = model.value;
                joint.control.structure = structure.value;
                joint.actuator.kind = kind.value;
                SignCollector collector(signs);
                Joint::fields(joint, collector);
            }
    return signs;
}

}  // namespace

const Sign* sign_of(std::string_view path)
{
    static const Signs signs = collected();
    const auto found = signs.find(path);
    return found == signs.end() ? nullptr : &found->second;
}

}  // namespace stickslip
