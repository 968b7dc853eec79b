#include "analysis/simulation/sampled/loop_record.h"

#include "analysis/numerics/reference_rate.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr double same_time = 1e-6;  ///< of a tick
constexpr double even = 1e-3;       ///< by which steps of a reference may differ and count as equal
constexpr double most_rows = 20'000'000;

/// The reference at any time: straight lines between the rows, and the rows themselves where they meet a tick.
class Told {
  public:
    Told(const ReferenceMotion& reference, double tick) : r_(reference), near_(same_time * tick) {}

    struct Now {
        double position, velocity, feed_forward;
    };
    Now at(double t)
    {
        while (i_ + 2 < r_.time.size() && t >= r_.time[i_ + 1] - near_) ++i_;
        const double span = r_.time[i_ + 1] - r_.time[i_];
        double part = std::clamp((t - r_.time[i_]) / span, 0.0, 1.0);
        if (std::abs(part * span) < near_) part = 0;
        if (std::abs((1 - part) * span) < near_) part = 1;
        const auto between = [&](const std::vector<double>& column) {
            return part == 0   ? column[i_]
                   : part == 1 ? column[i_ + 1]
                               : column[i_] + part * (column[i_ + 1] - column[i_]);
        };
        return {between(r_.position), r_.velocity.empty() ? 0 : between(r_.velocity),
                r_.feed_forward.empty() ? 0 : between(r_.feed_forward)};
    }

  private:
    const ReferenceMotion& r_;
    double near_;
    std::size_t i_ = 0;
};

/// What is told at each of these ticks; a velocity that the reference does not state is that of its positions there.
std::vector<Told::Now> told_at(const ReferenceMotion& reference, double tick, long ticks)
{
    Told told(reference, tick);
    std::vector<Told::Now> all;
    std::vector<double> time, position;
    for (long k = 0; k <= ticks; ++k) {
        time.push_back(reference.time.front() + static_cast<double>(k) * tick);
        all.push_back(told.at(time.back()));
        position.push_back(all.back().position);
    }
    if (!reference.velocity.empty()) return all;
    const auto rates = reference_rates(time, position, jumps_of(position));
    for (std::size_t k = 0; k < all.size(); ++k) all[k].velocity = rates[k];
    return all;
}

LoopRecord refused(Reason reason, Detail why)
{
    LoopRecord record;
    record.reason = reason, record.why = why;
    return record;
}

double fastest_of(const ReferenceMotion& r)
{
    double fastest = 0;
    for (std::size_t i = 1; i < r.time.size(); ++i)
        fastest = std::max(fastest, std::abs((r.position[i] - r.position[i - 1]) / (r.time[i] - r.time[i - 1])));
    return fastest;
}

/// The ticks of a continuous loop divide the rows of the reference: so many a row, 0 where rows are not even.
int ticks_a_row(const Joint& joint, const ReferenceMotion& r)
{
    const double row = (r.time.back() - r.time.front()) / static_cast<double>(r.time.size() - 1);
    for (std::size_t i = 1; i < r.time.size(); ++i)
        if (std::abs(r.time[i] - r.time[i - 1] - row) > even * row) return 0;
    constexpr double least = 4;  // what drives the joint is that of the middle of a tick, what is logged that of a row
    return static_cast<int>(std::max(least, std::ceil(row / tick_of(joint))));
}

bool needs_motion(const Joint& joint)
{
    const Chain chain = chain_of(joint);
    for (int i = 0; i < chain.bodies; ++i)
        if (info(chain.body[i].friction->law).needs_motion) return true;
    return false;
}

/// Why the joint does not start along the reference; `Reason::none` with the loop at its start.
LoopRecord started(const Joint& joint, const ReferenceMotion& reference, const Told::Now& start, SampledLoop& loop)
{
    const bool slides = needs_motion(joint);
    if (slides && !(start.velocity > 0)) return refused(Reason::law_needs_motion, Detail::law_at_rest);
    if (!slides)
        loop.begin_at_rest(start.position);
    else if (!loop.begin_sliding(start.position, start.velocity))
        return refused(Reason::no_steady_state, Detail::effort_limit);
    loop.motion.joint.began = reference.time.front();
    loop.set_clock(reference.time.front(), reference.time.front() - joint.sensor.delay);
    return {};
}

/// Tick by tick; of a continuous loop each so many ticks are a row. A measured effort comes `ticks_late` after its row.
void log_along(const ReferenceMotion& reference, const std::vector<Told::Now>& told, SampledLoop& loop, int each,
               LoopRecord& record)
{
    const double T = loop.period();
    const long ticks = static_cast<long>(told.size()) - 1, delayed = loop.ticks_late();
    for (long k = 0; k <= ticks + delayed; ++k) {
        const double t = reference.time.front() + static_cast<double>(k) * T;
        const auto& now = told[static_cast<std::size_t>(std::min(k, ticks))];
        const bool moved = loop.tick(now.position, now.velocity, now.feed_forward, [](const DrivenStep&) {});
        const auto& r = loop.readings();
        if (k >= delayed && (k - delayed) % each == 0) record.effort_measured.push_back(r.effort);
        if (k <= ticks && k % each == 0) {
            record.time.push_back(t);
            record.reference_position.push_back(now.position);
            record.reference_velocity.push_back(now.velocity);
            record.position.push_back(r.position);
            record.velocity.push_back(r.velocity);
            record.effort_command.push_back(r.command);
            if (!reference.feed_forward.empty()) record.feed_forward.push_back(now.feed_forward);
        }
        if (!moved) {
            record.reason = Reason::solver_failed;
            record.why = Detail::stopped;
            break;
        }
        if (loop.motion.joint.driven_backwards(loop.motion.y.data())) {
            record.reason = Reason::law_needs_motion;
            record.why = Detail::law_at_rest;
            break;
        }
    }
    const std::size_t rows = record.effort_measured.size();
    for (auto* column : {&record.time, &record.reference_position, &record.reference_velocity, &record.position,
                         &record.velocity, &record.effort_command})
        column->resize(rows);
    if (!reference.feed_forward.empty()) record.feed_forward.resize(rows);
}

}  // namespace

LoopRecord record_along(const Joint& joint, const ReferenceMotion& reference, std::uint64_t seed, double rtol)
{
    if (const auto why = why_not_driven(joint); why != Detail::none) return refused(Reason::unsupported, why);
    if (reference.time.size() < 2) return refused(Reason::unsupported, Detail::few_rows);
    const double span = reference.time.back() - reference.time.front();
    LoopOptions options;
    options.seed = seed;
    options.motion.rtol = rtol;
    int each = 1;
    if (!is_set(joint.control.period)) {
        each = ticks_a_row(joint, reference);
        if (each == 0) return refused(Reason::unsupported, Detail::uneven_rows);
        options.tick = span / static_cast<double>(reference.time.size() - 1) / each;
    }
    const double fastest = fastest_of(reference), V0 = joint.control.V0;
    const double speed = fastest > 0 ? fastest : is_set(V0) && V0 != 0 ? std::abs(V0) : 1e-3;
    SampledLoop loop(joint, 0, speed / joint.sensor.position_scale, LoopSide::motor, options);
    if (span / loop.period() > most_rows) return refused(Reason::unsupported, Detail::too_many_ticks);
    const auto told = told_at(reference, loop.period(), std::lround(std::floor(span / loop.period() + same_time)));
    LoopRecord record = started(joint, reference, told.front(), loop);
    if (record.reason == Reason::none) log_along(reference, told, loop, each, record);
    return record;
}

}  // namespace stickslip
