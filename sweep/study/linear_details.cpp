#include "sweep/study/linear_details.h"

#include "analysis/stability/real_response.h"
#include "analysis/stability/steady.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip {
namespace {

/// The least k_v at the joint's own k_p over its searched velocities, by both theories, at one set of samples so that
/// both can be read at one velocity.
void add_demands(LinearDetails& d, Joint joint)
{
    const double own = d.velocity;
    joint.control.force_rate = not_set;
    const auto least = [&](double V, Theory theory) {
        joint.control.V0 = std::copysign(V, own);
        const auto gains = stable_velocity_gains(joint, theory);
        return gains && !gains->empty() ? gains->front().low : missing;
    };
    const auto simple_at = [&](double V) { return least(V, Theory::velocity_only); };
    const auto memory_at = [&](double V) { return least(V, Theory::state_variable); };
    Samples &simple = d.demanded_simple, &memory = d.demanded_memory;
    const auto [slowest, fastest] = searched_speeds(d.study);
    for (const double V : log_steps(slowest, fastest, d.sampled_finely ? 121 : 25)) {
        simple.x.push_back(V), simple.y.push_back(simple_at(V));
        memory.x.push_back(V), memory.y.push_back(memory_at(V));
    }
    if (!d.sampled_finely) return;
    smooth(simple, simple_at);
    memory = {simple.x, {}};
    for (const double V : memory.x) memory.y.push_back(memory_at(V));
    smooth(memory, memory_at);
    simple = {memory.x, {}};
    for (const double V : simple.x) simple.y.push_back(simple_at(V));
}

/// Velocity gains worth a line: the joint's own, and parts and multiples of what the velocity-only model requires here.
std::vector<double> shown_gains(const Joint& joint, const LinearStudy& study)
{
    const double asked = study.comparison.k_v_demanded_velocity_only();
    const double own = joint.control.k_v, unit = asked > 0 ? asked : std::abs(own);
    std::vector<double> gains{own};
    for (const double k_v : {unit / 2, unit, 2 * unit})
        if (std::abs(k_v - own) > 1e-3 * unit) gains.push_back(k_v);
    return gains;
}

void add_least_velocities(LinearDetails& d, const Joint& given)
{
    const int gains = d.sampled_finely ? 61 : 31, scan = d.sampled_finely ? 60 : 20;
    const double low = d.study.velocities.low, high = d.study.velocities.high;
    Joint joint = given;
    const auto least = [&](double k_p, int steps) {
        joint.control.k_p = k_p;
        return std::abs(stable_velocities(joint, low, high, Theory::state_variable, steps).all_above);
    };
    if (!(given.control.k_p > 0)) return;
    for (const double k_v : shown_gains(given, d.study)) {
        joint.control.k_v = k_v;
        LeastVelocities line{k_v, {log_steps(given.control.k_p / 30, given.control.k_p * 30, gains), {}}};
        for (const double k : line.over_k_p.x) line.over_k_p.y.push_back(least(k, scan));
        if (d.sampled_finely)
            smooth(
                line.over_k_p, [&](double k) { return least(k, scan); }, 0.25, 5);
        line.here = least(given.control.k_p, 2 * scan);
        d.least_velocities.push_back(std::move(line));
    }
}

void add_responses(LinearDetails& d, const Joint& joint)
{
    const auto memory = LoopResponse::of(joint, Theory::state_variable);
    const auto simple = LoopResponse::of(joint, Theory::velocity_only);
    if (!memory || !simple) return;
    double low = infinity, high = 0;
    for (const auto& s : memory->roots())
        if (std::abs(s) > 0) low = std::min(low, std::abs(s)), high = std::max(high, std::abs(s));
    // ticks see nothing above half their rate
    const double highest = memory->period() > 0 ? std::numbers::pi / memory->period() : infinity;
    high = std::min(high, highest / 3);
    low = std::min(low, high);
    for (const double omega : log_steps(low / 30, high * 3, 801)) {
        d.response_memory.x.push_back(omega), d.response_simple.x.push_back(omega);
        d.response_memory.y.push_back(std::abs(memory->at(omega)));
        d.response_simple.y.push_back(std::abs(simple->at(omega)));
    }
}

void add_ramps(LinearDetails& d, const Joint& joint)
{
    d.ramp_rate = std::abs((joint.control.k_p + joint.control.contact_stiffness) * d.velocity);
    const double k_low = joint.control.k_p / 1e3, k_high = joint.control.k_p * 1e3;
    auto& ramps = d.ramps.emplace();
    for (const auto theory : {Theory::state_variable, Theory::velocity_only}) {
        auto& springs = ramps[theory == Theory::velocity_only];
        for (const double r : log_steps(d.ramp_rate / 100, d.ramp_rate * 100, d.sampled_finely ? 61 : 13)) {
            double above = missing, below = missing;
            for (const auto& i : stable_springs(joint, std::copysign(r, d.velocity), k_low, k_high, theory)) {
                if (i.low > k_low && std::isnan(above)) above = i.low;
                if (i.high < k_high) below = i.high;
            }
            springs.above.x.push_back(r), springs.above.y.push_back(above);
            springs.below.x.push_back(r), springs.below.y.push_back(below);
        }
        springs.here = stable_springs(joint, std::copysign(d.ramp_rate, d.velocity), k_low, k_high, theory);
    }
}

}  // namespace

LinearDetails linear_details(const Joint& joint, LinearStudy study)
{
    LinearDetails d;
    d.study = std::move(study);
    if (std::isnan(d.study.compliance)) return d;
    d.velocity = commanded_velocity(joint);
    // dead time and delayed friction leave roots without end, and each point costs a search
    d.sampled_finely = linear_joint(joint, d.velocity).rational() && loop_kind(joint) != LoopKind::continuous;
    if (!std::isnan(d.study.velocities.low)) {
        add_demands(d, joint);
        add_least_velocities(d, joint);
    }
    add_responses(d, joint);
    if (d.study.ramp) add_ramps(d, joint);
    return d;
}

}  // namespace stickslip
