#include "sweep/study/check/boundaries.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

namespace stickslip {
namespace {

constexpr double finer = 10;  ///< ratio of brackets from which a point counts as refined

}  // namespace

std::string WatchedBoundary::name() const
{
    std::string text = fmt::format("{} along {} [{}]", theory, axis, number);
    for (const auto& [path, value] : at)
        text += fmt::format("{}{} = {:.9g}", &path == &at.front().first ? " at " : ", ", path, value);
    return text;
}

std::vector<Deviation> compare(const std::vector<WatchedBoundary>& stored, const std::vector<WatchedBoundary>& now)
{
    std::map<std::string, const WatchedBoundary*> left;
    for (const auto& w : now) left[w.name()] = &w;
    std::vector<Deviation> deviations;
    for (const auto& s : stored) {
        Deviation d;
        d.stored = s;
        if (const auto it = left.find(s.name()); it == left.end()) {
            d.kind = Deviation::Kind::vanished;
        } else {
            d.now = *it->second;
            left.erase(it);
            d.relative = std::abs(d.now.point.value - s.point.value) / std::abs(s.point.value);
            const double before = s.point.precision(), after = d.now.point.precision();
            if (d.now.unit != s.unit || d.now.point.direction != s.point.direction)
                d.kind = Deviation::Kind::changed;
            else if (!(d.relative <= s.tolerance))
                d.kind = Deviation::Kind::moved;
            else if (after > s.tolerance)
                d.kind = Deviation::Kind::coarser;
            else if (finer * after < before && d.relative > after)
                d.kind = Deviation::Kind::refined;
        }
        deviations.push_back(std::move(d));
    }
    for (const auto& w : now)
        if (left.contains(w.name())) deviations.push_back({Deviation::Kind::appeared, {}, w, 0});
    return deviations;
}

}  // namespace stickslip
