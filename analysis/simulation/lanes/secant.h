// The return map of the section w = 0 in two coordinates, and the search for its fixed point by secants of past turns.
#pragma once
#include <algorithm>
#include <cmath>

namespace stickslip::lanes {

inline constexpr double closure = 3e-7;  ///< remaining distance to the fixed point of the return map, per amplitude
inline constexpr double uncertain_multiplier = 0.995;  ///< beyond, the reference decides
/// Distance to the fixed point, per amplitude, from which a motion whose basin is wanted is taken to it by secants.
/// A decay to steady sliding has its fixed point a whole amplitude away; past the ghost of a cycle a secant step is no
/// longer than that, and the motion goes on as before.
inline constexpr double near_cycle = 0.05;

/// Growth a turn of a motion that creeps, and by what share one leap may change it.
inline constexpr double creeping = 0.05, share_of_change = 0.2;

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
    /// `close_by` is the distance to the fixed point, per amplitude, at which the search ends.
    State next(Point start, Point end, bool may_vanish, Point& proposal, double close_by = closure)
    {
        const Point gap = end - start;
        const double size = length(end);
        proposal = end;
        if (count_ > 0) {
            const Point moved = start - start_[0], changed = gap - gap_[0];
            multiplier_ = 1 + dot(moved, changed) / dot(moved, moved);
            Point step = along_one(gap, moved, changed);
            moved_[0] = moved, changed_[0] = changed;
            moved_[1] = start_[0] - start_[1], changed_[1] = gap_[0] - gap_[1];
            if (count_ > 1 && !on_line_) step = along_two(gap, moved, changed, moved_[1], changed_[1], step);
            learned_ = count_;
            const Point target = end + step;
            const double remaining = length(target - start);
            const bool contracts = multiplier_ < 1;
            const double largest_gap = std::max(1e-3, 30 * close_by);
            if (contracts && remaining < close_by * size && length(gap) < largest_gap * size) {
                proposal = target;
                if (count_ > 1 && !on_line_) multiplier_ = std::max(multiplier_, multiplier_of_two());
                return multiplier_ < 1 ? State::closed : State::lost;
            }
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

    /// The same where the basin that the motion lies in is the question: turn by turn, until it closes in on a cycle
    /// that clearly attracts. Only then does a secant take the rest of the way.
    State next_in_basin(Point start, Point end, Point& proposal)
    {
        const Point gap = end - start;
        const double size = length(end);
        proposal = end;
        if (count_ > 0) {
            const Point moved = start - start_[0], changed = gap - gap_[0];
            multiplier_ = 1 + dot(moved, changed) / dot(moved, moved);
            const double contraction = 1 - multiplier_;
            const bool near = multiplier_ < uncertain_multiplier && length(gap) < contraction * near_cycle * size;
            if (near) {
                Point step = along_one(gap, moved, changed);
                if (count_ > 1) step = along_two(gap, moved, changed, start_[0] - start_[1], gap_[0] - gap_[1], step);
                const Point target = end + step;
                if (length(target - start) < closure * size && length(gap) < 1e-3 * size) return State::closed;
                if (length(step) < 2 * length(gap) / contraction) proposal = target;
            } else {
                const double ahead = leap(length(start), size);
                if (ahead != 1) {
                    proposal = ahead * end;
                    forget();
                    return State::searching;
                }
            }
        }
        log_size_ = std::log(length(start)), growth_ = std::log(size / length(start));
        start_[1] = start_[0], gap_[1] = gap_[0];
        start_[0] = start, gap_[0] = gap;
        if (count_ < 2) ++count_;
        return std::isfinite(proposal.a + proposal.b) ? State::searching : State::lost;
    }
    /// The fixed point of a map so close to the one searched that its secants serve for the first step; from then on
    /// the map's own.
    State refine(Point start, Point end, Point& proposal)
    {
        const Point gap = end - start;
        if (refined_) {
            moved_[1] = moved_[0], changed_[1] = changed_[0];
            moved_[0] = start - start_[0], changed_[0] = gap - gap_[0];
            learned_ = std::min(learned_ + 1, 2);
        }
        refined_ = true;
        start_[0] = start, gap_[0] = gap;
        Point step = along_one(gap, moved_[0], changed_[0]);
        if (learned_ > 1 && !on_line_) step = along_two(gap, moved_[0], changed_[0], moved_[1], changed_[1], step);
        proposal = end + step;
        return length(proposal - start) < closure * length(end) ? State::closed : State::searching;
    }
    /// The next turn is one of another map, whose own secants are not known.
    void change_map() { refined_ = false; }
    double multiplier() const { return multiplier_; }
    void forget() { count_ = 0; }
    /// Whether the map is one of the line (basin.h): a second secant would hold nothing but the errors of the turns.
    void use_one_secant(bool on_line) { on_line_ = on_line; }

  private:
    /// By what a motion that creeps inwards or outwards may be scaled, so that its growth a turn changes by a fifth.
    double leap(double from, double to) const
    {
        const double growth = std::log(to / from), at = std::log(from);
        const double slope = std::abs((growth - growth_) / (at - log_size_));
        const bool creeps = count_ > 1 && std::abs(growth) < creeping && growth * growth_ > 0;
        const double reach = std::min(share_of_change, share_of_change * std::abs(growth) / slope);
        return creeps && reach > 3 * std::abs(growth) ? std::exp(std::copysign(reach, growth)) : 1;
    }
    /// The larger multiplier of the map that has both secants: along a move across the slow manifold alone a cycle that
    /// repels would look like one that attracts. Of nearly parallel secants that of the last.
    double multiplier_of_two() const
    {
        const Point m0 = moved_[0], m1 = moved_[1], c0 = changed_[0], c1 = changed_[1];
        const double det = m0.a * m1.b - m0.b * m1.a;
        if (!(std::abs(det) > 1e-3 * length(m0) * length(m1))) return multiplier_;
        // the map less 1 is [c0 c1] [m0 m1]⁻¹: its trace and determinant
        const double trace = (c0.a * m1.b - c1.a * m0.b - c0.b * m1.a + c1.b * m0.a) / det;
        const double product = (c0.a * c1.b - c0.b * c1.a) / det;
        const double root = trace * trace / 4 - product;
        return root < 0 ? multiplier_ : 1 + trace / 2 + std::sqrt(root);
    }
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
    Point moved_[2], changed_[2];  ///< the secants of the last step
    int count_ = 0, learned_ = 0;
    bool refined_ = false, on_line_ = false;
    double log_size_ = 0, growth_ = 0;  ///< of the last turn: ln |start|, ln |end|/|start|
    double multiplier_ = 0;
};

/// Whether the turns of a decay leave room for a cycle that is smaller. The growth a turn of a motion of amplitude a is
/// g(a) = g(0) + c a² + d a⁴ + …, and g(0) is the linear theory's: two turns give c, and by how much they miss g(0) is
/// what the fourth power does. Where that is a small part of g, nothing on the way to a = 0 changes its sign.
class SmallerCycles {
  public:
    void forget() { turns_ = 0, clear_ = 0; }

    /// After each turn; `linear` is g(0). True once two turns in a row, each clearly smaller than the one before, say
    /// that there is none.
    bool none(Point start, Point end, double linear)
    {
        const double square = dot(start, start), growth = std::log(length(end) / length(start));
        if (turns_ > 0 && square > apart * square_) return false;
        if (turns_++ > 0) {
            const double at_zero = (growth * square_ - growth_ * square) / (square_ - square);
            const bool decays = linear < 0 && growth < 0;
            clear_ = decays && std::abs(at_zero - linear) < small_part * std::abs(growth) ? clear_ + 1 : 0;
        }
        square_ = square, growth_ = growth;
        return clear_ > 1;
    }

  private:
    static constexpr double apart = 0.8;        ///< of squares of amplitudes, beyond which two turns say too little
    static constexpr double small_part = 0.25;  ///< of g that its fourth power may be
    int turns_ = 0, clear_ = 0;
    double square_ = 0, growth_ = 0;
};

}  // namespace stickslip::lanes
