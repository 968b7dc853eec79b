#include "analysis/diagnosis/rig/rig_laws.h"

#include "analysis/diagnosis/policy/outcomes_and_rigs.h"
#include "analysis/friction/memory_step.h"
#include "analysis/joint/joint.h"
#include "analysis/numerics/optimise.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

/// Rows between which the speed at row k is taken: five of its own steps to both sides, across no slower rows.
std::pair<std::size_t, std::size_t> around(const std::vector<double>& time, std::size_t k)
{
    const std::size_t last = time.size() - 1;
    const double before = k > 0 ? time[k] - time[k - 1] : infinity, after = k < last ? time[k + 1] - time[k] : infinity;
    const double reach = 5.5 * std::min(before, after);
    std::size_t a = k, b = k;
    while (a > 0 && time[k] - time[a - 1] <= reach) --a;
    while (b < last && time[b + 1] - time[k] <= reach) ++b;
    return {a, b};
}

bool has_memory(RigLaw law)
{
    return law == RigLaw::slip || law == RigLaw::ageing || law == RigLaw::time;
}

/// -1: no row is left out.
bool left_out(std::size_t k, int fold)
{
    constexpr std::size_t block = policy::rows_of_rig_block;
    return fold >= 0 && static_cast<int>(k / block % rig_folds) == fold;
}

}  // namespace

const std::vector<RigRival>& rig_rivals()
{
    constexpr RigParameter a{"A", Quantity::effort}, b{"B", Quantity::effort};
    static const std::vector<RigRival> all{
        {RigLaw::level, "coulomb-level", "", {}},
        {RigLaw::velocity, "viscous", "", {{"slope", Quantity::damping}}},
        {RigLaw::logarithm, "stribeck", "logarithmic", {{"per_logarithm", Quantity::effort}}},
        {RigLaw::load, "load-dependent-friction", "", {{"coefficient", Quantity::number}}},
        {RigLaw::drift, "friction-drift", "", {{"change", Quantity::effort}, {"time_constant", Quantity::time}}},
        {RigLaw::slip, "frictional-memory", "slip", {a, b, {"L", Quantity::position}}},
        {RigLaw::ageing, "frictional-memory", "ageing", {a, b, {"L", Quantity::position}}},
        {RigLaw::time, "frictional-memory", "time", {a, b, {"time_constant", Quantity::time}}},
    };
    return all;
}

namespace {

/// Without a direct effect the slider follows the load point: force = law at the load point's speed.
std::vector<double> following_force(const Rig& rig, const RigRun& run, RigLaw law, const RigNumbers& p)
{
    constexpr double least = 1e-6;  // numerical: of V*
    std::vector<double> force(run.time.size(), 0);
    const double load = rig.runs.front().normal.empty() ? 0 : rig.runs.front().normal.front();
    for (std::size_t k = 0; k < force.size(); ++k) {
        const auto [a, b] = around(run.time, k);
        const double v = std::abs((run.displacement[b] - run.displacement[a]) / (run.time[b] - run.time[a]));
        const double relative = std::max(v / rig.speed, least);
        if (law == RigLaw::velocity) force[k] = p[1] * v;
        if (law == RigLaw::logarithm) force[k] = p[1] * std::log(relative);
        if (law == RigLaw::load && !run.normal.empty()) force[k] = p[1] * (run.normal[k] - load);
        if (law == RigLaw::drift) force[k] = p[1] * -std::expm1(-run.time[k] / p[2]);
    }
    return force;
}

/// A state that remembers, by the midpoint rule. It begins in steady sliding at the run's first speed.
std::vector<double> remembering_force(const Rig& rig, const RigRun& run, RigLaw law, const RigNumbers& p)
{
    std::vector<double> force(run.time.size(), 0);
    const double stiffness = p[0], A = p[1], B = p[2], length = p[3];
    // a run that begins at rest has no steady sliding to begin from
    const double start = std::log(std::max(run.start_speed / rig.speed, memory_floor));
    double theta = -B * start, slip = -(A - B) * start / stiffness;
    const auto rate_of = [&](double x, double s, double th, double& ds, double& dth) {
        const double exponent = std::clamp((stiffness * (x - s) - th) / A, -40.0, 40.0);
        ds = rig.speed * std::exp(exponent);
        const double steady = -B * exponent;
        if (law == RigLaw::slip) dth = -ds / length * (th - steady);
        if (law == RigLaw::time) dth = -(th - steady) / length;
        // (B/L)(V* e^{−θ/B} − V)
        if (law == RigLaw::ageing) dth = B / length * (rig.speed * std::exp(std::clamp(-th / B, -40.0, 40.0)) - ds);
    };
    for (std::size_t k = 0; k + 1 < force.size(); ++k) {
        force[k] = stiffness * (std::abs(run.displacement[k]) - slip);
        const double h = run.time[k + 1] - run.time[k], x0 = std::abs(run.displacement[k]);
        const double rate = (std::abs(run.displacement[k + 1]) - x0) / h;
        double d1, t1, d2, t2;
        rate_of(x0, slip, theta, d1, t1);
        constexpr double steps_per_time_constant = 4;  // numerical: of the integration
        constexpr int most = 60;
        const double fastest = std::max(d1, rate) * (stiffness / A + (law == RigLaw::time ? 0 : 1 / length));
        const int parts = std::clamp(static_cast<int>(std::ceil(steps_per_time_constant * fastest * h)), 1, most);
        const double dt = h / parts;
        for (int i = 0; i < parts; ++i) {
            const double x = x0 + rate * dt * i;
            rate_of(x, slip, theta, d1, t1);
            rate_of(x + 0.5 * rate * dt, slip + 0.5 * dt * d1, theta + 0.5 * dt * t1, d2, t2);
            slip += dt * d2, theta += dt * t2;
            if (!std::isfinite(slip) || !std::isfinite(theta)) return std::vector<double>(force.size(), 1e6);
        }
    }
    force.back() = stiffness * (std::abs(run.displacement.back()) - slip);
    return force;
}

}  // namespace

