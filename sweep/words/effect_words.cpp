#include "sweep/words/effect_words.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace stickslip {
namespace {

/// Of those whose name is not their words with hyphens for spaces.
constexpr std::pair<std::string_view, std::string_view> own_words[] = {
    {"coulomb-level", "Coulomb level"},
    {"feed-forward", "feed-forward"},
    {"gain-k_i", "integral gain"},
    {"gain-k_p", "position gain"},
    {"gain-k_v", "velocity gain"},
    {"load-dependent-friction", "load-dependent friction"},
    {"stribeck", "Stribeck friction"},
    {"viscous", "viscous friction"},
    {"position-dependent-friction", "position-dependent friction"},
};

}  // namespace

std::string effect_words(std::string_view name)
{
    const auto own = std::ranges::find(own_words, name, &std::pair<std::string_view, std::string_view>::first);
    if (own != std::end(own_words)) return std::string(own->second);
    std::string words(name);
    if (name.find_first_of("./") == std::string_view::npos) std::ranges::replace(words, '-', ' ');
    return words;
}

}  // namespace stickslip
