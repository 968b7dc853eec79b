#include "analysis/stability/neutral.h"

#include <algorithm>

#include "analysis/stability/characteristic.h"

namespace stickslip {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// A number that adds up the sizes of everything that it was computed from.
struct Size {
    double value = 0;

    Size() = default;
    Size(double v) : value(std::abs(v)) {}
};
Size operator+(Size a, Size b)
{
    return a.value + b.value;
}
Size operator-(Size a, Size b)
{
    return a.value + b.value;
}
Size operator*(Size a, Size b)
{
    return a.value * b.value;
}

double size_of_transfer(const LinearFriction& f, Complex s)
{
    double sum = 0;
    for (int i = 0; i < f.states; ++i) sum += std::abs(f.weight(i) / (s - f.lambda[i]));
    for (const auto& d : f.delays) sum += std::abs(d.weight) * std::exp(-s.real() * d.time);
    if (f.table) sum += std::abs(f.table_scale) * f.table->moment(0, s.real());
    return sum;
}

}  // namespace

double side_of_axis(const LinearMass& mass, Complex s)
{
    if (far_from_axis(s)) return s.real();
    const auto& f = mass.friction;
    Complex memory = 0, memory_slope = 0;  // the slope times s, as at the slowest velocities it is no number itself
    for (int i = 0; i < f.states; ++i) {
        const Complex gap = s - f.lambda[i];
        memory += f.weight(i) / gap;
        memory_slope -= f.weight(i) / gap * (s / gap);
    }
    const double size = std::abs(s);
    const double terms = mass.inertia * size * size +
                         (std::abs(mass.k_v) + std::abs(f.f_v) + size_of_transfer(f, s)) * size + std::abs(mass.k_p);
    return clear_of_rounding(s, terms, 2 * mass.inertia * s + mass.k_v + f.f_v - memory - memory_slope);
}

double side_of_axis(const LinearJoint& j, Complex s)
{
    if (far_from_axis(s)) return s.real();
    std::array<Size, max_bodies> resistance, scale;
    for (int i = 0; i < j.bodies; ++i) {
        resistance[i] = std::abs(j.friction[i].f_v) + size_of_transfer(j.friction[i], s);
        scale[i] = 1.0;
    }
    const double size = std::abs(s);
    const auto parts = characteristic(j, Size(size), resistance, scale);
    const double terms = parts.a.value + (std::abs(j.k_p) + std::abs(j.k_v) * size) * parts.b.value;
    return clear_of_rounding(s, terms, closed_loop(j, s).slope);
}

double polynomial_side_of_axis(const Polynomial& p, Complex start)
{
    struct At {
        Complex value, slope;
        double terms;
    };
    const auto at = [&](Complex s) {
        At sum{p.c[p.degree()], 0, std::abs(p.c[p.degree()])};
        for (int k = p.degree(); k-- > 0;) {
            sum.slope = sum.slope * s + sum.value;
            sum.value = sum.value * s + p.c[k];
            sum.terms = sum.terms * std::abs(s) + std::abs(p.c[k]);
        }
        return sum;
    };
    Complex s = start;
    for (int i = 0; i < 20; ++i) {
        const auto here = at(s);
        const Complex step = here.value / here.slope;
        if (!(std::abs(step) < 0.5 * std::abs(s))) return start.real();
        s -= step;
        if (std::abs(step) < 4 * epsilon * std::abs(s)) break;
    }
    const auto here = at(s);
    return clear_of_rounding(s, here.terms, here.slope);
}

double velocity_only_damping(const LinearMass& mass, double k_v)
{
    const double C = k_v + steady_slope(mass.friction);
    if (!(mass.k_p > 0)) return C;
    const double omega = std::sqrt(mass.k_p / mass.inertia);
    const Complex root(-C / (2 * mass.inertia), omega);
    if (far_from_axis(root)) return C;
    const double terms =
        2 * mass.k_p + (std::abs(k_v) + std::abs(mass.friction.f_v) + size_of_transfer(mass.friction, 0)) * omega;
    const Complex slope(0, 2 * mass.inertia * omega);
    return clear_of_rounding(root, terms, slope) == 0 ? 0 : C;
}

}  // namespace stickslip