std::vector<std::vector<double>> rig_force(const Rig& rig, RigLaw law, const RigNumbers& p)
{
    std::vector<std::vector<double>> forces;
    for (const auto& run : rig.runs)
        forces.push_back(has_memory(law) ? remembering_force(rig, run, law, p) : following_force(rig, run, law, p));
    return forces;
}

double rig_square(const Rig& rig, const std::vector<std::vector<double>>& force, int fold, bool outside,
                  std::vector<double>* levels)
{
    std::vector<double> mean(rig.levels), n(rig.levels);
    for (std::size_t r = 0; r < rig.runs.size(); ++r)
        for (std::size_t k = 0; k < force[r].size(); ++k)
            if (!left_out(k, fold))
                mean[rig.runs[r].level] += rig.runs[r].friction[k] - force[r][k], n[rig.runs[r].level] += 1;
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] /= n[i];
    double sum = 0, m = 0;
    for (std::size_t r = 0; r < rig.runs.size(); ++r)
        for (std::size_t k = 0; k < force[r].size(); ++k)
            if (left_out(k, fold) == outside) {
                const double e = rig.runs[r].friction[k] - force[r][k] - mean[rig.runs[r].level];
                sum += e * e, m += 1;
            }
    if (levels) *levels = std::move(mean);
    return m > 0 ? sum / m : 0;
}

namespace {

/// Units in which numbers are searched: logarithms of stiffness, A, L; plain otherwise.
RigNumbers numbers_of(const Rig& rig, RigLaw law, const std::vector<double>& x)
{
    RigNumbers p{rig.range / rig.travel * std::exp(x[0])};
    const double length = law == RigLaw::time ? rig.duration : rig.travel;
    switch (law) {
        case RigLaw::level:
            break;
        case RigLaw::velocity:
            p.push_back(rig.range / rig.speed * x[1]);
            break;
        case RigLaw::logarithm:
            p.push_back(rig.range * x[1]);
            break;
        case RigLaw::load:
            p.push_back(x[1]);
            break;
        case RigLaw::drift:
            p.push_back(rig.range * x[1]), p.push_back(rig.duration * std::exp(x[2]));
            break;
        default:
            // gouges strengthen with velocity: B has either sign
            p.push_back(rig.range * std::exp(x[1])), p.push_back(rig.range * x[2]);
            p.push_back(length * std::exp(x[3]));
    }
    return p;
}

RigFit search(const Rig& rig, const RigRival& rival, int fold, std::vector<double> from, int evaluations)
{
    RigFit fit;
    if (rival.law == RigLaw::level) {
        fit.x = from;
        fit.p = numbers_of(rig, rival.law, from);
        fit.square = rig_square(rig, rig_force(rig, rival.law, fit.p), fold, false);
        return fit;
    }
    constexpr double widest = 12;  // numerical: logarithms of the search
    const auto all = [&](double value) { return std::vector<double>(from.size(), value); };
    auto most = all(widest);
    // a memory longer than a part of the travel would never have been seen to fade
    if (has_memory(rival.law)) most[3] = std::log(policy::longest_memory_of_rig);
    Minimisation simplex{SearchMethod::simplex, {all(-widest), most}, all(0.4), evaluations};
    simplex.ftol_abs = 1e-5;
    const auto objective = [&](const std::vector<double>& x) {
        return std::log(rig_square(rig, rig_force(rig, rival.law, numbers_of(rig, rival.law, x)), fold, false));
    };
    from = minimum(simplex, objective, std::move(from));
    fit.x = from;
    fit.p = numbers_of(rig, rival.law, from);
    fit.square = rig_square(rig, rig_force(rig, rival.law, fit.p), fold, false);
    return fit;
}

}  // namespace

RigFit fit_rig(const Rig& rig, const RigRival& rival)
{
    std::vector<std::vector<double>> from;
    const std::size_t n = 1 + rival.parameters.size();
    if (n <= 3) {
        from.push_back(std::vector<double>(n, 0));
    } else {
        for (double stiffness : {2.0, 4.5, 7.0})
            for (double length : {-6.0, -4.0, -2.0})
                for (double B : {0.4, -0.4}) from.push_back({stiffness, -1, B, length});
    }
    RigFit best;
    best.square = infinity;
    for (const auto& x : from) {
        constexpr int look = 60;
        const RigFit one = search(rig, rival, -1, x, look);
        if (one.square < best.square) best = one;
    }
    return search(rig, rival, -1, best.x, 400);
}

RigFit refit_rig(const Rig& rig, const RigRival& rival, int fold, const RigFit& from)
{
    constexpr int evaluations = 120;
    return search(rig, rival, fold, from.x, evaluations);
}

}  // namespace stickslip::gap
