#include "analysis/diagnosis/audit/stretches.h"

#include "analysis/diagnosis/plant/simulator.h"
#include "analysis/diagnosis/policy/audit.h"
#include "analysis/diagnosis/policy/records.h"
#include "analysis/diagnosis/records/part_of.h"
#include "analysis/diagnosis/records/pieces.h"
#include "analysis/numerics/statistics.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

/// What happens at a tick, in classes: a table of counts has one entry a class.
constexpr std::size_t speeds = 5, places = 3, efforts = 8, accelerations = 3, errors = 5, thirds = 3;
constexpr std::size_t classes = speeds * places + efforts + accelerations + errors + thirds + 1;
using Counts = std::array<double, classes>;

/// What is usual in all records, by which ticks are put in classes.
struct Usual {
    double speed = 0, effort = 0, acceleration = 0;
    double low = infinity, high = -infinity;  ///< of the positions
    std::array<double, errors - 1> error{};   ///< quantiles of the squared prediction error
};
constexpr std::array<double, errors - 1> quantiles{0.5, 0.9, 0.99, 0.999};  // numerical: classes

/// A record's motion as the nominal joint predicts it.
struct Predicted {
    Innovation at;
    double acceleration(const Ticks& t, std::size_t k) const
    {
        constexpr double reach = 0.01;  // numerical: s
        const auto n = std::max<std::size_t>(1, static_cast<std::size_t>(reach / t.step[k]));
        const std::size_t a = k < n ? 0 : k - n, b = std::min(k + n, t.size() - 1);
        return (at.velocity[b] - at.velocity[a]) / std::max(t.time[b] - t.time[a], 1e-12);
    }
};

Predicted predicted(const Case& c)
{
    Predicted p;
    const Plant plant = flatten(c.joint);
    predict(plant, c.ticks, known_command(plant, c.ticks), levels[1], p.at);
    return p;
}

/// Every so many ticks are enough to say what is usual.
constexpr std::size_t samples = 200'000;

Usual usual_of(const std::vector<Case>& records, const std::vector<Predicted>& motion)
{
    std::size_t ticks = 0;
    for (const auto& c : records) ticks += c.ticks.size();
    const std::size_t stride = std::max<std::size_t>(1, ticks / samples);
    std::vector<double> speed, effort, acceleration, error;
    Usual usual;
    for (std::size_t r = 0; r < records.size(); ++r) {
        const Ticks& t = records[r].ticks;
        for (std::size_t k = 0; k < t.size(); k += stride) {
            const auto add = [](std::vector<double>& to, double x) {
                if (std::isfinite(x)) to.push_back(std::abs(x));
            };
            add(speed, motion[r].at.velocity[k]), add(effort, motion[r].at.predicted_effort[k]);
            add(acceleration, motion[r].acceleration(t, k));
            if (t.logged[k]) add(error, motion[r].at.position[k]);
            usual.low = std::min(usual.low, t.position[k]), usual.high = std::max(usual.high, t.position[k]);
        }
    }
    constexpr double most = 0.95;  // numerical: quantile of classes
    usual.speed = percentile(speed, most), usual.effort = percentile(effort, most);
    usual.acceleration = percentile(acceleration, most);
    for (std::size_t i = 0; i < quantiles.size(); ++i) usual.error[i] = percentile(error, quantiles[i]);
    return usual;
}

std::size_t class_of_speed(double v, double usual)
{
    const double size = std::abs(v);
    if (!(size > policy::standing * usual)) return 0;
    return (size > policy::slow * usual ? 3 : 1) + (v > 0 ? 1 : 0);
}

/// Counts what happens in the ticks [from, to).
Counts counted(const Ticks& t, const Predicted& motion, const Usual& usual, std::size_t from, std::size_t to)
{
    Counts counts{};
    const double travel = std::max(usual.high - usual.low, 1e-300);
    bool was_forward = false, has_moved = false;
    for (std::size_t k = from; k < to; ++k) {
        const double v = motion.at.velocity[k], e = motion.at.predicted_effort[k];
        const std::size_t speed = class_of_speed(v, usual.speed);
        const double place = (t.position[k] - usual.low) / travel;
        std::size_t begin = 0;
        counts[speed * places + std::min(places - 1, static_cast<std::size_t>(places * place))] += 1;
        begin += speeds * places;
        const double size = std::abs(e) / std::max(usual.effort, 1e-300);
        const auto third = static_cast<std::size_t>(std::clamp(3 * size, 0.0, 3.0));
        if (std::isfinite(e)) counts[begin + 2 * third + (e > 0 ? 1 : 0)] += 1;
        begin += efforts;
        const double a = motion.acceleration(t, k);
        counts[begin + (std::abs(a) > usual.acceleration ? (a > 0 ? 2 : 1) : 0)] += 1;
        begin += accelerations;
        if (t.logged[k]) {
            const double error = std::abs(motion.at.position[k]);
            const auto above = std::ranges::count_if(usual.error, [&](double q) { return !(error <= q); });
            counts[begin + static_cast<std::size_t>(above)] += 1;
        }
        begin += errors;
        counts[begin + std::min(thirds - 1, thirds * k / t.size())] += 1;
        begin += thirds;
        if (speed == 0) continue;
        counts[begin] += has_moved && was_forward != (v > 0);
        was_forward = v > 0, has_moved = true;
    }
    return counts;
}

