// The return map of the section w = 0 in two coordinates, and the search for its fixed point by secants of past turns.
#pragma once
#include <cmath>

namespace stickslip::lanes {

inline constexpr double closure = 3e-7;  ///< remaining distance to the fixed point of the return map, per amplitude
inline constexpr double uncertain_multiplier = 0.995;  ///< beyond, the reference decides

struct Point {
    double a = 0, b = 0;  ///< K X and p: both in units of A
};

inline Point operator+(Point u, Point v)
{
    return {u.a + v.a, u.b + v.b};
}
inline Point operator-(Point u, Point v)
{
    return {u.a - v.a, u.b - v.b};
}
inline Point operator*(double s, Point u)
{
    return {s * u.a, s * u.b};
}
inline double dot(Point u, Point v)
{
    return u.a * v.a + u.b * v.b;
}
inline double length(Point u)
{
    return std::sqrt(dot(u, u));
}

/// Turn after turn: fixed point of P by the secants of the last two differences (Anderson's method with memory 2,
/// in two dimensions Newton with a secant Jacobian). The return map contracts strongly across the slow manifold, so
/// that one secant is often all there is to learn; nearly parallel ones are used as one.
class SecantSearch {
  public:
    enum class State { searching, closed, lost };

    /// Takes P(start) and gives the start of the next turn.
    /// `may_vanish` says that the motion may also decay to steady sliding, which no step may then anticipate.
    State next(Point start, Point end, bool may_vanish, Point& proposal)
    {
        const Point gap = end - start;
        const double size = length(end);
        proposal = end;
        if (count_ > 0) {
            const Point moved = start - start_[0], changed = gap - gap_[0];
            multiplier_ = 1 + dot(moved, changed) / dot(moved, moved);
            Point step = along_one(gap, moved, changed);
            if (count_ > 1) step = along_two(gap, moved, changed, start_[0] - start_[1], gap_[0] - gap_[1], step);
            const Point target = end + step;
            const double remaining = length(target - start);
            const bool contracts = multiplier_ < 1;
            if (contracts && remaining < closure * size && length(gap) < 1e-3 * size) return State::closed;
            if (!contracts) {
                // small amplitudes repel: outwards, not to the fixed point that is being left
                proposal = 2.0 * end;
                forget();
                return State::searching;
            }
            const double reach = length(target) / size;
            const bool vanishing = may_vanish && dot(target, end) < 0.3 * size * size;
            if (vanishing && multiplier_ > 0.6) {
                proposal = 0.6 * end;  // a creeping decay with nothing ahead
                forget();
                return State::searching;
            }
            if (!vanishing && reach > 0.3 && reach < 3) proposal = target;
        }
        start_[1] = start_[0], gap_[1] = gap_[0];
        start_[0] = start, gap_[0] = gap;
        if (count_ < 2) ++count_;
        return std::isfinite(proposal.a + proposal.b) ? State::searching : State::lost;
    }
    double multiplier() const { return multiplier_; }
    void forget() { count_ = 0; }

  private:
    static Point along_one(Point gap, Point moved, Point changed)
    {
        const double share = dot(changed, gap) / dot(changed, changed);
        return -share * (moved + changed);
    }
    static Point along_two(Point gap, Point m0, Point c0, Point m1, Point c1, Point otherwise)
    {
        const double det = c0.a * c1.b - c0.b * c1.a;
        if (!(std::abs(det) > 1e-3 * length(c0) * length(c1))) return otherwise;
        const double s0 = (gap.a * c1.b - gap.b * c1.a) / det, s1 = (c0.a * gap.b - c0.b * gap.a) / det;
        return -1.0 * (s0 * (m0 + c0) + s1 * (m1 + c1));
    }

    Point start_[2], gap_[2];
    int count_ = 0;
    double multiplier_ = 0;
};

}  // namespace stickslip::lanes
