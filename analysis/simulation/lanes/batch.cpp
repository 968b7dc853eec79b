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
    if (a.law != b.law) return a.law < b.law;
    if (a.M != b.M) return a.M < b.M;
    if (a.c != b.c) return a.c < b.c;
    if (a.beta != b.beta) return a.beta < b.beta;
    return a.K < b.K;
}

}  // namespace

std::optional<Scaled> scaled(const Joint& joint)
{
    const auto [law, kind] = one_state(joint.friction);
    if (!law || !single(joint) || !plain(joint.friction, joint.load)) return {};
    const auto sliding = steady_sliding(joint);
    if (sliding.reason != Reason::none) return {};
    const double A = joint.friction.normal_load * law->A, L = law->L[0], V0 = sliding.velocity;
    const auto& control = joint.control;
    Scaled s{{rounded(control.k_p * L / A), rounded(joint.mechanism.inertia * V0 * V0 / (L * A)),
              rounded(law->B[0] / law->A), rounded(control.k_v * V0 / A), kind},
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
    const bool plain_small = options.disturbance.kind == DisturbanceKind::position;
    const bool disturbance = is_set(options.disturbance.size) || plain_small;
    return disturbance && options.accelerate && !options.bifurcation && !options.fallback_only && options.rtol > 1e-12;
}

namespace {

constexpr double kick = 1.0;  ///< size of p or K X to which a growing disturbance is lifted
constexpr double far = 100;   ///< of w: beyond, the reference decides

/// Along the slow mode with V = V_0 and falling, where a turn begins; an aperiodic mode has no such instant.
void lift(std::complex<double> s, Job& job)
{
    using Complex = std::complex<double>;
    const bool turns = s.imag() > 0;
    const Complex w = turns ? Complex(0, 1) : Complex(1);
    const double X = (w / s).real(), p = (-job.groups.beta * w / (s + 1.0)).real();
    const double size = kick / std::max({std::abs(w.real()), std::abs(job.groups.K * X), std::abs(p)});
    job.start[0] = size * X, job.start[1] = size * w.real(), job.start[2] = size * p;
}

}  // namespace

Job job(const Groups& g, bool search)
{
    using Complex = std::complex<double>;
    Job job{};
    job.groups = g;
    const auto roots = cubic_roots((g.c + 1) / g.M + 1, (g.K + g.c + 1 - g.beta) / g.M, g.K / g.M);
    Complex s = roots[0];
    for (const auto& root : roots)
        if (root.real() > s.real()) s = root;
    job.rate = s.real();
    job.frequency = std::abs(s.imag());
    lift({job.rate, job.frequency}, job);
    job.search = search;
    const double w = std::log(near_rest_start), p = -g.beta * w;
    job.rest_start[0] = -(w + p + g.c * std::expm1(w)) / g.K, job.rest_start[1] = w, job.rest_start[2] = p;
    return job;
}

bool state(const Disturbance& d, const Joint& joint, const Scaled& scale, Job& job)
{
    const auto& g = job.groups;
    const double A = joint.friction.normal_load * one_state(joint.friction).law->A;
    double X = 0, w = 0, p = 0;
    switch (d.kind) {
        case DisturbanceKind::position:
            X = d.size / scale.length, p = -g.K * X;
            break;
        case DisturbanceKind::velocity:
            w = std::log1p(d.size / scale.velocity), p = -g.c * std::expm1(w) - w;
            break;
        case DisturbanceKind::impulse:
            w = std::log1p(d.size / (joint.mechanism.inertia * scale.velocity));
            break;
        case DisturbanceKind::offset:
            X = d.size / scale.length;
            break;
        case DisturbanceKind::state:
            p = d.size / A;
            break;
        case DisturbanceKind::start:
            w = std::log(std::max(d.size, 1e-12)), p = -g.beta * w;
            X = -(w + p + g.c * std::expm1(w)) / g.K;
            break;
    }
    job.stated = true;
    job.start[0] = rounded(X), job.start[1] = rounded(w), job.start[2] = rounded(p);
    const bool moves = X != 0 || w != 0 || p != 0;
    return moves && std::abs(w) < far && std::isfinite(X) && std::isfinite(p);
}

bool write(const Answer& a, const Scaled& s, const Job& job, PointResult& point)
{
    point.growth_rate = job.rate * s.velocity / s.length;
    if (a.ending == Ending::left_over) return false;
    point.path = DecisionPath::lanes;
    const double per_deflection = s.length / std::abs(s.deflection);
    const double small_peak = small_disturbance / std::hypot(job.rate, job.frequency);
    point.overshoot = std::max(0.0, job.stated ? a.peak : small_peak) * per_deflection;
    point.outcome = !a.reached ? Outcome::stable_sliding : a.rest_time > 0 ? Outcome::stick_slip : Outcome::limit_cycle;
    if (a.ending == Ending::bistable) point.region = Region::bistable;
    if (a.ending == Ending::decays) return true;
    point.amplitude = 0.5 * (a.x_max - a.x_min) * s.length;
    point.velocity_min = s.velocity * std::exp(a.w_min);
    point.velocity_max = s.velocity * std::exp(a.w_max);
    point.period = a.period * s.length / s.velocity;
    point.stick_fraction = a.rest_time / a.period;
    if (a.reached) point.overshoot = std::max({0.0, a.x_max, a.peak}) * per_deflection;  // a small one has no peak
    return true;
}

namespace {

/// By groups, then by the disturbance.
template <class Job>
bool before(const Job& a, const Job& b)
{
    if (!(a.groups == b.groups)) return less(a.groups, b.groups);
    return std::lexicographical_compare(std::begin(a.start), std::end(a.start), std::begin(b.start), std::end(b.start));
}

/// Answers those joints among `open` that have such groups, each motion once; the numbers of the others stay.
template <class Scale>
void answer_those(std::optional<Scale> (*scaled)(const Joint&), std::span<const Joint> joints,
                  const NonlinearOptions& options, std::span<PointResult> points, std::vector<std::size_t>& open)
{
    using Job = typename Scale::Job;
    struct Entry {
        Scale scale;
        Job job;
        std::size_t number;
    };
    std::vector<Entry> entries;
    std::vector<std::size_t> others;
    for (const auto i : open) {
        const auto s = scaled(joints[i]);
        Entry entry;
        if (s) entry = {*s, job(s->groups, options.region), i};
        const bool stated = is_set(options.disturbance.size);
        if (s && (!stated || state(options.disturbance, joints[i], *s, entry.job)))
            entries.push_back(entry);
        else
            others.push_back(i);
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return before(a.job, b.job) || (!before(b.job, a.job) && a.number < b.number);
    });
    std::vector<Job> jobs;
    std::vector<std::size_t> job_of(entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (i == 0 || before(entries[i - 1].job, entries[i].job)) jobs.push_back(entries[i].job);
        job_of[i] = jobs.size() - 1;
    }
    std::vector<typename Scale::Answer> answers(jobs.size());
    Settings settings;
    settings.rtol = options.rtol;
    run(jobs.data(), answers.data(), jobs.size(), settings, best_instructions());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const auto& e = entries[i];
        if (!write(answers[job_of[i]], e.scale, e.job, points[e.number])) others.push_back(e.number);
    }
    open = std::move(others);
}

}  // namespace

namespace {

template <class Scale>
bool decay_of(const std::optional<Scale>& scale, PointResult& point)
{
    if (!scale) return false;
    const auto small = job(scale->groups, false);
    typename Scale::Answer answer;
    answer.ending = Ending::decays;
    return small.rate < 0 && write(answer, *scale, small, point);
}

}  // namespace

bool decay(const Joint& joint, const NonlinearOptions& options, PointResult& point)
{
    if (!covers(options) || is_set(options.disturbance.size)) return false;
    return decay_of(scaled(joint), point) || decay_of(stribeck_scaled(joint), point);
}

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
