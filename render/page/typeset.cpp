#include "render/page/typeset.h"

#include <array>
#include <cctype>
#include <cstdlib>

namespace stickslip::drawing {
namespace {

constexpr std::string_view no_break = "\u00a0", minus = "\u2212";
// what stands between two parts of one number or before it, with spaces around
constexpr std::array<std::string_view, 9> signs{"×", "±", "≤", "≥", "≈", "=", "<", ">", "−"};
constexpr std::array<std::string_view, 24> units{"m",  "g",   "s",   "N",   "V",   "A", "W",   "Ω",
                                                 "J",  "K",   "Pa",  "Hz",  "°C",  "°", "rad", "1/s",
                                                 "dB", "deg", "rpm", "min", "rms", "%", "h",   "C"};
constexpr std::array<std::string_view, 8> prefixes{"p", "n", "µ", "m", "c", "k", "M", "G"};

bool digit(char c)
{
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}
bool letter(char c)
{
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || (c & 0x80) != 0;
}

/// What follows a unit: the end, another factor, an exponent or a stop, and no letter.
bool unit_ends(std::string_view rest)
{
    for (const std::string_view further : {"·", "²", "³", "…", "\u00a0"})
        if (rest.starts_with(further)) return true;
    if (rest.empty()) return true;
    if (rest[0] == '.') return rest.size() == 1 || rest[1] == ' ';
    return !letter(rest[0]) && !digit(rest[0]) && rest[0] != '_' && rest[0] != '-';
}

bool unit_at(std::string_view text)
{
    for (const auto unit : units) {
        if (text.starts_with(unit) && unit_ends(text.substr(unit.size()))) return true;
        for (const auto prefix : prefixes)
            if (text.starts_with(prefix) && text.substr(prefix.size()).starts_with(unit) &&
                unit_ends(text.substr(prefix.size() + unit.size())))
                return true;
    }
    return false;
}

bool number_at(std::string_view text)
{
    for (const std::string_view sign : {minus, std::string_view("-"), std::string_view("+")})
        if (text.starts_with(sign)) text.remove_prefix(sign.size());
    return !text.empty() && digit(text[0]);
}

bool sign_at(std::string_view text)
{
    for (const auto sign : signs)
        if (text.starts_with(sign) && (text.size() == sign.size() || text[sign.size()] == ' ')) return true;
    return false;
}

bool ends_with_sign(std::string_view done)
{
    for (const auto sign : signs)
        if (done.ends_with(sign)) return true;
    return false;
}

/// The exponent of a number written as a program does, "e-05" behind a digit; empty where there is none.
std::string_view exponent_at(std::string_view text)
{
    if (text.empty() || text[0] != 'e') return {};
    std::size_t end = 1;
    if (end < text.size() && (text[end] == '-' || text[end] == '+')) ++end;
    const std::size_t first = end;
    while (end < text.size() && digit(text[end])) ++end;
    if (end == first || (end < text.size() && (letter(text[end]) || text[end] == '_'))) return {};
    return text.substr(0, end);
}

/// Whether a word that begins here may be a number: behind a space, a bracket or a sign, not inside a name or an
/// option.
bool word_begins(std::string_view done)
{
    if (done.empty()) return true;
    const char last = done.back();
    return last == ' ' || last == '(' || last == '[' || done.ends_with(no_break) || done.ends_with(minus) ||
           done.ends_with("±") || done.ends_with("×") || done.ends_with("≤") || done.ends_with("≥");
}

/// What stands for the space between `done` and `next`.
std::string_view space_between(std::string_view done, std::string_view next)
{
    const bool after_number = !done.empty() && (digit(done.back()) || done.back() == '}' || done.ends_with("∞"));
    const bool glued = (after_number && (unit_at(next) || next.starts_with("×") || next.starts_with("±"))) ||
                       (ends_with_sign(done) && number_at(next)) || (sign_at(next) && done.ends_with('}'));
    return glued ? no_break : std::string_view(" ");
}

std::string power_of_ten(std::string_view exponent)
{
    const int power = std::atoi(std::string(exponent.substr(1)).c_str());
    return "×10^{" + std::string(power < 0 ? minus : "") + std::to_string(std::abs(power)) + "}";
}

}  // namespace

std::string typeset(std::string_view markup)
{
    std::string done;
    bool in_number = false;
    for (std::size_t i = 0; i < markup.size();) {
        const std::string_view rest = markup.substr(i);
        const char c = rest[0];
        const std::string_view exponent = in_number && digit(done.back()) ? exponent_at(rest) : std::string_view{};
        if (!exponent.empty()) {
            done += power_of_ten(exponent);
            in_number = false;
            i += exponent.size();
            continue;
        }
        if (digit(c))
            in_number = in_number || word_begins(done);
        else if (c != '.')
            in_number = false;
        if (c == '-' && word_begins(done) && rest.size() > 1 && digit(rest[1]))
            done += minus;
        else if (c == ' ')
            done += space_between(done, rest.substr(1));
        else
            done += c;
        ++i;
    }
    return done;
}

}  // namespace stickslip::drawing
