#include "analysis/simulation/attractor/slow_load.h"

#include "analysis/simulation/sampled/loop_verdict.h"
#include "analysis/stability/steady.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace stickslip {
namespace {

constexpr double turn = 2 * std::numbers::pi;
/// Turns of the joint, or of its cycle, within which a load that is held may not repeat: in one of them it then changes
/// by 6 % of its amplitude at most.
constexpr double turns_of_slow_load = 100;
constexpr double rounding = 1e-12;
/// Of the effort, behind a place that took it all: the others are like it, and only one that cycles changes the answer.
constexpr double effort_behind_open = 0.25;
/// Of a wave, where it is highest, lowest and steepest; with a second harmonic they lie between these, too.
constexpr int places_of_wave = 4, places_of_two_harmonics = 8;

/// A wave of the load over the position, at its places.
struct Wave {
    double period = infinity;  ///< s
    int places = 0;
    bool gravity = false;

    /// The joint with the wave held at one of its places.
    Joint held(Joint joint, int place) const
    {
        auto& load = joint.load;
        const double angle = turn * place / places;
        double force, by_place;
        if (gravity) {
            force = -load.gravity_amplitude * std::sin(angle);
            by_place = -load.gravity_amplitude * std::cos(angle);
            load.gravity_amplitude = 0;
            joint.control.feed_forward.gravity = false;
        } else {
            const double at = (angle - load.cogging.phase) / load.cogging.periods;
            force = wave_at(load.cogging, at);
            by_place = load.cogging.by_place(at);
            load.cogging = {};
        }
        load.constant += force;
        // at a crest a slope of rounding errors would be a contact
        if (std::abs(by_place) > rounding * joint.control.k_p) joint.control.contact_stiffness -= by_place;
        return joint;
    }
};

std::vector<Wave> waves_of(const Joint& joint)
{
    std::vector<Wave> waves;
    const double speed = std::abs(sliding_velocity(joint));
    const auto& load = joint.load;
    if (load.gravity_amplitude != 0) waves.push_back({turn / speed, places_of_wave, true});
    if (load.cogging.acts())
        waves.push_back({turn / (load.cogging.periods * speed),
                         load.cogging.second_amplitude != 0 ? places_of_two_harmonics : places_of_wave});
    return waves;
}

/// Whether a spring to the surroundings, which bears nothing while the joint slides, and a constant load say all that
/// the wave does: not where it moves the velocity, nor where a drive that knows gravity has a dead zone beside it.
bool can_be_held(const Joint& joint)
{
    const auto& c = joint.control;
    const bool known = c.feed_forward.gravity && joint.load.gravity_amplitude != 0;
    return c.kind == ControlKind::position && !is_set(c.force_rate) && !(known && c.dead_zone > 0);
}

HeldLoad held(const Joint& joint, double slowest_followed, double fastest_held)
{
    HeldLoad load;
    if (!can_be_held(joint)) return load;
    for (const Wave& wave : waves_of(joint)) {
        if (!(wave.period >= slowest_followed) || !(wave.period >= fastest_held)) continue;
        if (load.places.empty()) load.places.push_back(joint);
        std::vector<Joint> more;
        for (const Joint& j : load.places)
            for (int place = 0; place < wave.places; ++place) more.push_back(wave.held(j, place));
        load.places = std::move(more);
        load.repeats_after = std::min(load.repeats_after, wave.period);
    }
    return load;
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

HeldLoad held_at_places(const Joint& joint)
{
    return held(joint, 0, 0);
}

HeldLoad held_where_load_is_slow(const Joint& joint)
{
    if (joint.load.gravity_amplitude == 0 && !joint.load.cogging.acts()) return {};
    if (steady_sliding(joint).reason != Reason::none) return {};
    return held(joint, longest_followed_change(joint), turns_of_slow_load * swing_of_gain(joint));
}

std::optional<NonlinearVerdict> worst_of(const std::vector<NonlinearVerdict>& places, double repeats_after)
{
    for (const auto& p : places)
        if (p.period * turns_of_slow_load > repeats_after) return {};
    const auto worst = std::max_element(
        places.begin(), places.end(), [](const auto& one, const auto& other) { return badness(one) < badness(other); });
    NonlinearVerdict verdict = *worst;
    verdict.held_places = static_cast<int>(places.size());
    verdict.places_alike = std::all_of(places.begin(), places.end(), [&](const auto& p) {
        return p.outcome == verdict.outcome && p.region == verdict.region;
    });
    return verdict;
}

std::optional<NonlinearVerdict> slow_load_verdict(const Joint& joint, const NonlinearOptions& options)
{
    const auto held = held_where_load_is_slow(joint);
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
