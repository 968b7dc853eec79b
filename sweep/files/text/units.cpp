#include "sweep/files/text/units.h"

#include "sweep/files/text/unit_symbols.h"

#include <charconv>
#include <cmath>
#include <optional>

namespace stickslip {
namespace {

constexpr int max_decimals = 60;  // beyond any unit that means something; keeps exponents from overflowing
constexpr int max_depth = 8;      // of brackets

/// Moments of inertia as data sheets print them, without a sign between the units: the square is the length's alone.
constexpr Dimension inertia_d{{2, 1, 0, 0, 0, 0}};
constexpr std::pair<std::string_view, int> printed_inertias[] = {
    {"kgm", 0}, {"kgcm", -4}, {"kgmm", -6}, {"gcm", -7}, {"gmm", -9}};

/// Recursive descent over a unit text; the first thing that is wrong stops it.
class UnitParser {
  public:
    explicit UnitParser(std::string_view text) : rest_(text) {}

    UnitReading parse()
    {
        const Unit unit = product(0);
        if (error_.empty() && !rest_.empty()) fail("cannot read \"" + std::string(rest_) + "\" of the unit");
        return {unit, error_};
    }

  private:
    void fail(const std::string& why)
    {
        if (error_.empty()) error_ = why;
    }
    bool take(std::string_view word)
    {
        if (!rest_.starts_with(word)) return false;
        rest_.remove_prefix(word.size());
        return true;
    }
    void skip_spaces()
    {
        while (take(" ") || take("\u00a0")) {
        }
    }
    bool take_times() { return take("\u00b7") || take("\u22c5") || take("\u00d7") || take("*") || take("."); }

    Unit product(int depth)
    {
        Unit unit = power(depth);
        bool plain = true;
        while (error_.empty()) {
            skip_spaces();
            if (rest_.empty() || rest_.front() == ')') break;
            const bool divide = take("/");
            if (!divide) take_times();
            skip_spaces();
            plain = false;
            const Unit next = power(depth);
            if (next.offset != 0) fail("a temperature in °C cannot stand in a product of units, write K");
            combine(unit, next, divide ? -1 : 1);
        }
        if (!plain && unit.offset != 0) fail("a temperature in °C cannot stand in a product of units, write K");
        return unit;
    }

    /// "kgcm2", "gcm²": taken whole.
    std::optional<Unit> printed_inertia()
    {
        for (const auto& [name, decimals] : printed_inertias)
            for (const std::string_view square : {"2", "²", "^2"})
                if (rest_.starts_with(name) && rest_.substr(name.size()).starts_with(square)) {
                    rest_.remove_prefix(name.size() + square.size());
                    return Unit{inertia_d, 1, decimals};
                }
        return {};
    }

    Unit power(int depth)
    {
        skip_spaces();
        if (const auto inertia = printed_inertia()) return *inertia;
        Unit base;
        if (take("(")) {
            if (depth >= max_depth) fail("too many brackets in the unit");
            if (error_.empty()) base = product(depth + 1);
            skip_spaces();
            if (!take(")")) fail("a bracket of the unit is not closed");
        } else {
            base = symbol();
        }
        const int exponent = this->exponent();
        if (exponent == 1) return base;
        if (base.offset != 0) fail("a temperature in °C has no powers, write K");
        Unit unit;
        combine(unit, base, exponent);
        return unit;
    }

    Unit symbol()
    {
        std::size_t end = 0;
        while (end < rest_.size() && is_symbol_byte(end)) ++end;
        const std::string_view name = rest_.substr(0, end);
        if (name.empty()) {
            fail(rest_.empty() ? "the unit ends too early" : "cannot read \"" + std::string(rest_) + "\" of the unit");
            return {};
        }
        rest_.remove_prefix(end);
        if (const auto unit = unit_named(name)) return *unit;
        fail("unknown unit \"" + std::string(name) + "\"");
        return {};
    }

    /// Letters, the percent sign, "1", and every non-ASCII character that is not an operator, a space or a raised
    /// digit.
    bool is_symbol_byte(std::size_t at) const
    {
        const auto c = static_cast<unsigned char>(rest_[at]);
        if (c < 0x80) return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '%' || (c == '1' && at == 0);
        if ((c & 0xc0) == 0x80) return at > 0;  // inside a character that was accepted
        const auto tail = rest_.substr(at);
        for (std::string_view stop : {"\u00b7", "\u22c5", "\u00d7", "\u00a0", "²", "³", "¹", "⁻", "⁴"})
            if (tail.starts_with(stop)) return false;
        return true;
    }

