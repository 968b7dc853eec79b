#include "analysis/results/boundary.h"

#include "analysis/results/point.h"

#include <algorithm>

namespace stickslip {

std::string_view name_of(BoundaryKind kind)
{
    constexpr std::string_view names[] = {"velocity-only", "linear", "v-min", "fold", "outcome", "hunting"};
    return names[static_cast<int>(kind)];
}

std::string_view name_of(LocationMethod method)
{
    constexpr std::string_view names[] = {"interpolation", "bisection", "shooting"};
    return names[static_cast<int>(method)];
}

std::string_view name_of(CurveEnd end)
{
    constexpr std::string_view names[] = {"closed", "border", "undecided", "vanished", "lost"};
    return names[static_cast<int>(end)];
}

int FollowedBoundary::points() const
{
    int sum = 0;
    for (const auto& piece : pieces) sum += static_cast<int>(piece.points.size());
    return sum;
}

double FollowedBoundary::precision() const
{
    double coarsest = 0;
    for (const auto& piece : pieces)
        for (const auto& point : piece.points) coarsest = std::max(coarsest, point.at.precision());
    return coarsest;
}

Curve curve_of(const FollowedBoundary& boundary)
{
    Curve curve;
    switch (boundary.kind) {
        case BoundaryKind::velocity_only:
            curve.kind = Curve::Kind::velocity_only;
            break;
        case BoundaryKind::state_variable:
        case BoundaryKind::v_min:
            curve.kind = Curve::Kind::state_variable;
            break;
        case BoundaryKind::fold:
            curve.kind = Curve::Kind::fold;
            break;
        case BoundaryKind::outcome:
        case BoundaryKind::hunting:
            curve.kind = Curve::Kind::outcome;
            break;
    }
    curve.precision = boundary.precision();
    for (const auto& piece : boundary.pieces) {
        if (!curve.x.empty()) {
            curve.x.push_back(missing);
            curve.y.push_back(missing);
        }
        for (const auto& point : piece.points) curve.x.push_back(point.x), curve.y.push_back(point.y);
        if (piece.last == CurveEnd::closed && !piece.points.empty())
            curve.x.push_back(piece.points.front().x), curve.y.push_back(piece.points.front().y);
    }
    return curve;
}

}  // namespace stickslip
