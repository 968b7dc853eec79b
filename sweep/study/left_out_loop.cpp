#include "sweep/study/left_out_loop.h"

#include "analysis/joint/gains.h"
#include "analysis/joint/parameters.h"
#include "analysis/stability/verdict.h"

namespace stickslip {

std::optional<LeftOutLoop> left_out_loop(const Joint& described)
{
    auto loop = left_out_by_ideal(described);
    if (loop.used.empty()) return std::nullopt;
    const bool cascade = described.control.structure == Structure::cascade;
    return LeftOutLoop{{std::move(loop), growth_rate(described)}, cascade ? with_gains(described) : described};
}

bool kept_by_ideal(const Joint& ideal, const std::string& path)
{
    constexpr double other = 0.5;  // no default of any number
    Joint changed = ideal;
    if (!find_parameter(changed, path)) return false;
    number_at(changed, path) = other;
    changed = with_ideal_loop(changed);
    return *find_parameter(changed, path) == other;
}

}  // namespace stickslip
