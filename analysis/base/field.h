// How a struct of parameters describes itself: each leaf once, with its key, quantity, allowed range and meaning.
// Reading TOML, checking, dotted paths, axes, `list parameters` and the canonical text all walk this one description.
//
// A struct offers   template <class Self, class Visitor> static void fields(Self& self, Visitor& visit)
// and a visitor offers number, numbers, flag, choice, text, table, rows (parameters.cpp has one).
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <stdexcept>
#include <string_view>

#include "analysis/results/quantity.h"

namespace stickslip {

/// The value of a number that was not given: NaN. Test it by is_set.
inline constexpr double not_set = std::numeric_limits<double>::quiet_NaN();
/// False for NaN.
inline bool is_set(double value)
{
    return !std::isnan(value);
}

/// The values that a number may take. An open end excludes the bound itself.
struct Range {
    double low = -std::numeric_limits<double>::infinity();  ///< least value, in the unit of the number
    double high = std::numeric_limits<double>::infinity();  ///< greatest value, in the same unit
    bool low_open = true, high_open = true;                 ///< the bound itself is excluded
    bool whole = false;                                     ///< whole numbers only

    /// Whether a value lies in the range; NaN does not.
    constexpr bool holds(double v) const
    {
        return (low_open ? v > low : v >= low) && (high_open ? v < high : v <= high) &&
               (!whole || v == static_cast<double>(static_cast<long long>(v)));
    }
};

/// A limit that does not exist: an effort without a limit, an interval without an end.
inline constexpr double infinity = std::numeric_limits<double>::infinity();
/// Every finite number.
inline constexpr Range any_finite{};
/// > 0.
inline constexpr Range positive{0, infinity, true, true};
/// ≥ 0.
inline constexpr Range not_negative{0, infinity, false, true};
/// Within [0, 1), and within [0, 1].
inline constexpr Range below_one{0, 1, false, true}, part_of_one{0, 1, false, false};
/// A whole number from 1 to 10⁹.
inline constexpr Range whole_positive{1, 1e9, false, false, true};

/// Whether a number has a default.
enum class Need { required, optional };

/// What a number is to those that move numbers of a joint about, whatever its path. Numbers of a friction law are `law`
/// unless they say otherwise.
enum class Role {
    plain,
    inertia,    ///< of a body of the mechanism
    stiffness,  ///< of its transmission
    speed,      ///< commanded velocity, or the rate of the force that stands for it
    law,        ///< of a friction law: it may be off, and stability depends on it
    label       ///< of a law, but only names a unit or a level: the linear theory does not read it
};

/// What is known of one numeric leaf. `help` is half a sentence; the unit follows from quantity and motion.
struct Field {
    std::string_view key;                     ///< as files write it, the last part of its path
    Quantity quantity = Quantity::number;     ///< from which its unit follows
    Range range = any_finite;                 ///< allowed values, in SI
    Need need = Need::optional;               ///< a required number has no default
    std::string_view help;                    ///< half a sentence, without the unit
    Role role = Role::plain;                  ///< what maps and fits take it for
    std::string_view symbol = {}, name = {};  ///< on charts and pages; empty: the key stands for itself

    /// "k_{p}", "position gain". A # stands for the table of the number: signs.h.
    constexpr Field called(std::string_view sign, std::string_view word) const
    {
        Field named = *this;
        named.symbol = sign, named.name = word;
        return named;
    }
};

/// A short list of numbers inside a parameter struct (the states of a law); plain data, no allocation.
template <class T, int capacity>
struct ShortList {
    static constexpr int max_size = capacity;  ///< room for so many
    std::array<T, capacity> values{};          ///< the first `size` of them count
    int size = 0;                              ///< how many count

    ShortList() = default;
    /// Of these: `law.B = {1.0, 0.5}`. Throws std::length_error where there is no room for them.
    ShortList(std::initializer_list<T> these)
    {
        if (these.size() > static_cast<std::size_t>(capacity)) throw std::length_error("too many for a short list");
        for (const T& v : these) push_back(v);
    }

    T& operator[](int i) { return values[static_cast<std::size_t>(i)]; }
    const T& operator[](int i) const { return values[static_cast<std::size_t>(i)]; }
    T* begin() { return values.data(); }
    T* end() { return values.data() + size; }
    const T* begin() const { return values.data(); }
    const T* end() const { return values.data() + size; }
    /// Appends one; the caller keeps size below max_size.
    void push_back(const T& v) { values[static_cast<std::size_t>(size++)] = v; }
};

inline constexpr int max_states = 8;  ///< states of one friction law
/// Numbers of a law with one for each of its states.
using NumberList = ShortList<double, max_states>;

/// One name of a choice, as it stands in a file.
template <class Enum>
struct Choice {
    std::string_view name;  ///< as files write it
    Enum value;             ///< what the name stands for
};

}  // namespace stickslip
