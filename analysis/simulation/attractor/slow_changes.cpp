#include "analysis/simulation/attractor/slow_changes.h"

#include "analysis/friction/level.h"
#include "analysis/simulation/sampled/loop_verdict.h"
#include "analysis/simulation/sampled/unsteady_terms.h"
#include "analysis/stability/linear_joint.h"
#include "analysis/stability/steady.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <tuple>

namespace stickslip {
namespace {

constexpr double turn = 2 * std::numbers::pi;
/// Turns of the joint, or of its cycle, within which a change that is held may not repeat: in one of them it then
/// moves by 6 % of its amplitude at most.
constexpr double turns_of_slow_change = 100;
constexpr double rounding = 1e-12;
/// Of the effort, behind a place that took it all: the others are like it, and only one that cycles changes the answer.
constexpr double effort_behind_open = 0.25;
/// Of a wave, where it is highest, lowest and steepest; with a second harmonic they lie between these, too.
constexpr int places_of_wave = 4, places_of_two_harmonics = 8;
/// Joints to judge for one answer: two waves beside each other, and a drift.
constexpr std::size_t most_places = 64;

/// What changes slowly, and the joint where it is held.
struct Change {
    double period = infinity;  ///< s: after which it repeats, or the time constant of a drift
    bool repeats = true;
    int places = 0;
    std::function<void(Joint& joint, int place)> hold;
};

/// A force that grows with the position by so much, as a spring to the surroundings.
void add_slope(Joint& joint, double by_place)
{
    // at a crest a slope of rounding errors would be a contact
    if (std::abs(by_place) > rounding * joint.control.k_p) joint.control.contact_stiffness -= by_place;
}

int places_of(const PositionRipple& wave)
{
    return wave.second_amplitude != 0 ? places_of_two_harmonics : places_of_wave;
}

/// Where a wave has come to at one of its places.
double position_at(const PositionRipple& wave, int place)
{
    return (turn * place / places_of(wave) - wave.phase) / wave.periods;
}

Change gravity(double speed)
{
    return {turn / speed, true, places_of_wave, [](Joint& joint, int place) {
                auto& load = joint.load;
                const double angle = turn * place / places_of_wave, amplitude = load.gravity_amplitude;
                load.gravity_amplitude = 0;
                joint.control.feed_forward.gravity = false;
                load.constant -= amplitude * std::sin(angle);
                add_slope(joint, -amplitude * std::cos(angle));
            }};
}

Change cogging(const PositionRipple& wave, double speed)
{
    return {turn / (wave.periods * speed), true, places_of(wave), [wave](Joint& joint, int place) {
                const double at = position_at(wave, place);
                joint.load.cogging = {};
                joint.load.constant += wave_at(wave, at);
                add_slope(joint, wave.by_place(at));
            }};
}

Change force_in_time(const PeriodicForce& force)
{
    return {turn / force.frequency, true, places_of_wave, [force](Joint& joint, int place) {
                joint.load.disturbance.amplitude = 0;
                joint.load.constant += force.amplitude * std::sin(turn * place / places_of_wave);
            }};
}

/// The frictions of a joint's bodies, in the order of its chain.
std::vector<Friction*> frictions_of(Joint& joint)
{
    auto& f = joint.frictions;
    switch (chain_of(joint).bodies) {
        case 1:
            return {&joint.friction};
        case 2:
            return {&f.motor, &f.link};
        default:
            return {&f.motor, &f.transmission, &f.link};
    }
}

/// Of the body with this index, which turns `ratio` times as far as the joint.
Change ripple(const PositionRipple& wave, int body, double ratio, double speed)
{
    return {turn / (wave.periods * ratio * speed), true, places_of(wave), [=](Joint& joint, int place) {
                const double at = position_at(wave, place);
                Friction& friction = *frictions_of(joint)[body];
                friction.ripple = {};
                raise(friction.law, wave_at(wave, at));
                // friction resists: what grows on the way forwards pulls back as a spring does
                const double along = sliding_velocity(joint) < 0 ? -1 : 1;
                add_slope(joint, -along * ratio * ratio * friction.normal_load * wave.by_place(at));
            }};
}

/// Of all bodies at once: as it begins, unless that is soon over, and warm.
Change drift(double time_constant, bool is_soon_over)
{
    const int places = is_soon_over ? 1 : 2;
    return {is_soon_over ? infinity : time_constant, false, places, [places](Joint& joint, int place) {
                for (Friction* friction : frictions_of(joint)) {
                    if (place == places - 1) raise(friction->law, friction->drift.change);
                    friction->drift.change = 0;
                }
            }};
}

std::vector<Change> changes_of(const Joint& joint, double fastest_held)
{
    std::vector<Change> changes;
    const double speed = std::abs(sliding_velocity(joint));
    const auto& load = joint.load;
    if (load.gravity_amplitude != 0) changes.push_back(gravity(speed));
    if (load.cogging.acts()) changes.push_back(cogging(load.cogging, speed));
    if (load.disturbance.amplitude != 0) changes.push_back(force_in_time(load.disturbance));
    const Chain chain = chain_of(joint);
    double time_constant = 0;
    for (int i = 0; i < chain.bodies; ++i) {
        const auto& b = chain.body[i];
        if (b.friction->ripple.acts()) changes.push_back(ripple(b.friction->ripple, i, b.ratio, speed));
        if (b.friction->drift.change != 0) time_constant = std::max(time_constant, b.friction->drift.time_constant);
    }
    if (time_constant > 0) changes.push_back(drift(time_constant, time_constant < fastest_held));
    return changes;
}

/// Whether a spring to the surroundings, which bears nothing while the joint slides, and constant forces say all that
/// the change does: not where it moves the velocity, nor where a drive that knows gravity has a dead zone beside it.
bool can_be_held(const Joint& joint)
{
    const auto& c = joint.control;
    const bool known = c.feed_forward.gravity && joint.load.gravity_amplitude != 0;
    if (c.kind != ControlKind::position || is_set(c.force_rate) || (known && c.dead_zone > 0)) return false;
    Joint other = joint;
    return std::ranges::all_of(frictions_of(other), [](Friction* f) {
        return !(f->ripple.acts() || f->drift.change != 0) || with_levels(f->law, [](double&) {});
    });
}

bool is_open(const NonlinearVerdict& v)
{
    return v.outcome == Outcome::undecided || v.outcome == Outcome::solver_failure ||
           v.region == NonlinearRegion::undecided;
}

/// The worst first: motions that do not slide, those that a larger disturbance reaches, what is not known.
std::tuple<int, double, double> badness(const NonlinearVerdict& v)
{
    const bool open = is_open(v);
    const bool slides = v.outcome == Outcome::stable_sliding;
    const int rank = !open && !slides ? 3 : v.region == NonlinearRegion::bistable ? 2 : open ? 1 : 0;
    const auto size = [](double x) { return std::isfinite(x) ? x : -infinity; };
    return {rank, size(v.amplitude), size(v.growth_rate)};
}

}  // namespace

HeldChanges held_where_changes_are_slow(const Joint& joint)
{
    HeldChanges held;
    if (!changes_on_the_way(joint) || !can_be_held(joint)) return held;
    if (steady_sliding(joint).reason != Reason::none) return held;
    const double fastest_held = turns_of_slow_change * swing_of_gain(joint);
    const double slowest_followed = std::max(longest_followed_change(joint), fastest_held);
    for (const Change& change : changes_of(joint, fastest_held)) {
        if (change.repeats && !(change.period >= slowest_followed)) continue;
        const std::vector<Joint> before = held.places.empty() ? std::vector{joint} : std::move(held.places);
        held.places.clear();
        for (int place = 0; place < change.places; ++place)
            for (Joint j : before) {
                change.hold(j, place);
                held.places.push_back(j);
            }
        if (held.places.size() > most_places) return {};
        held.repeats_after = std::min(held.repeats_after, change.period);
    }
    return held;
}

std::optional<NonlinearVerdict> worst_of(const std::vector<NonlinearVerdict>& places, double repeats_after)
{
    for (const auto& p : places)
        if (p.period * turns_of_slow_change > repeats_after) return {};
    const auto worst = std::max_element(
        places.begin(), places.end(), [](const auto& one, const auto& other) { return badness(one) < badness(other); });
    NonlinearVerdict verdict = *worst;
    verdict.held_places = static_cast<int>(places.size());
    verdict.places_alike = std::all_of(places.begin(), places.end(), [&](const auto& p) {
        return p.outcome == verdict.outcome && p.region == verdict.region;
    });
    return verdict;
}

std::optional<NonlinearVerdict> slow_change_verdict(const Joint& joint, const NonlinearOptions& options)
{
    const auto held = held_where_changes_are_slow(joint);
    if (held.places.empty()) return {};
    std::vector<NonlinearVerdict> verdicts;
    NonlinearOptions asked = options;
    for (const Joint& place : held.places) {
        verdicts.push_back(nonlinear_verdict(place, asked));
        if (is_open(verdicts.back())) asked.effort = effort_behind_open * options.effort;
    }
    return worst_of(verdicts, held.repeats_after);
}

}  // namespace stickslip
