#include "sweep/report/pages/guarantee_card.h"

#include "sweep/words/guarantee_text.h"

#include <fmt/format.h>

namespace stickslip {

std::vector<Headline> guarantee_card(const Diagnosis& d)
{
    if (!d.set) return {};
    constexpr std::size_t few = 3;
    const bool short_enough = d.set->size() <= few;
    return {{Headline::Tone::neutral, short_enough ? possible_text(*d.set) : fmt::format("{} causes", d.set->size()),
             fmt::format("guarantee: right for at least {} of 100 such joints{}. {}", of_hundred(d.set->coverage),
                         short_enough ? "" : ": " + possible_text(*d.set), promise_text(*d.set))}};
}

}  // namespace stickslip
