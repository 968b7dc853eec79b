// Plain structs to JSON and back, number for number: every struct lists its fields once (fields.h), for both ways. NaN
// is null; ±∞ are the strings "inf" and "-inf"; codes are their names.
#pragma once
#include "analysis/results/point.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <concepts>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace stickslip::archive {

using Json = nlohmann::ordered_json;

/// T or const T: one list of fields serves writing and reading.
template <class T, class Of>
concept Like = std::same_as<std::remove_const_t<T>, Of>;

/// A copy of the text that lives as long as the program: what string_view fields of read answers point to.
std::string_view kept(const std::string& text);

/// The name of a code, empty beyond the last one; a type without names of its own is written as its number.
template <class Code>
struct Names {
    static std::string_view at(std::size_t) { return {}; }
};

struct Writer;
struct Reader;

template <class T>
concept HasFields = requires(T& value, Writer& writer)
{
    fields(writer, value);
};

Json written(double value);
double read_number(const Json& json);

template <class T>
Json written(const T& value);
template <class T>
void read(const Json& json, T& value);

struct Writer {
    Json json = Json::object();
    template <class T>
    void operator()(const char* key, const T& value)
    {
        json[key] = written(value);
    }
};

struct Reader {
    const Json& json;
    template <class T>
    void operator()(const char* key, T& value)
    {
        const auto found = json.find(key);
        if (found == json.end()) throw std::invalid_argument(std::string("lacks \"") + key + "\"");
        try {
            read(*found, value);
        } catch (const std::invalid_argument& e) {
            throw std::invalid_argument(std::string(key) + ": " + e.what());
        }
    }
};

template <class Code>
Json written_code(Code code)
{
    const auto number = static_cast<std::size_t>(code);
    const auto name = Names<Code>::at(number);
    return name.empty() ? Json(number) : Json(std::string(name));
}

template <class Code>
Code read_code(const Json& json)
{
    if (json.is_number_unsigned()) return static_cast<Code>(json.get<std::size_t>());
    if (json.is_string())
        for (std::size_t i = 0; !Names<Code>::at(i).empty(); ++i)
            if (Names<Code>::at(i) == json.get_ref<const std::string&>()) return static_cast<Code>(i);
    throw std::invalid_argument("is not a known code");
}

template <class T>
struct Kind {
};  // of containers

template <class T>
struct Kind<std::vector<T>> {
    static Json write(const std::vector<T>& list)
    {
        Json json = Json::array();
        for (const auto& item : list) json.push_back(written(item));
        return json;
    }
    static void read_into(const Json& json, std::vector<T>& list)
    {
        if (!json.is_array()) throw std::invalid_argument("is not a list");
        list.resize(json.size());
        for (std::size_t i = 0; i < list.size(); ++i) read(json[i], list[i]);
    }
};

template <class T, std::size_t n>
struct Kind<std::array<T, n>> {
    static Json write(const std::array<T, n>& list)
    {
        Json json = Json::array();
        for (const auto& item : list) json.push_back(written(item));
        return json;
    }
    static void read_into(const Json& json, std::array<T, n>& list)
    {
        if (!json.is_array() || json.size() != n) throw std::invalid_argument("is not a list of the right length");
        for (std::size_t i = 0; i < n; ++i) read(json[i], list[i]);
    }
};

template <class T>
struct Kind<std::optional<T>> {
    static Json write(const std::optional<T>& value) { return value ? written(*value) : Json(nullptr); }
    static void read_into(const Json& json, std::optional<T>& value)
    {
        value.reset();
        if (!json.is_null()) read(json, value.emplace());
    }
};

template <class T>
struct Kind<std::complex<T>> {
    static Json write(const std::complex<T>& value)
    {
        return Json::array({written(value.real()), written(value.imag())});
    }
    static void read_into(const Json& json, std::complex<T>& value)
    {
        if (!json.is_array() || json.size() != 2) throw std::invalid_argument("is not a complex number");
        value = {read_number(json[0]), read_number(json[1])};
    }
};

template <class T>
Json written(const T& value)
{
    if constexpr (HasFields<const T>) {
        Writer writer;
        fields(writer, value);
        return std::move(writer.json);
    } else if constexpr (std::is_enum_v<T>) {
        return written_code(value);
    } else if constexpr (std::same_as<T, std::string_view>) {
        return std::string(value);
    } else if constexpr (std::same_as<T, bool> || std::is_integral_v<T> || std::same_as<T, std::string>) {
        return value;
    } else {
        return Kind<T>::write(value);
    }
}

template <class T>
void read(const Json& json, T& value)
{
    if constexpr (HasFields<T>) {
        if (!json.is_object()) throw std::invalid_argument("is not an object");
        Reader reader{json};
        fields(reader, value);
    } else if constexpr (std::same_as<T, double>) {
        value = read_number(json);
    } else if constexpr (std::is_enum_v<T>) {
        value = read_code<T>(json);
    } else if constexpr (std::same_as<T, bool>) {
        if (!json.is_boolean()) throw std::invalid_argument("is neither true nor false");
        value = json.get<bool>();
    } else if constexpr (std::is_integral_v<T>) {
        if (!json.is_number_integer()) throw std::invalid_argument("is not a whole number");
        value = json.get<T>();
    } else if constexpr (std::same_as<T, std::string> || std::same_as<T, std::string_view>) {
        if (!json.is_string()) throw std::invalid_argument("is not text");
        if constexpr (std::same_as<T, std::string>)
            value = json.get<std::string>();
        else
            value = kept(json.get<std::string>());
    } else {
        Kind<T>::read_into(json, value);
    }
}

}  // namespace stickslip::archive
