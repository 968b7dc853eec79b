#include "tests/blind/generate/outside.h"

#include "tests/blind/generate/random.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace blind {
namespace {

constexpr double longest_record = 60;  // s

/// What a spring beyond |q| = where feels, 0 inside.
double beyond(double q, double where)
{
    return std::copysign(std::max(std::abs(q) - where, 0.0), q);
}

}  // namespace

OutsideForce::OutsideForce(const Outside& outside) : outside_(outside)
{
    if (outside.kind != Outside::Kind::random_force && outside.kind != Outside::Kind::bumps) return;
    Draw draw(outside.seed);
    for (double t = 0; t < longest_record; t += outside.width) samples_.push_back(draw.normal());
}

double OutsideForce::followed(double q) const
{
    return std::clamp(follower_, q - outside_.width, q + outside_.width);
}

double OutsideForce::force(double t, double q, double v) const
{
    const auto& o = outside_;
    switch (o.kind) {
        case Outside::Kind::none:
        case Outside::Kind::changing_inertia:
            return 0;
        case Outside::Kind::quadratic_drag:
            return -o.size * v * std::abs(v);
        case Outside::Kind::softening_ends: {
            const double x = beyond(q, o.where) / o.width;
            return o.size * x / (1 + x * x);
        }
        case Outside::Kind::hardening_ends:
            return -o.size * beyond(q, o.where) / o.width;
        case Outside::Kind::cubic_spring:
            return -o.size * std::pow(q / o.where, 3);
        case Outside::Kind::hysteretic_load:
            return -o.size * followed(q) / o.where;
        case Outside::Kind::local_obstacle: {
            const double x = (q - o.where) / o.width;
            return o.size * x * std::exp(0.5 * (1 - x * x));
        }
        case Outside::Kind::random_force: {
            const double x = t / o.width;
            const auto i = std::min(static_cast<std::size_t>(x), samples_.size() - 2);
            return o.size * std::lerp(samples_[i], samples_[i + 1], x - i);
        }
        case Outside::Kind::bumps: {
            // A half-sine push of one tenth of the slot, at a place in the slot and of a strength that the seed
            // decides.
            const double x = t / o.width;
            const auto i = std::min(static_cast<std::size_t>(x), samples_.size() - 1);
            const double begin = 0.45 + 0.4 * std::sin(1e3 * samples_[i]);
            const double inside = (x - i - begin) / 0.1;
            return inside < 0 || inside > 1 ? 0 : o.size * samples_[i] * std::sin(std::numbers::pi * inside);
        }
    }
    return 0;
}

double OutsideForce::inertia_factor(double t) const
{
    if (outside_.kind != Outside::Kind::changing_inertia) return 1;
    return 1 + outside_.size * 0.5 * (1 + std::tanh((t - outside_.where) / outside_.width));
}

const std::vector<std::pair<std::string, Outside::Kind>>& outside_kinds()
{
    using Kind = Outside::Kind;
    static const std::vector<std::pair<std::string, Kind>> kinds = {
        {"quadratic-drag", Kind::quadratic_drag},     {"softening-ends", Kind::softening_ends},
        {"hardening-ends", Kind::hardening_ends},     {"cubic-spring", Kind::cubic_spring},
        {"hysteretic-load", Kind::hysteretic_load},   {"bumps", Kind::bumps},
        {"changing-inertia", Kind::changing_inertia}, {"random-force", Kind::random_force},
        {"local-obstacle", Kind::local_obstacle},
    };
    return kinds;
}

}  // namespace blind
