#include "analysis/diagnosis/verdict/experiment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip::gap {
namespace {

struct Motion_ {
    const char* description;
    double (*at)(double t, double duration, double span, double speed);
};

double smooth_start(double t)
{
    return t < 1 ? t * t * (3 - 2 * t) : 1;
}

// speed is the 95th percentile of the records, span theirs too: no motion asks for more than the joint has shown
constexpr Motion_ motions[] = {
    {"a slow triangle over the whole range at a hundredth of the usual speed",
     [](double t, double, double span, double speed) {
         const double period = std::max(4.0, span / (0.02 * speed)), s = std::fmod(t, period) / period;
         return 0.5 * span * (s < 0.5 ? 2 * s : 2 - 2 * s) * smooth_start(t);
     }},
    {"a sine of small amplitude with many reversals",
     [](double t, double, double span, double) {
         return 0.03 * span * std::sin(2 * std::numbers::pi * t) * smooth_start(t);
     }},
    {"a chirp from 0.2 to 5 Hz whose amplitude falls as its frequency rises",
     [](double t, double duration, double span, double speed) {
         const double sweep = std::log(25.0) / duration, f = 0.2 * std::exp(sweep * t);
         const double phase = 2 * std::numbers::pi * 0.2 * std::expm1(sweep * t) / sweep;
         return std::min(0.4 * span, speed / (2 * std::numbers::pi * f)) * std::sin(phase) * smooth_start(t);
     }},
    {"steps over the whole range with rests of two seconds",
     [](double t, double, double span, double speed) {
         const double rise = std::max(0.1, span / speed), s = std::fmod(t, 4.0);
         const double up = std::clamp(s / rise, 0.0, 1.0), down = std::clamp((s - 2) / rise, 0.0, 1.0);
         const auto soft = [](double x) { return x * x * (3 - 2 * x); };
         return 0.8 * span * (soft(up) - soft(down));
     }},
    {"speed steps: the same distance at a tenth, a third and the whole of the usual speed",
     [](double t, double, double span, double speed) {
         const double v = speed * (std::fmod(t, 9) < 3 ? 0.1 : std::fmod(t, 9) < 6 ? 0.33 : 1);
         const double period = std::max(1.0, 2 * span / v), s = std::fmod(t, period) / period;
         return 0.5 * span * (s < 0.5 ? 2 * s : 2 - 2 * s) * smooth_start(t);
     }},
};

}  // namespace

std::vector<std::string> names_of(const Candidate& candidate)
{
    std::vector<std::string> names;
    for (const auto* e : candidate.effects) names.emplace_back(e->name);
    return names;
}

std::string joined(const std::vector<std::string>& names)
{
    std::string text;
    for (const auto& n : names) text += (text.empty() ? "" : " + ") + n;
    return text;
}

NextExperiment design_experiment(const Case& like, const Scales& scales, const Attribution& winner,
                                 const Attribution& rival)
{
    NextExperiment best;
    best.separates.emplace_back(joined(names_of(winner.candidate)), joined(names_of(rival.candidate)));
    if (!is_set(like.joint.control.k_p)) return best;
    const double period = is_set(like.joint.control.period) ? like.joint.control.period : like.row_step;
    const double duration = std::min(20.0, std::max(8.0, like.ticks.duration()));
    const double start = like.ticks.position.front();
    const double towards = [&] {
        const auto [low, high] = std::minmax_element(like.ticks.position.begin(), like.ticks.position.end());
        return *high - start >= start - *low ? 1.0 : -1.0;
    }();
    for (const auto& motion : motions) {
        Record r;
        const auto rows = static_cast<std::size_t>(duration / period);
        for (std::size_t k = 0; k < rows; ++k) {
            r.time.push_back(static_cast<double>(k) * period);
            r.reference_position.push_back(start +
                                           towards * motion.at(r.time[k], duration, scales.position, scales.velocity));
        }
        r.position.assign(rows, start);
        Case c = like;
        c.ticks = on_clock(r, like.joint);
        const auto run = [&](const Attribution& a) {
            return closed_loop(
                flatten(edited(like.joint, a.candidate, in_si(a.candidate, a.x[1], scales), like.number)), c.ticks, 0);
        };
        const Trace one = run(winner), two = run(rival);
        double square = 0;
        const double effort_sigma = std::max(like.effort_sigma, 0.01 * scales.effort);
        for (std::size_t k = 0; k < rows; ++k) {
            const double q = (one.position[k] - two.position[k]) / like.sigma,
                         f = (one.effort[k] - two.effort[k]) / effort_sigma;
            square += q * q + f * f;
        }
        const double distance = std::sqrt(square / static_cast<double>(std::max<std::size_t>(rows, 1)));
        if (std::isfinite(distance) && distance > best.distance) {
            best.distance = distance;
            best.description = motion.description;
            best.time.clear();
            best.reference.clear();
            for (std::size_t k = 0; k < rows; ++k) {
                best.time.push_back(r.time[k]);
                best.reference.push_back(r.reference_position[k]);
            }
        }
    }
    return best;
}

}  // namespace stickslip::gap
