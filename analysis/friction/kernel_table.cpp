#include "analysis/friction/kernel_table.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

using Complex = std::complex<double>;

/// ∫_0^1 u^n e^{−zu} du for n = 0, 1, 2: by recursion from the closed form, by its power series where z is small.
struct UnitIntegrals {
    Complex e0, e1, e2;
};
UnitIntegrals unit_integrals(Complex z)
{
    if (std::abs(z) < 1) {
        UnitIntegrals sum{0, 0, 0};
        Complex term = 1;  // (−z)^k / k!
        for (int k = 0; k < 22 && std::abs(term.real()) + std::abs(term.imag()) > 1e-18; ++k) {
            sum.e0 += term / double(k + 1);
            sum.e1 += term / double(k + 2);
            sum.e2 += term / double(k + 3);
            term *= -z / double(k + 1);
        }
        return sum;
    }
    const Complex decay = std::exp(-z);
    const Complex e0 = (1.0 - decay) / z, e1 = (e0 - decay) / z;
    return {e0, e1, (2.0 * e1 - decay) / z};
}

/// e^{−s t} and the integrals over each piece, one after the other: pieces as long as the one before share its
/// integrals, and e^{−s t} goes on by a factor a piece.
class Pieces {
  public:
    Pieces(const KernelTable& table, Complex s) : table_(table), s_(s), same_(4e-16 * table.duration()) {}

    /// Sum of piece(t0, h, a, b, e^{−s t0}, integrals).
    template <class Piece>
    Complex sum(Piece&& piece)
    {
        constexpr std::size_t exactly = 32;  // pieces after which e^{−s t} is computed anew: rounding adds up
        Complex sum = 0, weight = 1;
        for (std::size_t k = 0; k + 1 < table_.time.size(); ++k) {
            const double t0 = table_.time[k], h = table_.time[k + 1] - t0;
            if (k % exactly == 0) weight = std::exp(-s_ * t0);
            if (!(std::abs(h - h_) <= same_)) h_ = h, integrals_ = unit_integrals(s_ * h), decay_ = std::exp(-s_ * h);
            sum += piece(t0, h, table_.value[k], table_.value[k + 1], weight, integrals_);
            weight *= decay_;
        }
        return sum;
    }

  private:
    const KernelTable& table_;
    Complex s_;
    double same_, h_ = -1;
    UnitIntegrals integrals_{};
    Complex decay_;
};

}  // namespace

std::string KernelTable::problem() const
{
    if (time.size() != value.size()) return "the table has unequal columns";
    if (time.size() < 2) return "the table needs at least two rows";
    if (time[0] != 0) return "the table must start at time 0";
    for (std::size_t k = 0; k < time.size(); ++k) {
        if (!std::isfinite(time[k]) || !std::isfinite(value[k]))
            return "row " + std::to_string(k + 1) + " of the table is not finite";
        if (k > 0 && !(time[k] > time[k - 1]))
            return "the times of the table must rise, row " + std::to_string(k + 1) + " does not";
    }
    return "";
}

double KernelTable::at(double t) const
{
    if (!(t >= 0) || t > time.back()) return 0;
    const auto next = std::upper_bound(time.begin(), time.end(), t);
    if (next == time.end()) return value.back();
    const auto k = static_cast<std::size_t>(next - time.begin());
    return std::lerp(value[k - 1], value[k], (t - time[k - 1]) / (time[k] - time[k - 1]));
}

Complex KernelTable::transform(Complex s) const
{
    // a piece is a + (b − a) u with t = t0 + h u
    return Pieces(*this, s).sum([](double, double h, double a, double b, Complex weight, const UnitIntegrals& e) {
        return h * weight * (a * e.e0 + (b - a) * e.e1);
    });
}

Complex KernelTable::transform_slope(Complex s) const
{
    return Pieces(*this, s).sum([](double t0, double h, double a, double b, Complex weight, const UnitIntegrals& e) {
        return -h * weight * (t0 * (a * e.e0 + (b - a) * e.e1) + h * (a * e.e1 + (b - a) * e.e2));
    });
}

double KernelTable::moment(int n, double sigma) const
{
    double sum = 0;
    for (std::size_t k = 0; k + 1 < time.size(); ++k) {
        const double t0 = time[k], t1 = time[k + 1];
        double largest = sigma == 0 ? 1 : std::exp(-sigma * (sigma > 0 ? t0 : t1));
        for (int i = 0; i < n; ++i) largest *= t1;
        sum += (t1 - t0) * std::max(std::abs(value[k]), std::abs(value[k + 1])) * largest;
    }
    return sum;
}

double KernelTable::variation() const
{
    double sum = std::abs(value.front()) + std::abs(value.back());
    for (std::size_t k = 0; k + 1 < value.size(); ++k) sum += std::abs(value[k + 1] - value[k]);
    return sum;
}

}  // namespace stickslip
