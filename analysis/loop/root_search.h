// The roots of a loop that is no matrix, found from lines along which it turns fastest where a root is near.
#pragma once
#include <complex>
#include <optional>
#include <vector>

#include "analysis/loop/opened_loop.h"

namespace stickslip {

/// Newton's method from `s`; nothing where it does not settle. A step of `rounding` is none, nor is one that no longer
/// shrinks beside a root: of slow roots of fast loops rounding takes the last digits.
std::optional<std::complex<double>> polished_root(const OpenedLoop& open, double gain, std::complex<double> s,
                                                  double rounding);

class RootSearch {
  public:
    using Complex = std::complex<double>;
    static constexpr std::size_t many = 24;
    /// `most` places of each line, the steepest, are taken for starts of Newton's method.
    RootSearch(const OpenedLoop& open, double gain, std::size_t most = many);

    /// Roots from the steepest places of a line. How many lie right of it, where that can be counted.
    std::optional<int> look(double sigma, double nearest = infinity);
    /// The imaginary axis and lines left of it, by what dead time turns in.
    void look_around();
    /// The rightmost root, right of which counting finds none; nothing where it is not found.
    /// It is one of `all()` from then on.
    std::optional<Complex> edge();
    /// The same from the steepest places alone, without what costs more.
    std::optional<Complex> edge_of_steepest();
    /// The same by Newton's method from places near roots, and from the steepest places where these were not all.
    std::optional<Complex> edge_from(const std::vector<Complex>& starts);
    /// With their conjugates, by falling real part.
    std::vector<Complex> all() const;

  private:
    std::optional<Complex> edge_by_newton();
    /// Looks along lines ever further right of σ, as long as roots are counted there, until one is found.
    bool climb(double sigma);
    /// A pole that the loop does not reach through its dead time: the root beside it differs by less than rounding.
    std::optional<Complex> edge_at_pole() const;
    /// By halving, with a count at each line; its frequency is that at which the loop turns fastest on the last one.
    std::optional<Complex> edge_by_counting() const;
    /// Newton's method without the poles of the loop, which would catch it, and the roots that are known; nothing where
    /// it does not come near one.
    std::optional<Complex> near_root(Complex s) const;
    bool knows_right_of(double sigma) const;
    /// Whether a line further left counts no roots but known ones right of it. Lines next to the root may leave their
    /// count open: those past poles that a split of delayed friction puts into its terms, where these lose their
    /// digits.
    bool are_all_known(Complex rightmost) const;
    void take(Complex start);
    void add(Complex root);
    bool is_known(Complex s) const;

    const OpenedLoop& open_;
    double gain_, unit_;
    std::size_t most_;
    bool climbed_ = false;
    std::vector<Complex> roots_;
};

}  // namespace stickslip
