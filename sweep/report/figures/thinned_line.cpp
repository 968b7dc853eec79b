#include "sweep/report/figures/thinned_line.h"

#include <algorithm>

namespace stickslip {
namespace {

/// Twice as many as a page is wide, so that a zoomed picture still has an outline. Evidence: pictures of 300,000
/// samples are beyond what their conversion to pixels reads (a motion of 6 s at 10 kHz).
constexpr std::size_t stretches = 4000, shown = 4 * stretches;

/// Of each stretch of so many samples the first, the lowest, the highest and the last, in their order.
std::vector<std::size_t> outline(const std::vector<double>& y)
{
    const std::size_t each = (y.size() + stretches - 1) / stretches;
    std::vector<std::size_t> kept;
    for (std::size_t from = 0; from < y.size(); from += each) {
        const std::size_t to = std::min(from + each, y.size());
        const auto first = y.begin() + static_cast<std::ptrdiff_t>(from),
                   end = y.begin() + static_cast<std::ptrdiff_t>(to);
        const auto [low, high] = std::minmax_element(first, end);
        std::size_t four[] = {from, static_cast<std::size_t>(low - y.begin()),
                              static_cast<std::size_t>(high - y.begin()), to - 1};
        std::sort(std::begin(four), std::end(four));
        kept.insert(kept.end(), std::begin(four), std::unique(std::begin(four), std::end(four)));
    }
    return kept;
}

std::vector<std::size_t> each_nth(std::size_t count)
{
    const std::size_t n = (count + shown - 1) / shown;
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < count; i += n) kept.push_back(i);
    if (kept.back() + 1 != count) kept.push_back(count - 1);
    return kept;
}

}  // namespace

LineChart::Line thinned(LineChart::Line line)
{
    const std::size_t count = std::min(line.x.size(), line.y.size());
    if (count <= shown) return line;
    const auto kept = std::is_sorted(line.x.begin(), line.x.end()) ? outline(line.y) : each_nth(count);
    std::vector<double> x, y;
    for (const std::size_t i : kept) x.push_back(line.x[i]), y.push_back(line.y[i]);
    line.x = std::move(x), line.y = std::move(y);
    return line;
}

}  // namespace stickslip