/// What a choice covers: the sum of the roots of its parts of each class. What is rare counts much, the more of the
/// same the less, so that a greedy choice is near the best one (Nemhauser, Wolsey & Fisher 1978; Lin & Bilmes 2011).
double covered(const Counts& counts, const Counts& all)
{
    double sum = 0;
    for (std::size_t i = 0; i < classes; ++i) sum += all[i] > 0 ? std::sqrt(counts[i] / all[i]) : 0;
    return sum;
}

void add(Counts& to, const Counts& counts)
{
    for (std::size_t i = 0; i < classes; ++i) to[i] += counts[i];
}

/// From the readings on both sides: over a few rows of a fast log it would be their noise.
double velocity_about(const Ticks& t, std::size_t k)
{
    constexpr double reach = 0.01;  // numerical: s
    std::size_t a = k, b = k;
    while (a > 0 && t.time[k] - t.time[a] < reach) --a;
    while (b + 1 < t.size() && t.time[b] - t.time[k] < reach) ++b;
    return b > a ? (t.position[b] - t.position[a]) / (t.time[b] - t.time[a]) : 0;
}

struct Offered {
    StretchOf where;
    Counts counts;
    bool taken = false;
};

/// All records in stretches of about this length, each with what it covers.
std::vector<Offered> offered(const std::vector<Case>& records, std::size_t length)
{
    std::vector<Predicted> motion;
    for (const auto& c : records) motion.push_back(predicted(c));
    const Usual usual = usual_of(records, motion);
    std::vector<Offered> all;
    for (std::size_t r = 0; r < records.size(); ++r) {
        const Ticks& t = records[r].ticks;
        const auto m = static_cast<std::size_t>(t.ticks_per_row);
        const std::size_t rows = (t.size() + m - 1) / m;
        const std::size_t count = std::max<std::size_t>(1, (t.size() + length / 2) / length);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t from = rows * i / count * m;
            const std::size_t to = i + 1 == count ? t.size() : rows * (i + 1) / count * m;
            all.push_back({{r, from, to}, counted(t, motion[r], usual, from, to)});
        }
    }
    return all;
}

}  // namespace

std::vector<StretchOf> stretches_of(const std::vector<Case>& records)
{
    double ticks = 0, period = infinity;
    for (const auto& c : records) {
        ticks += static_cast<double>(c.ticks.size());
        period = std::min(period, c.ticks.duration() / static_cast<double>(c.ticks.size()));
    }
    if (ticks <= policy::most_whole) return {};
    const double length = std::max(policy::fitted / policy::stretches_fitted, policy::shortest_stretch / period);
    auto all = offered(records, static_cast<std::size_t>(length));
    Counts counts{}, everything{};
    for (const auto& o : all) add(everything, o.counts);
    double taken = 0;
    std::vector<char> has(records.size(), 0);
    std::size_t without = records.size();  // records of which nothing is taken
    while (taken < policy::fitted || without > 0) {
        Offered* best = nullptr;
        double most = -1;
        for (auto& o : all) {
            if (o.taken || (has[o.where.record] && taken >= policy::fitted)) continue;
            Counts with = counts;
            add(with, o.counts);
            if (const double all_with = covered(with, everything); all_with > most) most = all_with, best = &o;
        }
        if (!best) break;
        best->taken = true;
        add(counts, best->counts);
        taken += static_cast<double>(best->where.to - best->where.from);
        if (!has[best->where.record]) has[best->where.record] = 1, --without;
    }
    std::vector<StretchOf> chosen;
    for (const auto& o : all)
        if (o.taken) chosen.push_back(o.where);
    return chosen;
}

Case part_of(const Case& record, std::size_t from, std::size_t to)
{
    Case c = record;
    c.ticks = part_of(record.ticks, from, to);
    const auto& logged = record.ticks.logged;
    const auto row = [&](std::size_t tick) {
        return std::count(logged.begin(), logged.begin() + static_cast<std::ptrdiff_t>(tick), 1);
    };
    if (const auto& error = record.controller_error; !error.empty())
        c.controller_error = {error.begin() + row(from), error.begin() + row(to)};
    if (const auto& warm = record.temperature; !warm.empty())
        c.temperature = {warm.begin() + static_cast<std::ptrdiff_t>(from),
                         warm.begin() + static_cast<std::ptrdiff_t>(to)};
    if (from == 0) return c;
    c.ticks.name = name_of_part(record.ticks.name, c.ticks.time.front());
    if (const auto integral = integral_of(record.joint, record.ticks); !integral.empty())
        c.ticks.initial_integral = integral[from];
    c.ticks.at_rest = false;
    c.ticks.initial_velocity = velocity_about(record.ticks, from);
    return c;
}

}  // namespace stickslip::gap