    int exponent()
    {
        const bool caret = take("^") || take("**");
        const bool negative = take("⁻") || (caret && take("-"));
        for (auto [text, value] : {std::pair{"¹", 1}, {"²", 2}, {"³", 3}, {"⁴", 4}})
            if (take(text)) return negative ? -value : value;
        if (!caret && !negative)
            for (auto [text, value] : {std::pair{"2", 2}, {"3", 3}, {"4", 4}})  // "m/s2", as data sheets print it
                if (take(text)) return value;
        if (!caret && !negative) return 1;
        int value = 0;
        const auto [end, status] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (!caret || status != std::errc{} || value < 1 || value > 4) {
            fail("a power in the unit is not within 1 to 4");
            return 1;
        }
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return negative ? -value : value;
    }

    void combine(Unit& unit, const Unit& next, int exponent)
    {
        for (std::size_t i = 0; i < unit.dimension.power.size(); ++i)
            unit.dimension.power[i] += exponent * next.dimension.power[i];
        unit.factor *= std::pow(next.factor, exponent);
        unit.decimals += exponent * next.decimals;
        if (std::abs(unit.decimals) > max_decimals) fail("the unit is too large or too small to mean something");
    }

    std::string_view rest_;
    std::string error_;
};

std::string in_quotes(std::string_view text)
{
    std::string quoted(1, '"');
    quoted += text;
    quoted += '"';
    return quoted;
}

std::string_view trimmed(std::string_view text)
{
    while (text.starts_with(' ')) text.remove_prefix(1);
    while (text.ends_with(' ')) text.remove_suffix(1);
    return text;
}

}  // namespace

double Unit::to_si(double value) const
{
    // 10^|decimals| is exact up to 22, and one division rounds once where multiplying by 1e-6 would round twice
    const double tens = std::pow(10.0, std::abs(decimals));
    return (decimals < 0 ? value / tens : value * tens) * factor + offset;
}

UnitReading parse_unit(std::string_view text)
{
    return UnitParser(trimmed(text)).parse();
}

UnitReading unit_for(std::string_view unit_text, Quantity quantity, Units units)
{
    UnitReading reading = parse_unit(unit_text);
    const std::string expected(unit_of(quantity, units));
    const Unit target = parse_unit(expected).unit;
    if (!reading.error.empty()) {
        reading.error += ", expected " + (expected == "1" ? "a number without unit" : expected);
    } else if (reading.unit.dimension != target.dimension) {
        reading.error = in_quotes(trimmed(unit_text)) + " is not a unit of this quantity, expected " +
                        (expected == "1" ? "a number without unit" : expected);
    }
    reading.unit.offset -= target.offset;
    return reading;
}

NumberReading parse_number_with_unit(std::string_view given, Quantity quantity, Units units)
{
    const std::string_view text = trimmed(given);
    const std::string expected(unit_of(quantity, units));
    const std::string quoted = in_quotes(given);
    const char* begin = text.data();
    const char* const end = begin + text.size();
    if (text.starts_with('+')) ++begin;
    double value = 0;
    const auto number = std::from_chars(begin, end, value);
    if (number.ec == std::errc::result_out_of_range) return {0, quoted + " is too large or too small for a number"};
    if (number.ec != std::errc{} || !std::isfinite(value))
        return {0, quoted + " is not a number" + (expected == "1" ? "" : " with a unit such as " + expected)};
    const std::string_view unit_text = trimmed({number.ptr, static_cast<std::size_t>(end - number.ptr)});
    if (unit_text.empty())
        return {0, quoted + " is text without a unit, expected a number without quotes" +
                       (expected == "1" ? "" : " (" + expected + ") or with a unit")};
    const UnitReading reading = unit_for(unit_text, quantity, units);
    if (!reading.error.empty()) return {0, quoted + ": " + reading.error};

    // Shift the decimal exponent in the text, so that the result is rounded once.
    std::string digits(begin, number.ptr);
    int exponent = reading.unit.decimals;
    if (const auto e = digits.find_first_of("eE"); e != std::string::npos) {
        int written = 0;
        const char* from = digits.data() + e + 1;
        std::from_chars(*from == '+' ? from + 1 : from, digits.data() + digits.size(), written);
        exponent += written;
        digits.resize(e);
    }
    digits += 'e';
    digits += std::to_string(exponent);
    if (std::from_chars(digits.data(), digits.data() + digits.size(), value).ec != std::errc{})
        return {0, quoted + " is too large or too small for a number"};
    value = value * reading.unit.factor + reading.unit.offset;
    if (!std::isfinite(value)) return {0, quoted + " is too large for a number"};
    return {value, ""};
}

}  // namespace stickslip
