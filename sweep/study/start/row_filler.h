// One row in lists that are empty, so that the keys of a row are there to be listed and its numbers to be filled.
#pragma once
#include "analysis/joint/joint.h"

#include <string>
#include <string_view>
#include <variant>

namespace stickslip {

/// A visitor of the fields of a joint.
struct RowFiller {
    /// All; or those that a law needs: delays and neighbours are a choice. Lists of numbers are filled only there.
    enum class Lists { all, needed };
    Lists lists = Lists::all;

    void number(const Field&, double&) {}
    void numbers(const Field& f, NumberList& list)
    {
        if (lists == Lists::needed && list.size == 0 && f.need == Need::required) list.push_back(not_set);
    }
    void flag(std::string_view, std::string_view, bool&) {}
    void text(std::string_view, std::string_view, std::string&) {}
    void samples(std::string_view, std::string_view, std::string&, KernelTablePtr&) {}
    template <class Enum, std::size_t n>
    void choice(std::string_view, std::string_view, Enum&, const Choice<Enum> (&)[n])
    {
    }
    template <class Struct>
    void table(std::string_view, std::string_view, Struct& s)
    {
        Struct::fields(s, *this);
    }
    template <class Struct, int capacity>
    void rows(std::string_view key, std::string_view, ShortList<Struct, capacity>& list)
    {
        const bool chosen = key == "delays" || key == "neighbour";
        if (list.size == 0 && (lists == Lists::all || !chosen)) list.push_back({});
    }
    template <class... Laws>
    void law(std::variant<Laws...>& law)
    {
        std::visit([this](auto& l) { std::decay_t<decltype(l)>::fields(l, *this); }, law);
    }
};

}  // namespace stickslip
