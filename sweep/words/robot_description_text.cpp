#include "sweep/words/inertia_text.h"

#include <fmt/format.h>

namespace stickslip {

std::string impossible_inertia_text(const ImpossibleInertia& of)
{
    const auto& I = of.moments;
    return fmt::format(
        "{}: {} has the principal inertias {:.4g}, {:.4g} and {:.4g} kg·m², which no rigid body has: the greatest is "
        "above the sum of the others. It counts as it is written.",
        of.place, of.body, I[0], I[1], I[2]);
}

}  // namespace stickslip
