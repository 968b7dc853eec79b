#include "sweep/study/left_out_loop.h"

#include "analysis/joint/gains.h"
#include "analysis/stability/verdict.h"

namespace stickslip {

std::optional<LeftOutLoop> left_out_loop(const Joint& described)
{
    auto loop = left_out_by_ideal(described);
    if (loop.used.empty()) return std::nullopt;
    const bool cascade = described.control.structure == Structure::cascade;
    return LeftOutLoop{cascade ? with_gains(described) : described, std::move(loop), growth_rate(described)};
}

}  // namespace stickslip
