#include "analysis/simulation/sampled/loop_verdict.h"

#include "analysis/joint/gains.h"
#include "analysis/loop/loop_use.h"
#include "analysis/simulation/sampled/loop_start.h"
#include "analysis/simulation/sampled/loop_trajectory.h"
#include "analysis/stability/steady.h"

#include <cmath>
#include <optional>

namespace stickslip {
namespace {

constexpr double fixed_part = 0.25;   ///< of a tick: steps while small motions are followed
constexpr double lifted = 0.1;        ///< of V_0: size at which a small disturbance that grows is taken up
constexpr double near_rest_share = 1e-4;
constexpr double far_pull = 3;        ///< of the spring, in V_0/|s|
constexpr double neutral_growth = 1e-9;  ///< of |s|: neither growth nor decay

constexpr std::string_view tired = "the motion was followed to the limit of turns";
constexpr std::string_view no_force =
    "the limit of the effort is below what steady sliding takes: there is no steady sliding";
constexpr std::string_view place_and_time =
    "a force or friction that changes with position or time leaves no steady sliding to disturb";
constexpr std::string_view play = "play in a transmission has no steady sliding to disturb";

double total_play(const Joint& joint)
{
    const auto& m = joint.mechanism;
    if (m.model == Model::single_mass) return 0;
    if (m.model == Model::two_mass) return m.transmission.backlash;
    return m.motor_transmission.backlash + m.transmission_link.backlash;
}

/// How long a cycle may stand still: the spring winds up by what friction holds, from one side to the other.
double held_time(const Joint& joint, double V0)
{
    const Chain chain = chain_of(joint);
    double held = 0;
    for (int i = 0; i < chain.bodies; ++i) {
        const auto& b = chain.body[i];
        held += b.ratio * std::max(static_force(*b.friction), std::abs(steady_force(*b.friction, b.velocity(V0))));
    }
    return 2 * held / std::abs(joint.control.k_p * V0);
}

LoopVerdict refused(Reason reason, std::string_view why)
{
    LoopVerdict verdict;
    verdict.reason = verdict.stated.reason = reason;
    verdict.explanation = why;
    verdict.growth_missing = "no motion was followed";
    return verdict;
}

/// Why no motion about steady sliding exists, or none.
std::optional<LoopVerdict> obstacle(const Joint& joint)
{
    const auto sliding = steady_sliding(joint);
    if (sliding.reason != Reason::none) return refused(sliding.reason, {});
    const Chain chain = chain_of(joint);
    for (int i = 0; i < chain.bodies; ++i)
        if (info(chain.body[i].friction->law).linear_only) return refused(Reason::linear_only, {});
    if (const auto why = why_not_driven(joint); !why.empty()) return refused(Reason::unsupported, why);
    if (has_unsteady_terms(joint)) return refused(Reason::unsupported, place_and_time);
    if (total_play(joint) > 0) return refused(Reason::unsupported, play);
    if (!(joint.control.k_p > 0)) return refused(Reason::diverges, {});
    return {};
}

}  // namespace

bool has_real_loop(const Joint& joint)
{
    const auto& c = joint.control;
    const auto& a = joint.actuator;
    const auto& s = joint.sensor;
    const bool nonlinear = c.dead_zone > 0 || c.feed_forward.coulomb != 0 || c.feed_forward.velocity != 1;
    return loop_kind(joint) != LoopKind::ideal || nonlinear || c.structure == Structure::cascade ||
           c.effort_limit < infinity ||
           a.limit < infinity || a.sag_effort < infinity || s.encoder_quantum > 0 || s.position_noise > 0;
}

LoopVerdict loop_verdict(const Joint& asked, const LoopQuestion& question)
{
    const Joint joint = with_gains(asked);
    if (auto refusal = obstacle(joint)) return *refusal;
    LoopVerdict verdict;
    const double V0 = commanded_velocity(joint);
    const double frame = V0 / joint.sensor.position_scale;
    LoopOptions smooth;
    smooth.ideal_encoder = true;
    smooth.motion.fixed_step = 1;
    SampledLoop linear(asked, frame, frame, LoopSide::joint, smooth);
    verdict.tick = linear.period();
    linear.motion.set_fixed_step(fixed_part * linear.period());
    if (!linear.begin_steadily()) return refused(Reason::no_steady_state, no_force);
    const auto mode = loop_mode(linear);
    verdict.growth_missing = mode.why;
    verdict.multiplier = mode.multiplier;
    if (!mode.known()) return refused(Reason::not_converged, mode.why);
    verdict.growth_rate = measure_loop_growth(linear, mode);
    const auto s = mode.rate();
    const double measured = std::isfinite(verdict.growth_rate) ? verdict.growth_rate : s.real();
    if (!(std::abs(s) > 0) || std::abs(measured) < neutral_growth * std::abs(s)) return refused(Reason::neutral, {});
    const bool decays = measured < 0;

    const auto& sensor = joint.sensor;
    LoopOptions real;
    real.motion.rtol = question.rtol;
    real.seed = sensor.position_noise > 0 ? question.seed : 0;
    SampledLoop loop(asked, frame, frame, LoopSide::joint, real);
    LoopFollowOptions options;
    options.turn_limit = question.turn_limit;
    options.steady_attracts = decays;
    options.decay = s.real();
    options.turn = 2 * std::numbers::pi / std::abs(s);
    options.held = held_time(joint, V0);
    options.uneven = sensor.encoder_quantum > 0 || sensor.position_noise > 0;
    loop.begin_steadily();
    const auto steady = loop.state();
    const double origin = loop.motion.y[loop.motion.joint.link()];

    const bool stated_small = !is_set(question.disturbance.size);
    verdict.size = stated_small ? small_size(question.disturbance.kind, V0, s) : question.disturbance.size;
    if (options.uneven && stated_small && decays) {
        // the smallest disturbance that such a loop sees
        loop.displace(std::max(sensor.encoder_quantum, sensor.position_noise) / sensor.position_scale);
        verdict.stated = follow_loop(loop, steady, origin, options);
    } else if (stated_small && decays) {
        verdict.stated.kind = LoopEnd::Kind::steady;
    } else if (stated_small) {
        // what a small disturbance grows along is known, its size is not
        auto lifted_state = steady;
        const double unit = std::abs(mode.right[static_cast<std::size_t>(loop.motion.joint.bodies())]);
        const double speed = loop.motion.joint.logarithmic(0) ? 1 : std::abs(frame);
        for (std::size_t i = 0; i < steady.size(); ++i) lifted_state[i] += lifted * speed / unit * mode.right[i].real();
        loop.set_state(lifted_state);
        loop.motion.enter();
        verdict.stated = follow_loop(loop, steady, origin, options);
    } else {
        Disturbance stated = question.disturbance;
        if (!disturb_loop(loop, joint, stated)) return refused(Reason::law_needs_motion, {});
        verdict.stated = follow_loop(loop, steady, origin, options);
    }
    verdict.reason = verdict.stated.reason;
    verdict.cycle = verdict.stated;
    if (verdict.stated.reason == Reason::not_converged) verdict.explanation = tired;

    const double deflection = std::abs(steady_sliding(joint).deflection);
    verdict.overshoot = std::fmax(0, verdict.stated.first_peak) / deflection;
    if (!decays) {
        verdict.region = LoopRegion::stick_slip;
    } else if (verdict.stated.oscillates()) {
        verdict.region = LoopRegion::bistable;
    } else if (question.region) {
        verdict.searched_from = "a start from near rest; a pull of the spring by 3 V_0/|s|";
        const bool rests = loop.motion.joint.anything_can_rest();
        LoopEnd large;
        for (const bool pull : {false, true}) {
            const Disturbance far = pull ? Disturbance{DisturbanceKind::offset, far_pull * std::abs(V0) / std::abs(s)}
                                         : Disturbance{DisturbanceKind::start, rests ? 0 : near_rest_share};
            if (!disturb_loop(loop, joint, far)) continue;
            large = follow_loop(loop, steady, origin, options);
            if (large.kind != LoopEnd::Kind::steady) break;
        }
        if (large.kind == LoopEnd::Kind::steady) verdict.region = LoopRegion::stable;
        if (large.oscillates()) verdict.region = LoopRegion::bistable, verdict.cycle = large;
        if (verdict.region == LoopRegion::undecided) {
            verdict.reason = large.reason;
            verdict.explanation = "a larger disturbance could not be followed to its end";
        }
    }
    return verdict;
}

}  // namespace stickslip
