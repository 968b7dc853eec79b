// Least squares of a command on what two gains multiply: the one regression of position and velocity gain.
#pragma once
#include <cmath>
#include <vector>

namespace stickslip::gap {

/// u = k_p·a + k_v·b over rows. What is left is summed row by row, since the difference of two large sums would end at
/// a part in 10⁸ of them.
class GainRegression {
  public:
    struct Row {
        double a, b, u;
    };
    struct Answer {
        double k_p = 0, k_v = 0, k_p_error = 0, k_v_error = 0;
        double misfit = 1;         ///< rms of what is left over rms of u
        double used = 0, rms = 0;  ///< rows, and the rms of u over them
        bool both = false;         ///< whether b could be distinguished from a
    };

    void add(double a, double b, double u) { rows_.push_back({a, b, u}); }
    const std::vector<Row>& rows() const { return rows_; }
    static double left(const Row& row, const Answer& x) { return row.u - x.k_p * row.a - x.k_v * row.b; }

    /// Rows that `take` refuses are left out.
    template <class Take>
    Answer solve(bool with_k_v, const Take& take) const
    {
        constexpr double collinear = 1e-14;  // numerical: of the determinant
        double aa = 0, ab = 0, bb = 0, au = 0, bu = 0, uu = 0;
        Answer x;
        for (const Row& r : rows_) {
            if (!take(r)) continue;
            aa += r.a * r.a, ab += r.a * r.b, bb += r.b * r.b, au += r.a * r.u, bu += r.b * r.u, uu += r.u * r.u;
            x.used += 1;
        }
        const double determinant = aa * bb - ab * ab;
        x.both = with_k_v && determinant > collinear * aa * bb;
        if (x.both)
            x.k_p = (au * bb - bu * ab) / determinant, x.k_v = (bu * aa - au * ab) / determinant;
        else if (aa > 0)
            x.k_p = au / aa;
        double squares = 0;
        for (const Row& r : rows_)
            if (take(r)) squares += left(r, x) * left(r, x);
        if (x.used == 0) return x;
        x.misfit = uu > 0 ? std::sqrt(squares / uu) : 0;
        x.rms = std::sqrt(uu / x.used);
        const double variance = squares / x.used;
        if (x.both)
            x.k_p_error = std::sqrt(variance * bb / determinant), x.k_v_error = std::sqrt(variance * aa / determinant);
        else if (aa > 0)
            x.k_p_error = std::sqrt(variance / aa);
        return x;
    }
    Answer solve(bool with_k_v) const
    {
        return solve(with_k_v, [](const Row&) { return true; });
    }

  private:
    std::vector<Row> rows_;
};

}  // namespace stickslip::gap
