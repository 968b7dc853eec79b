#include "tests/blind/generate/excitation.h"

#include "tests/blind/generate/random.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace blind {
namespace {

constexpr double turn = 2 * std::numbers::pi;

/// Adds a move from rest to rest: acceleration, constant velocity (if there is room for it), deceleration, dwell.
double add_move(Excitation& e, double t, double from, double to, double top_speed, double acceleration, double dwell)
{
    const double sign = to < from ? -1 : 1, distance = std::abs(to - from);
    const double speed = std::min(top_speed, std::sqrt(distance * acceleration));
    const double ramp = speed / acceleration, cruise = distance / speed - ramp;
    const double ramp_distance = 0.5 * speed * ramp;
    e.stretches.push_back({t, from, 0, sign * acceleration});
    e.stretches.push_back({t + ramp, from + sign * ramp_distance, sign * speed, 0});
    e.stretches.push_back({t + ramp + cruise, to - sign * ramp_distance, sign * speed, -sign * acceleration});
    const double end = t + 2 * ramp + cruise;
    e.stretches.push_back({end, to, 0, 0});
    return end + dwell;
}

void add_trapezoids(Excitation& e, double travel, double speed, Draw& draw)
{
    const double acceleration = speed * draw.uniform(4, 12);
    double t = 0.3, from = 0;
    e.stretches.push_back({0, 0, 0, 0});
    while (t < e.duration) {
        double to = 0;
        do to = draw.uniform(-travel, travel);
        while (std::abs(to - from) < 0.25 * travel);
        t = add_move(e, t, from, to, speed * draw.log_uniform(0.4, 2.5), acceleration, draw.uniform(0.1, 0.6));
        from = to;
    }
}

void add_ramps(Excitation& e, double travel, double speed, Draw& draw)
{
    double t = 0.3, from = 0, side = draw.sign();
    e.stretches.push_back({0, 0, 0, 0});
    while (t < e.duration) {
        const double to = side * travel * draw.uniform(0.1, 0.7), velocity = speed * draw.log_uniform(0.05, 0.4);
        e.stretches.push_back({t, from, to < from ? -velocity : velocity, 0});
        t += std::abs(to - from) / velocity;
        from = to;
        side = -side;
        e.stretches.push_back({t, to, 0, 0});
        if (draw.chance(0.3)) t += draw.uniform(0.2, 0.8);
    }
}

void add_steps(Excitation& e, double travel, Draw& draw)
{
    double t = 0.4, from = 0;
    e.stretches.push_back({0, 0, 0, 0});
    while (t < e.duration) {
        double to = 0;
        do to = draw.uniform(-0.7, 0.7) * travel;
        while (std::abs(to - from) < 0.1 * travel);
        e.stretches.push_back({t, to, 0, 0});
        from = to;
        t += draw.uniform(0.6, 1.8);
    }
}

void add_sines(Excitation& e, double travel, int count, double lowest, double highest, Draw& draw)
{
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        const double hertz = lowest * std::pow(highest / lowest, (i + draw.uniform(0.1, 0.9)) / count);
        // Velocities of equal size rather than positions: the fast sines must not saturate everything.
        e.sines.push_back({std::pow(lowest / hertz, 0.8) * draw.uniform(0.6, 1.4), turn * hertz, draw.phase()});
        sum += e.sines.back().amplitude;
    }
    for (auto& sine : e.sines) sine.amplitude *= travel / sum;
}

}  // namespace

Reference Excitation::at(double t) const
{
    if (!stretches.empty()) {
        auto after = std::upper_bound(stretches.begin(), stretches.end(), t,
                                      [](double time, const Stretch& s) { return time < s.begin; });
        const auto& s = *std::prev(after);
        const double x = t - s.begin;
        return {s.position + x * (s.velocity + 0.5 * s.acceleration * x), s.velocity + s.acceleration * x};
    }
    Reference sum;
    for (const auto& s : sines) {
        sum.position += s.amplitude * std::sin(s.rate * t + s.phase);
        sum.velocity += s.amplitude * s.rate * std::cos(s.rate * t + s.phase);
    }
    if (t >= fade) return sum;
    const double x = t / fade, window = x * x * x * (10 + x * (6 * x - 15));
    const double slope = 30 * x * x * (1 - x) * (1 - x) / fade;
    return {window * sum.position, window * sum.velocity + slope * sum.position};
}

const std::vector<std::string>& excitation_kinds()
{
    static const std::vector<std::string> kinds = {"slow-sine",  "multi-sine", "steps",
                                                   "trapezoids", "slow-ramps", "reversals"};
    return kinds;
}

Excitation draw_excitation(const std::string& kind, double travel, double speed, Draw& draw)
{
    Excitation e;
    e.kind = kind;
    e.duration = draw.uniform(10, 25);
    if (kind == "slow-sine") {
        add_sines(e, travel * draw.uniform(0.5, 1), 1, 0.08, 0.25, draw);
    } else if (kind == "multi-sine") {
        add_sines(e, travel * draw.uniform(0.6, 1), 4 + draw.below(3), 0.12, 2.5, draw);
    } else if (kind == "reversals") {
        add_sines(e, travel * draw.uniform(0.15, 0.4), 2, 0.3, 1.2, draw);
    } else if (kind == "steps") {
        add_steps(e, travel, draw);
    } else if (kind == "trapezoids") {
        add_trapezoids(e, travel, speed, draw);
    } else if (kind == "slow-ramps") {
        add_ramps(e, travel, speed, draw);
    } else {
        throw std::invalid_argument("no excitation is called " + kind);
    }
    return e;
}

}  // namespace blind
