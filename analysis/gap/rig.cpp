#include "analysis/gap/rig.h"

#include "analysis/boundary/optimise.h"
#include "analysis/gap/prepare.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stickslip::gap {
namespace {

/// What resists the slider beyond a constant level. V* is the load point's first speed.
enum class Law { level, velocity, logarithm, drift, slip, ageing, time };

struct Rival {
    Law law;
    const char *effect, *form;
    std::vector<const char*> parameters;  ///< after the spring's stiffness
};

const std::vector<Rival> rivals{
    {Law::level, "coulomb-level", "", {}},
    {Law::velocity, "viscous", "", {"slope"}},
    {Law::logarithm, "stribeck", "logarithmic", {"weakening"}},
    {Law::drift, "friction-drift", "", {"change", "time_constant"}},
    {Law::slip, "frictional-memory", "slip", {"A", "B", "L"}},
    {Law::ageing, "frictional-memory", "ageing", {"A", "B", "L"}},
    {Law::time, "frictional-memory", "time", {"A", "B", "time_constant"}},
};

struct Rig {
    std::vector<double> time, displacement, friction;
    double speed = 0;   ///< of the load point at first: V*
    double travel = 0;  ///< of the load point
    double range = 0;   ///< of the friction
};

constexpr std::size_t most_rows = 6000;

Rig rig_of(const Record& r)
{
    const auto& x = r.position.empty() ? r.reference_position : r.position;
    Rig rig;
    const std::size_t stride = std::max<std::size_t>(1, r.rows() / most_rows);
    for (std::size_t k = 0; k < r.rows(); k += stride) {
        rig.time.push_back(r.time[k] - r.time[0]);
        rig.displacement.push_back(x[k] - x[0]);
        rig.friction.push_back(r.effort_measured[k]);
    }
    const std::size_t first = std::max<std::size_t>(2, rig.time.size() / 50);
    rig.speed = std::abs(rig.displacement[first] / rig.time[first]);
    rig.travel = std::abs(rig.displacement.back());
    const auto [low, high] = std::minmax_element(rig.friction.begin(), rig.friction.end());
    rig.range = *high - *low;
    return rig;
}

/// Numbers of a rival in SI: stiffness first.
using Numbers = std::vector<double>;

/// Force less its level along the record. `held` forces rise by the stiffness until the law lets the slider go.
std::vector<double> force_of(const Rig& rig, Law law, const Numbers& p)
{
    std::vector<double> force(rig.time.size(), 0);
    const bool remembers = law == Law::slip || law == Law::ageing || law == Law::time;
    if (!remembers) {
        // without a direct effect the slider follows the load point: force = law at the load point's speed
        for (std::size_t k = 0; k < force.size(); ++k) {
            const std::size_t a = k >= 5 ? k - 5 : 0, b = std::min(k + 5, force.size() - 1);
            const double v = std::abs((rig.displacement[b] - rig.displacement[a]) / (rig.time[b] - rig.time[a]));
            const double relative = std::max(v / rig.speed, 1e-6);
            if (law == Law::velocity) force[k] = p[1] * v;
            if (law == Law::logarithm) force[k] = p[1] * std::log(relative);
            if (law == Law::drift) force[k] = p[1] * -std::expm1(-rig.time[k] / p[2]);
        }
        return force;
    }
    const double stiffness = p[0], A = p[1], B = p[2], length = p[3];
    double slip = 0, theta = 0;
    const auto rate_of = [&](double x, double s, double th, double& ds, double& dth) {
        const double exponent = std::clamp((stiffness * (x - s) - th) / A, -40.0, 40.0);
        ds = rig.speed * std::exp(exponent);
        const double steady = -B * exponent;
        if (law == Law::slip) dth = -ds / length * (th - steady);
        if (law == Law::time) dth = -(th - steady) / length;
        // (B/L)(V* e^{−θ/B} − V)
        if (law == Law::ageing) dth = B / length * (rig.speed * std::exp(std::clamp(-th / B, -40.0, 40.0)) - ds);
    };
    for (std::size_t k = 0; k + 1 < force.size(); ++k) {
        force[k] = stiffness * (std::abs(rig.displacement[k]) - slip);
        const double h = rig.time[k + 1] - rig.time[k], x0 = std::abs(rig.displacement[k]);
        const double rate = (std::abs(rig.displacement[k + 1]) - x0) / h;
        double d1, t1, d2, t2;
        rate_of(x0, slip, theta, d1, t1);
        constexpr double steps_per_time_constant = 4;
        constexpr int most = 60;
        const double fastest = std::max(d1, rate) * (stiffness / A + (law == Law::time ? 0 : 1 / length));
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
    force.back() = stiffness * (std::abs(rig.displacement.back()) - slip);
    return force;
}

/// Blocks of two seconds belong to three folds in turn; -1: no row is left out.
constexpr int folds = 3;
bool left_out(const Rig& rig, std::size_t k, int fold)
{
    return fold >= 0 && static_cast<int>(rig.time[k] / 2) % folds == fold;
}

/// Mean square of the misfit with the level refitted to the rows that are in; over those rows, or over the others.
double square_of(const Rig& rig, const std::vector<double>& force, int fold, bool outside, double* level = nullptr)
{
    double mean = 0, n = 0;
    for (std::size_t k = 0; k < force.size(); ++k)
        if (!left_out(rig, k, fold)) mean += rig.friction[k] - force[k], n += 1;
    mean /= n;
    if (level) *level = mean;
    double sum = 0, m = 0;
    for (std::size_t k = 0; k < force.size(); ++k)
        if (left_out(rig, k, fold) == outside) {
            const double e = rig.friction[k] - force[k] - mean;
            sum += e * e, m += 1;
        }
    return m > 0 ? sum / m : 0;
}

/// Units in which numbers are searched: logarithms of stiffness, A, B, L; plain otherwise.
Numbers numbers_of(const Rig& rig, Law law, const std::vector<double>& x)
{
    Numbers p{rig.range / rig.travel * std::exp(x[0])};
    const double length = law == Law::time ? rig.time.back() : rig.travel;
    switch (law) {
        case Law::level:
            break;
        case Law::velocity:
            p.push_back(rig.range / rig.speed * x[1]);
            break;
        case Law::logarithm:
            p.push_back(rig.range * x[1]);
            break;
        case Law::drift:
            p.push_back(rig.range * x[1]), p.push_back(rig.time.back() * std::exp(x[2]));
            break;
        default:
            p.push_back(rig.range * std::exp(x[1])), p.push_back(rig.range * std::exp(x[2]));
            p.push_back(length * std::exp(x[3]));
    }
    return p;
}

struct Fit {
    Numbers p;
    std::vector<double> x;
    double square = infinity;
};

Fit search(const Rig& rig, const Rival& rival, int fold, std::vector<double> from, int evaluations)
{
    Fit fit;
    if (rival.law == Law::level) {
        fit.x = from;
        fit.p = numbers_of(rig, rival.law, from);
        fit.square = square_of(rig, force_of(rig, rival.law, fit.p), fold, false);
        return fit;
    }
    constexpr double widest = 12;
    const auto all = [&](double value) { return std::vector<double>(from.size(), value); };
    Minimisation simplex{SearchMethod::simplex, {all(-widest), all(widest)}, all(0.4), evaluations};
    simplex.ftol_abs = 1e-5;
    const auto objective = [&](const std::vector<double>& x) {
        return std::log(square_of(rig, force_of(rig, rival.law, numbers_of(rig, rival.law, x)), fold, false));
    };
    from = minimum(simplex, objective, std::move(from));
    fit.x = from;
    fit.p = numbers_of(rig, rival.law, from);
    fit.square = square_of(rig, force_of(rig, rival.law, fit.p), fold, false);
    return fit;
}

Fit best_fit(const Rig& rig, const Rival& rival)
{
    std::vector<std::vector<double>> from;
    const std::size_t n = 1 + rival.parameters.size();
    if (n <= 3) {
        from.push_back(std::vector<double>(n, 0));
    } else {
        for (double stiffness : {2.0, 4.5, 7.0})
            for (double length : {-6.0, -4.0, -2.0}) from.push_back({stiffness, -1, -1, length});
    }
    Fit best;
    for (const auto& x : from) {
        constexpr int look = 60;
        const Fit one = search(rig, rival, -1, x, look);
        if (one.square < best.square) best = one;
    }
    return search(rig, rival, -1, best.x, 400);
}

}  // namespace

bool is_rig(const Record& r)
{
    return !r.effort_measured.empty() && r.effort_command.empty() && r.drive.empty() && r.current.empty() &&
           r.position.empty() != r.reference_position.empty();
}

DiagnosisResult diagnose_rig(const Joint& joint, const Record& record, const ParallelFor& parallel)
{
    DiagnosisResult result{{}, joint};
    Diagnosis& d = result.diagnosis;
    d.motion = joint.mechanism.motion;
    constexpr std::size_t fewest = 100;
    if (record.rows() < fewest) {
        d.reasons.push_back(record.name + ": " + std::to_string(record.rows()) + " rows; at least 100 are needed");
        return result;
    }
    const Rig rig = rig_of(record);
    d.records.push_back({record.name, "held-out"});
    d.notes.push_back(
        "a friction rig: a load point's displacement and the friction; the stiffness between load point "
        "and slider and the level of the friction are fitted for every law");
    d.notes.push_back("one record: blocks of two seconds are held out, a third of them in turn");
    if (rig.travel == 0 || rig.range == 0 || rig.speed == 0) {
        d.reasons.push_back(record.name + ": displacement or friction does not change");
        return result;
    }
    struct Entry {
        Fit fit;
        double held = 0;
        ConfidenceInterval gains;
        std::array<double, folds> squares{};
    };
    std::vector<Entry> entries(rivals.size());
    parallel(rivals.size(), [&](std::size_t i) {
        Entry& e = entries[i];
        e.fit = best_fit(rig, rivals[i]);
        for (int f = 0; f < folds; ++f) {
            const Fit refit = search(rig, rivals[i], f, e.fit.x, 120);
            e.squares[static_cast<std::size_t>(f)] = square_of(rig, force_of(rig, rivals[i].law, refit.p), f, true);
            e.held += e.squares[static_cast<std::size_t>(f)] / folds;
        }
    });
    std::vector<std::size_t> order(rivals.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return entries[a].held < entries[b].held; });
    const double noise = std::max(noise_of(rig.friction), 1e-12 * rig.range);
    const double before = std::sqrt(entries[0].held), after = std::sqrt(entries[order[0]].held);
    constexpr double worth = 0.1, near = 1.1, quiet = 1.06;  // gain that earns a name; RMS that cannot be told apart
    const bool gap = order[0] != 0 && after < (1 - worth) * before;
    d.verdict = before < quiet * noise ? Verdict::no_gap : gap ? Verdict::gap : Verdict::unknown;
    d.gap.push_back({"friction", std::string(unit_of(Quantity::effort, d.motion)), before, after, noise,
                     (before * before - after * after) / std::max(before * before - noise * noise, 1e-300)});
    d.overall = {before / noise, after / noise, 1, d.gap[0].explained};
    d.usual_speed = rig.speed;
    Share share{"motion", 1};
    share.rms = before, share.floor = noise, share.unit = d.gap[0].unit;
    d.signals.push_back(share);
    double sum = 0;
    constexpr double width = 0.05;  // of log RMS: rests of rigs are model error, not noise
    const auto weight = [&](std::size_t i) {
        return std::exp(-std::log(std::sqrt(entries[i].held) / std::max(after, 1e-300)) / width);
    };
    for (std::size_t i = 1; i < rivals.size(); ++i) sum += weight(i);
    for (std::size_t i : order) {
        if (i == 0 || d.verdict != Verdict::gap) continue;
        Cause c;
        c.names = {rivals[i].effect};
        c.form = rivals[i].form;
        c.probability = 0.95 * weight(i) / sum;
        const double tail = std::sqrt(entries[i].held);
        c.heldout_gain = 1 - tail / before;
        c.heldout_gain_interval = {1, -1};
        for (std::size_t f = 0; f < folds; ++f) {
            const double gain = 1 - std::sqrt(entries[i].squares[f] / entries[0].squares[f]);
            c.heldout_gain_interval.low = std::min(c.heldout_gain_interval.low, gain);
            c.heldout_gain_interval.high = std::max(c.heldout_gain_interval.high, gain);
        }
        c.misfit = std::log(tail / noise);
        c.signature = c.heldout_gain > worth;
        if (const Effect* e = effect_named(rivals[i].effect)) c.tell_tale = e->signature;
        const Numbers& p = entries[i].fit.p;
        for (std::size_t n = 0; n < rivals[i].parameters.size(); ++n)
            c.parameters.push_back({c.names[0] + "." + rivals[i].parameters[n], p[n + 1], not_set, ""});
        if (p.size() > 3) {
            c.parameters.push_back({c.names[0] + ".V_star", rig.speed, not_set, ""});
            c.parameters.push_back({"stiffness", p[0], not_set, ""});
        }
        if (!d.effects.empty() && tail < near * after) {
            d.ambiguous_with.push_back(c.names);
            if (c.names == d.effects[0].names)
                d.reasons.push_back("the law is ambiguous: " + c.names[0] + " by the " + d.effects[0].form +
                                    " law and by the " + c.form + " law leave nearly the same");
        }
        d.effects.push_back(c);
    }
    if (d.verdict == Verdict::gap) {
        d.next_experiment.description =
            "a step down to the first speed, then a hold of 100 s and a slide: the laws differ most at low speed and "
            "at rest";
        const auto& best = rivals[order[0]];
        const Numbers& p = entries[order[0]].fit.p;
        if (best.law == Law::slip || best.law == Law::ageing) {
            Memory& m = main_friction(result.after).memory;
            m.A = p[1], m.B = p[2], m.L = p[3], m.V_star = rig.speed;
            m.form = best.law == Law::ageing ? MemoryForm::ageing : MemoryForm::slip;
        }
    } else {
        d.reasons.push_back("no law that the program knows predicts the held-out blocks better than a constant level");
    }
    DiagnosedTrace trace;
    trace.file = record.name;
    double level = 0;
    const auto force = force_of(rig, rivals[order[0]].law, entries[order[0]].fit.p);
    square_of(rig, force, -1, false, &level);
    double mean = 0;
    for (double f : rig.friction) mean += f / static_cast<double>(rig.friction.size());
    for (std::size_t k = 0; k < rig.time.size(); k += 2) {
        trace.time.push_back(rig.time[k]);
        for (auto* t : {&trace.measured, &trace.before, &trace.after}) t->push_back(rig.displacement[k]);
        trace.effort_measured.push_back(rig.friction[k]);
        trace.effort_before.push_back(mean);
        trace.effort_after.push_back(level + force[k]);
    }
    d.traces.push_back(std::move(trace));
    return result;
}

}  // namespace stickslip::gap
