// On which side of the cycle that repels a motion lies, from few of its turns.
#pragma once
#include "analysis/simulation/lanes/secant.h"

#include <algorithm>
#include <cmath>

namespace stickslip::lanes {

/// Largest determinant of the return map from which it counts as a map of the line: what lies off its slow direction
/// is then less than a thousandth after one turn.
inline constexpr double off_the_line = 1e-3;

/// Bound of that determinant about a closed orbit of period T. By Liouville's formula it is the exponential of the
/// integral of the divergence, −(c + e^−w)/M − w' and −e^w (slip law) or −e^(−p/β) (ageing law) in the equations of
/// job.h. About a closed orbit the means of w', X' and p' are 0, so that those of e^w and e^(−p/β) are 1, and that of
/// e^−w is at least 1 by Jensen's inequality. A turn that creeps is nearly closed.
inline double largest_determinant(double period, double c, double M)
{
    return std::exp(-period * (1 + (1 + c) / M));
}

/// A map of the line keeps the order of its points: what grows in one turn grows in all that follow and never comes
/// back; what shrinks comes back unless a smaller cycle stops it. Where a turn of a smaller motion grows, there is one
/// between the two. That there is none is told by g, the growth a turn, as a polynomial in s = a², the square of the
/// amplitude: g(0) is the linear theory's, two amplitudes close by give its slope, and turns at those amplitudes where
/// it comes nearest to 0 give the rest. It has to be negative all the way down, with its last term and with twice that.
class BasinSide {
  public:
    enum class Told { nothing, decays, leaves };

    void forget() { *this = {}; }

    /// After a turn. `linear` is g(0), `error` that of a growth; `weak`: the motion is weakly nonlinear. `proposal` is
    /// where the next turn starts: at `end`, at another amplitude, or back where the motion was.
    Told after(Point start, Point end, double linear, double error, bool weak, Point& proposal)
    {
        moved_ = false;
        if (++turns_ < 2) return Told::nothing;  // the first turn falls onto the line
        const double square = dot(start, start), growth = std::log(length(end) / length(start));
        if (count_ > 0) return compare(square, growth, end, linear, error, proposal);
        const bool grows = growth > error, shrinks = growth < -error;
        if (grows && grew_) return Told::leaves;
        if (shrinks && shrank_ && weak && linear < 0 && square < next_try_) {
            left_ = end;
            note(square, growth, linear);
            move(small_move * end, proposal);
        }
        grew_ = grows, shrank_ = shrinks;
        return Told::nothing;
    }
    /// Whether the last proposal was another point than the end of the turn.
    bool moved() const { return moved_; }

  private:
    static constexpr int most = 7;              ///< amplitudes that are compared
    static constexpr double small_move = 0.98;  ///< of the amplitude: two cycles that close between show in the slope
    static constexpr double retry = 0.8;        ///< of a², from which a motion that was not told is tried again
    static constexpr double known = 0.1;        ///< of g(0), to which the slope has to be known
    static constexpr int nodes = 200;           ///< between 0 and a², at which the polynomial is looked at

    void move(Point to, Point& proposal)
    {
        proposal = to;
        turns_ = 0;
        moved_ = true;
    }

    /// Newton's divided differences, with (0, g(0)) as the first point.
    void note(double square, double growth, double linear)
    {
        if (count_ == 0) square_[0] = 0, term_[0] = linear, count_ = 1;
        double value = growth;
        for (int i = 0; i < count_; ++i) value = (value - term_[i]) / (square - square_[i]);
        square_[count_] = square, term_[count_++] = value;
    }

    Told compare(double square, double growth, Point end, double linear, double error, Point& proposal)
    {
        if (growth > error) return go_back(Told::leaves, proposal);
        const double first = square_[1], apart = first - square;
        note(square, growth, linear);
        const bool sure = growth < -error && apart > 0 && 2 * error * first < known * -linear * apart;
        if (!sure) return go_back(Told::nothing, proposal);
        double next = first / 2, highest = -HUGE_VAL;
        const bool negative = all_negative(next, highest);
        if (count_ > 3 && negative) return Told::decays;
        if (count_ == 3 && negative) next = first / 2;
        for (int i = 1; i < count_; ++i)
            if (std::abs(next - square_[i]) < first / nodes) return go_back(Told::nothing, proposal);
        if (count_ > most) return go_back(Told::nothing, proposal);
        move(std::sqrt(next / dot(end, end)) * end, proposal);
        return Told::nothing;
    }

    /// Whether the polynomial is; otherwise `at` is where it is highest.
    bool all_negative(double& at, double& highest) const
    {
        for (int i = 1; i < nodes; ++i) {
            const double s = square_[1] * i / nodes;
            double value = 0, product = 1, last = 0;
            for (int k = 0; k < count_; ++k) {
                last = term_[k] * product;
                value += last;
                product *= s - square_[k];
            }
            const double worst = std::max(value, value + last);
            if (worst > highest) highest = worst, at = s;
        }
        return highest < 0;
    }

    Told go_back(Told told, Point& proposal)
    {
        const Point back = left_;
        const double square = square_[1];
        forget();
        next_try_ = told == Told::nothing ? retry * square : 0;
        move(back, proposal);
        return told;
    }

    int turns_ = 0;  ///< since the motion was last moved
    bool grew_ = false, shrank_ = false, moved_ = false;
    double square_[most + 2] = {}, term_[most + 2] = {};  ///< of the polynomial
    int count_ = 0;
    double next_try_ = HUGE_VAL;  ///< a² below which amplitudes are compared
    Point left_;                  ///< where the motion was left for that
};

}  // namespace stickslip::lanes
