#include "drawing_build.h"  // made by the build
#include "render/drawing/fonts.h"
#include "render/members.h"
#include "render/render.h"

#include <xxhash.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

namespace stickslip {
namespace {

struct Freed {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

/// Everything that lies within plain structs, lists, pairs, texts and what may be absent; lengths too, so that no two
/// arrangements meet.
class Key {
  public:
    Key() : state_(XXH3_createState()) { XXH3_128bits_reset(state_.get()); }

    template <class T>
    void add(const T& value)
    {
        if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>)
            bytes(&value, sizeof value);
        else
            std::apply([this](const auto&... member) { (add(member), ...); }, drawing::members(value));
    }
    void add(const Units& units) { add(units.motion), add(units.command); }
    void add(const std::string& text)
    {
        add(text.size());
        bytes(text.data(), text.size());
    }
    template <class T>
    void add(const std::vector<T>& list)
    {
        add(list.size());
        if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>)
            bytes(list.data(), list.size() * sizeof(T));
        else
            for (const T& item : list) add(item);
    }
    template <class T>
    void add(const std::optional<T>& value)
    {
        add(value.has_value());
        if (value) add(*value);
    }
    template <class A, class B>
    void add(const std::pair<A, B>& pair)
    {
        add(pair.first);
        add(pair.second);
    }

    std::string text() const
    {
        const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
        char digits[33];
        std::snprintf(digits, sizeof digits, "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                      static_cast<unsigned long long>(hash.low64));
        return digits;
    }

  private:
    void bytes(const void* from, std::size_t count) { XXH3_128bits_update(state_.get(), from, count); }

    std::unique_ptr<XXH3_state_t, Freed> state_;
};

/// Another file of letters is noticed by its place and size.
void add_typeface(Key& key)
{
    const drawing::Fonts fonts = drawing::find_fonts();
    key.add(fonts.missing);
    for (const auto& file : {fonts.regular, fonts.bold}) {
        std::error_code none;
        key.add(file);
        key.add(std::filesystem::file_size(file, none));
    }
}

}  // namespace

std::string figure_key(const Figure& figure)
{
    Key key;
    key.add(std::string(drawing_build::sources));
    key.add(std::string(drawing_build::libraries));
    add_typeface(key);
    key.add(figure.finding);  // spoken with the picture; the caption stands beside it
    key.add(figure.picture.index());
    std::visit([&key](const auto& picture) { key.add(picture); }, figure.picture);
    return key.text();
}

}  // namespace stickslip
