// In one file: one inquiry, phase by phase.
#include "analysis/simulation/sampled/loop_verdict.h"

#include "analysis/base/work_limits.h"
#include "analysis/joint/gains.h"
#include "analysis/loop/loop_use.h"
#include "analysis/simulation/flows/growth_window.h"
#include "analysis/simulation/sampled/closed_loop/loop_start.h"
#include "analysis/simulation/sampled/unsteady_terms.h"
#include "analysis/simulation/solvers/work.h"
#include "analysis/stability/effort_limits.h"
#include "analysis/stability/steady.h"

#include "analysis/stability/real_loop.h"

#include <cmath>
#include <numbers>

namespace stickslip {
namespace {

constexpr double fixed_part = 0.25;  ///< of a tick: steps while small motions are followed
constexpr double lifted = 0.1;       ///< of V_0: size at which a small disturbance that grows is taken up
constexpr double near_rest_share = 1e-4;
constexpr double far_pull = 3;           ///< of the spring, in V_0/|s|
constexpr double faded = 1e-9;           ///< of a push: no more than this is left of it
constexpr double uneven_rtol = 1e-5;     ///< tolerance of motions that an encoder or noise disturbs
constexpr double neutral_growth = 1e-9;  ///< of |s|: neither growth nor decay
/// Of |s|: how much a growth measured in ticks must be before its sign counts. An oscillation that nothing damps grows
/// by 2e-6 |s| in the fixed steps of a continuous loop.
constexpr double measurable_in_ticks = 1e-5;
/// Within which a stated disturbance of a neutral joint has to stick: so many turns add a part in a thousand to it.
constexpr int turns_of_neutral = 100;
/// Repetitions of what changes with position or time that a motion is followed for at most: three stretches of two that
/// go on alike, after one more, beside those of a motion on its way.
constexpr double changes_in_all = 16;

double total_backlash(const Joint& joint)
{
    const auto& m = joint.mechanism;
    if (m.model == Model::single_mass) return 0;
    if (m.model == Model::two_mass) return m.transmission.backlash;
    return m.motor_transmission.backlash + m.transmission_link.backlash;
}

/// How long a cycle may stand still: the spring winds up by what friction holds, from one side to the other and through
/// the dead zone between them.
double held_time(const Joint& joint)
{
    const Chain chain = chain_of(joint);
    const double sliding = sliding_velocity(joint);
    double held = 0;
    for (int i = 0; i < chain.bodies; ++i) {
        const auto& b = chain.body[i];
        held += b.ratio * std::max(static_force(*b.friction), std::abs(steady_force(*b.friction, b.velocity(sliding))));
    }
    const auto acts = actuation(joint, sliding, steady_effort(joint, sliding));
    const double stiffness = std::abs(joint.control.k_p * acts.gain * acts.scale);
    return 2 * (held / stiffness + joint.control.dead_zone / acts.scale) / std::abs(sliding);
}

LoopVerdict refused(Reason reason, Detail why = Detail::none)
{
    LoopVerdict verdict;
    verdict.reason = verdict.stated.reason = reason;
    verdict.detail = why;
    verdict.growth_missing = Detail::not_followed;
    return verdict;
}

/// Whether steady sliding lies in the jump of a push that follows the side of the error: always where an integral
/// brings the error to nothing.
bool chatters(const Joint& joint)
{
    const auto& f = joint.control.feed_forward;
    if (!f.jumps()) return false;
    LoopOptions smooth;
    smooth.ideal_encoder = true;
    const double frame = sliding_velocity(joint);
    SampledLoop loop(joint, frame, frame, LoopSide::joint, smooth);
    const double left = std::abs(f.push(0, loop.reference_velocity(), 1));
    if (loop.integrates()) return left > faded * std::abs(f.coulomb);
    return !loop.begin_steadily() && loop.within_limits();
}

/// Why no motion about steady sliding exists, or none.
std::optional<LoopVerdict> obstacle(const Joint& joint)
{
    const auto sliding = steady_sliding(joint);
    if (sliding.reason != Reason::none) return refused(sliding.reason);
    const Chain chain = chain_of(joint);
    for (int i = 0; i < chain.bodies; ++i)
        if (info(chain.body[i].friction->law).linear_only) return refused(Reason::linear_only);
    if (const auto why = why_not_driven(joint); why != Detail::none) return refused(Reason::unsupported, why);
    if (joint.control.dither.amplitude > 0) return refused(Reason::unsupported, Detail::place_or_time);
    if (total_backlash(joint) > 0) return refused(Reason::unsupported, Detail::backlash);
    if (!(joint.control.k_p * joint.actuator.effort_gain > 0)) return refused(Reason::diverges);
    if (const double tick = tick_of(joint); !(tick > 0) || !(joint.dead_time() < work::ticks_of_dead_time * tick))
        return refused(Reason::not_finite, Detail::no_time_step);
    if (!(longest_change(joint) < longest_followed_change(joint)))
        return refused(Reason::unsupported, Detail::place_or_time);
    if (chatters(joint)) return refused(Reason::no_steady_state, Detail::chatters);
    return {};
}

double spring_rate(const Joint& joint)
{
    const Chain chain = chain_of(joint);
    double inertia = 0;
    for (int i = 0; i < chain.bodies; ++i) inertia += chain.body[i].inertia;
    return std::sqrt(std::abs(joint.control.k_p) / inertia);
}

}  // namespace

double longest_followed_change(const Joint& joint)
{
    return static_cast<double>(work::ticks_of_motion) * tick_of(joint) / changes_in_all;
}

double swing_of_gain(const Joint& joint)
{
    return 2 * std::numbers::pi / spring_rate(acting_joint(joint));
}

bool has_real_loop(const Joint& joint)
{
    const auto& c = joint.control;
    const auto& a = joint.actuator;
    const auto& s = joint.sensor;
    const bool nonlinear = c.dead_zone > 0 || c.feed_forward.coulomb != 0 ||
                           (c.feed_forward.velocity != 1 && c.k_v != 0) || c.dither.amplitude > 0;
    return loop_kind(joint) != LoopKind::ideal || nonlinear || joint.mechanism.hardens() ||
           c.structure == Structure::cascade || c.effort_limit < infinity || a.limit < infinity ||
           a.sag_effort < infinity || s.encoder_quantum > 0 || s.position_noise > 0;
}

bool takes_ticks(const Joint& joint)
{
    return has_real_loop(joint) || has_unsteady_terms(joint);
}

LoopInquiry::LoopInquiry(const Joint& asked, const LoopQuestion& question, GrowthBy by)
    : joint_(acting_joint(asked)), deflection_(displaced(asked, steady_sliding(asked))), question_(question)
{
    if (auto refusal = obstacle(joint_)) {
        verdict_ = *refusal;
        return;
    }
    const double frame = sliding_velocity(joint_);
    if (!find_mode(asked, frame, by)) return;
    const auto& sensor = joint_.sensor;
    LoopOptions real;
    // an encoder or noise disturbs every tick by far more
    real.motion.rtol = noise() > 0 ? std::max(question.rtol, uneven_rtol) : question.rtol;
    real.seed = sensor.position_noise > 0 ? question.seed : 0;
    real.readings = false;
    loop_.emplace(asked, frame, frame, LoopSide::joint, real);
    loop_->begin_steadily();
    steady_ = loop_->state();
    origin_ = loop_->motion.y[loop_->motion.joint.link()];
    begin();
}

/// What small disturbances do; false where that leaves no motion to follow.
bool LoopInquiry::find_mode(const Joint& asked, double frame, GrowthBy by)
{
    LoopOptions smooth;
    smooth.ideal_encoder = true;
    smooth.motion.fixed_step = 1;
    const Joint steady = without_changes(asked);
    SampledLoop linear(steady, frame, frame, LoopSide::joint, smooth);
    const auto refuse = [this](Reason reason, Detail why) {
        verdict_ = refused(reason, why);
        return false;
    };
    verdict_.tick = linear.period();
    linear.motion.set_fixed_step(fixed_part * linear.period());
    if (!linear.begin_steadily()) return refuse(Reason::no_steady_state, Detail::effort_limit);
    const bool delayed = linear.motion.joint.has_delayed_friction();
    // the theory has no term for a push by the error
    const bool has_theory = delayed || !joint_.control.feed_forward.by_error();
    const auto root = has_theory ? real_root(steady) : std::complex<double>(missing, missing);
    const bool by_theory = delayed || leaves_within_tick(root, linear.period());
    mode_ = by_theory ? mode_by_theory(root, linear.period()) : loop_mode(linear);
    verdict_.growth_missing = mode_.why;
    verdict_.multiplier = mode_.multiplier;
    if (!mode_.known()) return refuse(Reason::not_converged, mode_.why);
    const auto s = mode_.rate();
    if (by_theory)
        verdict_.growth_rate = s.real();
    else if (by == GrowthBy::motion)
        verdict_.growth_rate = measure_loop_growth(linear, mode_);
    else
        verdict_.growth_rate = has_theory ? root.real() : s.real();
    double growth = std::isfinite(verdict_.growth_rate) ? verdict_.growth_rate : s.real();
    if (std::isfinite(root.real()) && std::abs(growth) < measurable_in_ticks * std::abs(s))
        verdict_.growth_rate = growth = root.real();
    if (has_theory && contradicts(growth, root.real(), measurable_in_ticks * std::abs(s)))
        return refuse(Reason::not_converged, Detail::growth_unresolved);
    neutral_ = std::abs(growth) < neutral_growth * std::abs(s);
    // a disturbance of some size may end in sticking for good all the same
    if (!(std::abs(s) > 0) || (neutral_ && !is_set(question_.disturbance.size))) return refuse(Reason::neutral, {});
    auto& options = follow_;
    options.turn_limit = neutral_ ? std::min(question_.turn_limit, turns_of_neutral) : question_.turn_limit;
    options.steady_attracts = neutral_ || growth < 0;
    options.decay = s.real();
    options.winds = std::abs(gains_of(joint_.control).k_i / gains_of(joint_.control).k_p);
    // the slow mode of an integral does not turn, but the spring swings beside it
    options.turn = 2 * std::numbers::pi / (winds_up_slowly() ? spring_rate(joint_) : std::abs(s));
    options.held = held_time(joint_);
    options.stays = low_limit_at_rest(joint_, frame).has_value();
    options.uneven = noise() > 0 || changes_on_the_way(joint_);
    options.noise = noise();
    // slips swing at the spring's frequency however fast small motions grow
    if (options.uneven)
        options.turn = std::max({options.turn, 2 * std::numbers::pi / spring_rate(joint_), longest_change(joint_)});
    return true;
}

void LoopInquiry::follow(Phase phase)
{
    phase_ = phase;
    follower_.emplace(*loop_, steady_, origin_, follow_);
}

/// The smallest disturbance that the loop sees: a step of the encoder, or its noise.
double LoopInquiry::noise() const
{
    const auto& sensor = joint_.sensor;
    return std::max(sensor.encoder_quantum, sensor.position_noise) / sensor.position_scale;
}

/// Where an encoder or noise keeps steady sliding from being steady, a cycle is what is larger than the jitter.
void LoopInquiry::begin()
{
    const bool small = !is_set(question_.disturbance.size);
    if (!follow_.uneven || !follow_.steady_attracts || small) return begin_stated();
    loop_->displace(noise());
    follow(Phase::jitter);
}

void LoopInquiry::learn_jitter(const LoopEnd& end)
{
    if (end.kind == LoopEnd::Kind::steady) follow_.jitter = {end.amplitude, end.velocity_min, end.velocity_max};
}

void LoopInquiry::begin_stated()
{
    const auto& disturbance = question_.disturbance;
    const auto s = mode_.rate();
    const double V0 = loop_->frame();
    const bool decays = follow_.steady_attracts, small = !is_set(disturbance.size);
    verdict_.size = small ? small_size(disturbance.kind, commanded_velocity(joint_), s) : disturbance.size;
    if (follow_.uneven && small && decays) {
        loop_->displace(noise());
    } else if (small && decays) {
        verdict_.stated.kind = LoopEnd::Kind::steady;
        return judge_stated();
    } else if (small) {
        // what a small disturbance grows along is known, its size is not
        auto lifted_state = steady_;
        const auto& j = loop_->motion.joint;
        if (follow_.uneven) follow_.lead = std::max(0.0, std::log(lifted * std::abs(V0 / s) / noise()));
        if (mode_.right.empty()) {
            loop_->displace(lifted * std::abs(V0 / s));
            return follow(Phase::stated);
        }
        const double unit = std::abs(mode_.right[static_cast<std::size_t>(j.bodies())]);
        const double speed = j.logarithmic(0) ? 1 : std::abs(V0);
        auto along = mode_.right.begin();
        for (std::size_t i = 0; i < steady_.size();
             ++i)  // the mode is of the joint without changes, which has no clock
            if (static_cast<int>(i) != j.clock_index()) lifted_state[i] += lifted * speed / unit * (along++)->real();
        loop_->set_state(lifted_state);
        loop_->motion.enter();
    } else if (!disturb_loop(*loop_, joint_, disturbance)) {
        const auto why = why_not_disturbed(joint_, disturbance.kind);
        verdict_ = refused(why == Detail::none ? Reason::law_needs_motion : Reason::unsupported, why);
        return;
    }
    follow(Phase::stated);
}

void LoopInquiry::ended(const LoopEnd& end)
{
    follower_.reset();
    if (phase_ == Phase::jitter) {
        learn_jitter(end);
        return begin_stated();
    }
    if (phase_ == Phase::stated) {
        verdict_.stated = end;
        if (follow_.uneven && !is_set(question_.disturbance.size)) learn_jitter(end);
        return judge_stated();
    }
    // a pull of the spring where a start from near rest comes back
    if (end.kind == LoopEnd::Kind::steady && phase_ == Phase::from_rest && begin_search(Phase::pulled)) return;
    judge_search(end);
}

void LoopInquiry::judge_stated()
{
    const auto& stated = verdict_.stated;
    verdict_.reason = stated.reason;
    verdict_.cycle = stated;
    if (stated.reason == Reason::not_converged)
        verdict_.detail = stated.cut_short ? Detail::limit_of_work : Detail::limit_of_turns;
    // what a small disturbance grows to may be far larger than its first turn
    if (deflection_ > 0)
        verdict_.overshoot = std::fmax(0, std::fmax(stated.first_peak, stated.cycle_peak)) / deflection_;
    if (neutral_) {
        const bool sticks = stated.oscillates() && stated.stick_fraction > 0;
        if (!sticks) verdict_ = refused(Reason::neutral);
        return;
    }
    if (!follow_.steady_attracts) {
        verdict_.region = NonlinearRegion::stick_slip;
    } else if (stated.oscillates()) {
        verdict_.region = NonlinearRegion::bistable;
        verdict_.noise_suffices = follow_.uneven && !is_set(question_.disturbance.size);
    } else if (question_.region) {
        verdict_.searched_from = winds_up_slowly() ? LargerTried::pull_of_spring : LargerTried::pull;
        if (!begin_search(Phase::from_rest) && !begin_search(Phase::pulled)) judge_search({});
    }
}

/// The slowest mode is that of the integral, −k_i/k_p: how far the loop swings does not follow from it, and a pull by
/// 3 V_0/|s| would drive the joint backwards for a long time.
bool LoopInquiry::winds_up_slowly() const
{
    constexpr double near = 3;
    const auto& c = joint_.control;
    return std::abs(mode_.rate()) < near * std::abs(gains_of(c).k_i / gains_of(c).k_p);
}

/// False where the loop has no such start.
bool LoopInquiry::begin_search(Phase phase)
{
    const bool rests = loop_->motion.joint.anything_can_rest();
    const double rate = winds_up_slowly() ? spring_rate(joint_) : std::abs(mode_.rate());
    const double pull = far_pull * std::abs(commanded_velocity(joint_)) / rate;
    const Disturbance far = phase == Phase::pulled ? Disturbance{DisturbanceKind::offset, pull}
                                                   : Disturbance{DisturbanceKind::start, rests ? 0 : near_rest_share};
    if (!disturb_loop(*loop_, joint_, far)) return false;
    follow(phase);
    return true;
}

void LoopInquiry::judge_search(const LoopEnd& large)
{
    if (large.kind == LoopEnd::Kind::steady && follow_.stays) {
        // the starts that were followed kept away from where no effort of the loop gets the joint going again
        LoopEnd held;
        held.kind = LoopEnd::Kind::held, held.stick_fraction = 1;
        return judge_search(held);
    }
    if (large.kind == LoopEnd::Kind::steady) verdict_.region = NonlinearRegion::stable;
    if (large.oscillates()) verdict_.region = NonlinearRegion::bistable, verdict_.cycle = large;
    if (verdict_.region != NonlinearRegion::undecided) return;
    verdict_.reason = large.reason;
    verdict_.detail = large.cut_short ? Detail::limit_of_work : Detail::larger_not_followed;
}

LoopVerdict loop_verdict(const Joint& joint, const LoopQuestion& question)
{
    LoopInquiry inquiry(joint, question);
    Work work(Work::for_ticks * question.effort);
    while (inquiry.open()) {
        auto& loop = inquiry.loop();
        auto& follower = inquiry.follower();
        const auto watch = [&follower](const DrivenStep& s) { follower.watch(s); };
        std::optional<LoopEnd> end;
        const double of_step = Work::of_driven_step(loop.motion.joint.size());
        while (!end) {
            const long before = loop.motion.steps;
            end = follower.after_tick(loop.tick(0, loop.reference_velocity(), 0, watch));
            work.spend(static_cast<double>(loop.motion.steps - before) * of_step);
            if (!end && work.spent()) end = follower.cut_short();
        }
        inquiry.ended(*end);
    }
    return inquiry.verdict();
}

}  // namespace stickslip
