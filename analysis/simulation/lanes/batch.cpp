#include "analysis/simulation/lanes/batch.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <vector>

#include "analysis/simulation/mode.h"
#include "analysis/stability/polynomial.h"
#include "analysis/stability/steady.h"

namespace stickslip::lanes {
namespace {

constexpr double finest = 1e-5;      ///< share of rtol where growth is too small to be measured anyway
constexpr double slow_start = 1e-4;  ///< as in the reference: the share of V_0 from which V_0 is commanded

double rounded(double value)
{
    const auto bits = std::bit_cast<std::uint64_t>(value);
    constexpr std::uint64_t lost = 8;  // of 52
    return std::bit_cast<double>((bits + (std::uint64_t{1} << (lost - 1))) >> lost << lost);
}

bool plain(const Friction& f, const Load& l)
{
    return f.asymmetry.coulomb == 0 && f.asymmetry.viscous == 0 && f.load_coefficient == 0 && f.ripple.amplitude == 0 &&
           f.drift.change == 0 && f.bristle.stiffness == 0 && f.memory.A == 0 && f.memory.B == 0 && f.memory.lag == 0 &&
           l.gravity_amplitude == 0 && l.cogging.amplitude == 0 && l.disturbance.amplitude == 0;
}

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
    const bool single = joint.mechanism.model == Model::single_mass && joint.control.contact_stiffness == 0 &&
                        joint.control.force_gain == 0;
    if (!law || law->B.size != 1 || !single || !plain(joint.friction, joint.load)) return {};
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
    job.window = std::min(2 * std::numbers::pi / std::abs(s.imag()), std::log(3.0) / std::abs(s.real()));
    job.fineness = std::clamp(clear_change * std::abs(s.real()) * job.window, finest, 1.0);
    const double X = probe / job.magnitude;
    job.start[0] = X, job.start[1] = 0, job.start[2] = -g.K * X;
    job.search = search;
    const double w = std::log(slow_start), p = -g.beta * w;
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
    point.overshoot = std::max(0.0, a.x_max) * s.length / std::abs(s.deflection);
    return true;
}

void answer(std::span<const Joint> joints, const NonlinearOptions& options, std::span<PointResult> points,
            std::vector<std::size_t>& left_over)
{
    struct Entry {
        Scaled scale;
        std::size_t number;
    };
    std::vector<Entry> entries;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const auto s = covers(options) ? scaled(joints[i]) : std::nullopt;
        if (s)
            entries.push_back({*s, i});
        else
            left_over.push_back(i);
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return a.scale.groups == b.scale.groups ? a.number < b.number : less(a.scale.groups, b.scale.groups);
    });
    std::vector<Job> jobs;
    std::vector<std::size_t> job_of(entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (i == 0 || !(entries[i].scale.groups == entries[i - 1].scale.groups))
            jobs.push_back(job(entries[i].scale.groups, options.region));
        job_of[i] = jobs.size() - 1;
    }
    std::vector<Answer> answers(jobs.size());
    Settings settings;
    settings.rtol = options.rtol;
    run(jobs.data(), answers.data(), jobs.size(), settings, best_instructions());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const auto& e = entries[i];
        if (!write(answers[job_of[i]], e.scale, jobs[job_of[i]], options.region, points[e.number]))
            left_over.push_back(e.number);
    }
    std::sort(left_over.begin(), left_over.end());
}

}  // namespace stickslip::lanes
