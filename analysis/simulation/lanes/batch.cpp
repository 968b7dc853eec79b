#include "analysis/simulation/lanes/batch.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "analysis/numerics/polynomial.h"
#include "analysis/simulation/attractor/large_disturbance.h"
#include "analysis/simulation/lanes/grouping.h"
#include "analysis/simulation/lanes/stribeck_batch.h"
#include "analysis/stability/steady.h"

namespace stickslip::lanes {
namespace {

bool less(const Groups& a, const Groups& b)
{
    if (a.M != b.M) return a.M < b.M;
    if (a.c != b.c) return a.c < b.c;
    if (a.beta != b.beta) return a.beta < b.beta;
    return a.K < b.K;
}

}  // namespace

std::optional<Scaled> scaled(const Joint& joint)
{
    const auto* law = std::get_if<RateAndState>(&joint.friction.law);
    if (!law || law->B.size != 1 || !single(joint) || !plain(joint.friction, joint.load)) return {};
    const auto sliding = steady_sliding(joint);
    if (sliding.reason != Reason::none) return {};
    const double A = joint.friction.normal_load * law->A, L = law->L[0], V0 = sliding.velocity;
    const auto& control = joint.control;
    Scaled s{{rounded(control.k_p * L / A), rounded(joint.mechanism.inertia * V0 * V0 / (L * A)),
              rounded(law->B[0] / law->A), rounded(control.k_v * V0 / A)},
             L,
             V0,
             sliding.deflection};
    const auto& g = s.groups;
    const bool in_range =
        g.K > 0 && g.M > 1e-12 && g.M < 1e6 && g.K < 1e9 && g.c >= 0 && g.c < 1e6 && g.beta > 0 && g.beta < 1e3;
    if (!in_range) return {};
    return s;
}

bool covers(const NonlinearOptions& options)
{
    const bool small = std::isnan(options.disturbance.size) && options.disturbance.kind == DisturbanceKind::position;
    return small && options.accelerate && !options.bifurcation && !options.fallback_only && options.rtol > 1e-12;
}

Job job(const Groups& g, bool search)
{
    using Complex = std::complex<double>;
    Job job;
    job.groups = g;
    const auto roots = cubic_roots((g.c + 1) / g.M + 1, (g.K + g.c + 1 - g.beta) / g.M, g.K / g.M);
    Complex s = roots[0];
    for (const auto& root : roots)
        if (root.real() > s.real()) s = root;
    const Complex left[3] = {-g.K / g.M / s, 1, -1.0 / (g.M * (s + 1.0))};
    for (int i = 0; i < 3; ++i) job.left[i][0] = left[i].real(), job.left[i][1] = left[i].imag();
    job.rate = s.real();
    job.magnitude = std::abs(s);
    job.window = growth_window(s);
    job.fineness = growth_fineness(s, job.window);
    const double X = probe / job.magnitude;
    job.start[0] = X, job.start[1] = 0, job.start[2] = -g.K * X;
    job.search = search;
    const double w = std::log(near_rest_start), p = -g.beta * w;
    job.rest_start[0] = -(w + p + g.c * std::expm1(w)) / g.K, job.rest_start[1] = w, job.rest_start[2] = p;
    return job;
}

bool write(const Answer& a, const Scaled& s, const Job& job, bool searched, PointResult& point)
{
    point.growth_rate = a.growth * s.velocity / s.length;
    if (a.ending == Ending::left_over) return false;
    point.path = DecisionPath::lanes;
    point.overshoot = small_disturbance / job.magnitude * s.length / std::abs(s.deflection);
    const bool decays = a.ending != Ending::cycle;
    const bool cycle = a.ending != Ending::decays;
    point.outcome = decays ? Outcome::stable_sliding : a.rest_time > 0 ? Outcome::stick_slip : Outcome::limit_cycle;
    if (a.ending == Ending::bistable && searched) point.region = Region::bistable;
    if (!cycle) return true;
    point.amplitude = 0.5 * (a.x_max - a.x_min) * s.length;
    point.velocity_min = s.velocity * std::exp(a.w_min);
    point.velocity_max = s.velocity * std::exp(a.w_max);
    point.period = a.period * s.length / s.velocity;
    point.stick_fraction = a.rest_time / a.period;
    if (a.ending == Ending::cycle) point.overshoot = std::max(0.0, a.x_max) * s.length / std::abs(s.deflection);
    return true;
}

namespace {

/// Answers those joints among `open` that have such groups, each set of groups once; the numbers of the others stay.
template <class Scale>
void answer_those(std::optional<Scale> (*scaled)(const Joint&), std::span<const Joint> joints,
                  const NonlinearOptions& options, std::span<PointResult> points, std::vector<std::size_t>& open)
{
    struct Entry {
        Scale scale;
        std::size_t number;
    };
    std::vector<Entry> entries;
    std::vector<std::size_t> others;
    for (const auto i : open)
        if (const auto s = scaled(joints[i]))
            entries.push_back({*s, i});
        else
            others.push_back(i);
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return a.scale.groups == b.scale.groups ? a.number < b.number : less(a.scale.groups, b.scale.groups);
    });
    std::vector<typename Scale::Job> jobs;
    std::vector<std::size_t> job_of(entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (i == 0 || !(entries[i].scale.groups == entries[i - 1].scale.groups))
            jobs.push_back(job(entries[i].scale.groups, options.region));
        job_of[i] = jobs.size() - 1;
    }
    std::vector<typename Scale::Answer> answers(jobs.size());
    Settings settings;
    settings.rtol = options.rtol;
    run(jobs.data(), answers.data(), jobs.size(), settings, best_instructions());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const auto& e = entries[i];
        if (!write(answers[job_of[i]], e.scale, jobs[job_of[i]], options.region, points[e.number]))
            others.push_back(e.number);
    }
    open = std::move(others);
}

}  // namespace

void answer(std::span<const Joint> joints, const NonlinearOptions& options, std::span<PointResult> points,
            std::vector<std::size_t>& left_over)
{
    std::vector<std::size_t> open(joints.size());
    std::iota(open.begin(), open.end(), std::size_t{0});
    if (covers(options)) {
        answer_those<Scaled>(scaled, joints, options, points, open);
        answer_those<StribeckScaled>(stribeck_scaled, joints, options, points, open);
    }
    left_over.insert(left_over.end(), open.begin(), open.end());
    std::sort(left_over.begin(), left_over.end());
}

}  // namespace stickslip::lanes
