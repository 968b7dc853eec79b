// In one file: one loop, from each of its starts through its ticks.
#include "analysis/simulation/sampled/closed_loop/sampled_loop.h"

#include "analysis/loop/felt.h"

namespace stickslip {
namespace {

constexpr double whole = 1e-9;  ///< of a tick: dead times nearer to a whole number of ticks are meant to be one

constexpr double slowest = 1e-9;  ///< of V_0, for bodies that rest: their friction is that of the slowest sliding

/// Ticks of a continuous loop: so many a radian of the fastest thing that the loop does, dither included, and a part of
/// its filters; but of filters far beyond the loop no more than follows their lag, which is that of a hold.
constexpr double ticks_per_radian = 40, filter_part = 0.05, most_for_filters = 8;

/// Of the time constant with which the velocity gain brakes the first body: held over the whole of it, the gain of an
/// overdamped loop would throw the body back.
constexpr double braking_part = 0.1;

/// Of a usual tick. A lag as short as this is a dead time of its length: to the loop they differ by half the square of
/// lag times frequency, 3e-8, but after each tick the lag would be a layer of many steps.
constexpr double short_lag = 0.01;

double usual_tick(const Joint& joint)
{
    const Chain chain = chain_of(joint);
    double fastest = 0, before = 0, friction = std::abs(joint.load.constant);
    const double per_command = std::abs(effort_per_command(joint));
    for (int i = 0; i < chain.bodies; ++i) friction += chain.body[i].ratio * static_force(*chain.body[i].friction);
    for (int i = 0; i < chain.bodies; ++i) {  // a spring that hardens: stretched by twice what the joint carries
        const Spring spring = i + 1 < chain.bodies ? chain.spring(i) : Spring{joint.control.contact_stiffness};
        const double behind = spring.cubic > 0 ? spring.slope(spring.stretch(2 * friction)) : spring.stiffness;
        const double held = before + behind + (i == 0 ? per_command * std::abs(joint.control.k_p) : 0);
        fastest = std::max(fastest, std::sqrt(held / chain.body[i].inertia));
        before = behind;
    }
    const double braking = per_command * std::abs(joint.control.k_v) / chain.body[0].inertia;
    return std::min(1 / (ticks_per_radian * std::max(fastest, 1e-9)), braking_part / std::max(braking, 1e-9));
}

Joint with_short_lag_as_delay(Joint joint)
{
    if (is_set(joint.control.period) || !(joint.actuator.lag < short_lag * usual_tick(joint))) return joint;
    joint.control.delay += joint.actuator.lag;
    joint.actuator.lag = 0;
    return joint;
}

}  // namespace

double tick_of(const Joint& given)
{
    if (is_set(given.control.period)) return given.control.period;
    const Joint joint = with_short_lag_as_delay(with_gains(given));
    const auto& c = joint.control;
    const double usual = usual_tick(joint);
    double tick = usual;
    for (const double filter : {c.velocity_estimate.tau, joint.actuator.lag})
        if (filter > 0) tick = std::min(tick, filter_part * filter);
    tick = std::max(tick, usual / most_for_filters);
    return c.dither.amplitude > 0 ? std::min(tick, 1 / (ticks_per_radian * c.dither.frequency)) : tick;
}

SampledLoop::SampledLoop(const Joint& joint, double frame, double speed, LoopSide side, const LoopOptions& options)
    : motion(DrivenJoint(with_short_lag_as_delay(with_gains(joint)), frame, speed, side), options.motion),
      joint_(with_short_lag_as_delay(with_gains(joint))),
      options_(options),
      noise_(options.seed),
      period_(is_set(options.tick) && !is_set(joint.control.period) ? options.tick : tick_of(joint)),
      frame_reading_(joint.sensor.position_scale * motion.joint.reading_ratio() * frame),
      controller_(joint, frame_reading_, motion.joint.reading_ratio())
{
    const auto in_ticks = [&](double time, double& part) {
        const double delayed = time / period_, ticks = std::floor(delayed + whole);
        part = delayed - ticks > whole ? delayed - ticks : 0;
        return ticks;
    };
    if (!(period_ > 0) || !std::isfinite(joint_.dead_time() / period_))
        throw std::domain_error(std::string(no_time_step));
    const double ticks = in_ticks(joint_.dead_time(), delayed_part_);
    ticks_late_ = static_cast<long>(in_ticks(joint.sensor.delay, reading_part_));
    // with a part of a tick of dead time the command before the oldest one still holds when a tick begins
    line_.resize(static_cast<std::size_t>(ticks) + 1 + (delayed_part_ > 0 ? 1 : 0));
}

bool SampledLoop::within_limits() const
{
    return std::isfinite(steady_command_) && std::abs(steady_command_) < joint_.control.effort_limit;
}

/// As in steady sliding at this share of the reference's velocity, about the reference at `reference`.
bool SampledLoop::slide(double rate, double reference)
{
    auto& j = motion.joint;
    const double per_reading = 1 / (joint_.sensor.position_scale * j.reading_ratio());
    const auto steady = j.steady(rate * per_reading);
    steady_command_ = steady.command;
    if (!within_limits()) return false;
    const double behind = controller_.begin(steady.command, rate, period_);
    if (!std::isfinite(behind)) return false;
    controller_.shift(reference);
    std::fill(line_.begin(), line_.end(), steady.command);
    const double x = (behind + reference - joint_.sensor.position_offset) * per_reading;
    motion.y = steady.y;
    for (int i = 0; i < j.bodies(); ++i) motion.y[i] += x;
    j.arriving = steady.command;
    j.begin_past(motion.y.data(), rate * per_reading);
    motion.enter();
    ticks_ = 0;
    return std::isfinite(x);
}

bool SampledLoop::begin_steadily()
{
    if (!slide(frame_reading_, 0)) return false;
    if (frame() != 0) motion.joint.contact_origin = motion.y[motion.joint.link()];
    motion.enter();
    return true;
}

bool SampledLoop::begin_slower(double share)
{
    if (!begin_steadily()) return false;
    const double full = steady_command_;
    if (!slide(std::max(share, slowest) * frame_reading_, 0) && (share != 0 || !slide(frame_reading_, 0))) return false;
    steady_command_ = full;
    // friction that needs motion knows no rest: its body creeps
    if (share == 0)
        for (int i = 0; i < motion.joint.bodies(); ++i)
            if (!motion.joint.logarithmic(i)) motion.joint.set_velocity(motion.y.data(), i, 0);
    motion.enter();
    return true;
}

bool SampledLoop::begin_sliding(double reading, double rate)
{
    return slide(rate, reading);
}

void SampledLoop::displace(double x)
{
    for (int i = 0; i < motion.joint.bodies(); ++i) motion.y[i] += x;
    controller_.shift(joint_.sensor.position_scale * motion.joint.reading_ratio() * x);
}

void SampledLoop::begin_at_rest(double reading)
{
    const auto& s = joint_.sensor;
    motion.y = motion.joint.at_rest((reading - s.position_offset) / s.position_scale / motion.joint.reading_ratio());
    std::fill(line_.begin(), line_.end(), 0);
    motion.joint.arriving = 0;
    motion.joint.begin_past(motion.y.data(), 0);
    motion.enter();
    ticks_ = 0;
}

void SampledLoop::begin_holding(double reading, double command)
{
    begin_at_rest(reading);
    controller_.begin_holding(read(), command, period_);
    std::fill(line_.begin(), line_.end(), command);
    motion.joint.arriving = command;
    if (motion.joint.has_lag()) motion.joint.lagged(motion.y.data()) = command;
    motion.enter();
}

void SampledLoop::set_clock(double controller, double t)
{
    clock_ = controller;
    auto& j = motion.joint;
    if (!j.has_clock()) return;
    j.clock(motion.y.data()) = t;
    j.restart_past(motion.y.data());
}

void SampledLoop::scale_about(const std::vector<double>& steady, double by)
{
    auto scaled = state();
    const double t = motion.joint.has_clock() ? motion.joint.clock(motion.y.data()) : 0;
    for (std::size_t i = 0; i < scaled.size(); ++i) scaled[i] = steady[i] + by * (scaled[i] - steady[i]);
    set_state(scaled);
    if (!motion.joint.has_clock()) return;
    motion.joint.clock(motion.y.data()) = t;
    motion.joint.scale_past(by);
}

double SampledLoop::read()
{
    const auto& s = joint_.sensor;
    const auto& j = motion.joint;
    double reading = s.position_scale * j.reading_ratio() * motion.y[j.measured()] + s.position_offset;
    if (options_.ideal_encoder) return reading;
    if (options_.seed != 0) reading += s.position_noise * noise_();
    if (s.encoder_quantum > 0) {
        const double path = frame_reading_ * time();
        reading = s.encoder_quantum * std::round((reading + path) / s.encoder_quantum) - path;
    }
    return reading;
}

void SampledLoop::ask(double reference, double rate, double added)
{
    const auto& j = motion.joint;
    const bool exact_known = options_.readings || controller_.reads_velocity();
    const double exact =
        exact_known ? joint_.sensor.position_scale * j.reading_ratio() * j.velocity(motion.y.data(), j.measured())
                    : missing;
    readings_.position = read();
    controller_.read(readings_.position, period_, exact);
    controller_.set_path(frame_reading_ * time());
    controller_.set_time(clock_ + time() + (continuous() ? 0.5 * period_ : 0));
    std::copy(line_.begin() + 1, line_.end(), line_.begin());
    line_.back() = controller_.command(reference, rate, period_, added);
    motion.joint.arriving = line_.front();
    motion.enter();
    readings_.velocity = controller_.state.velocity;
    readings_.command = controller_.logged();
    if (options_.readings && reading_part_ == 0) readings_.effort = measured_effort();
}

double SampledLoop::measured_effort()
{
    const double measured = joint_.sensor.effort_scale * motion.joint.effort(motion.y.data());
    const bool noisy = options_.seed != 0 && !options_.ideal_encoder;
    return noisy ? measured + joint_.sensor.effort_noise * noise_() : measured;
}

double SampledLoop::open_tick()
{
    ask(0, frame_reading_, 0);
    in_delayed_part_ = delayed_part_ > 0;
    return in_delayed_part_ ? delayed_part_ * period_ : period_;
}

double SampledLoop::next_piece()
{
    if (!in_delayed_part_) return ++ticks_, 0;
    in_delayed_part_ = false;
    motion.joint.arriving = line_[1];
    motion.enter();
    return period_ - delayed_part_ * period_;
}

std::vector<double> SampledLoop::state() const
{
    std::vector<double> all(motion.y.begin(), motion.y.begin() + motion.joint.size());
    const auto& c = controller_.state;
    all.insert(all.end(), c.window.begin(), c.window.end());
    all.push_back(c.velocity);
    if (controller_.continuous()) all.push_back(c.before), all.push_back(c.output);
    if (controller_.integrates()) all.push_back(c.integral);
    if (controller_.integrates() && controller_.continuous()) all.push_back(c.error);
    // the oldest command has done its work when the next tick begins
    all.insert(all.end(), line_.begin() + 1, line_.end());
    return all;
}

void SampledLoop::set_state(const std::vector<double>& state)
{
    auto next = state.begin();
    const auto take = [&next](auto begin, auto end) { std::copy_n(next, end - begin, begin), next += end - begin; };
    take(motion.y.begin(), motion.y.begin() + motion.joint.size());
    take(controller_.state.window.begin(), controller_.state.window.end());
    controller_.state.velocity = *next++;
    auto& c = controller_.state;
    if (controller_.continuous()) c.before = *next++, c.output = *next++;
    if (controller_.integrates()) c.integral = *next++;
    if (controller_.integrates() && controller_.continuous()) c.error = *next++;
    take(line_.begin() + 1, line_.end());
    controller_.state.fresh = false;
}

}  // namespace stickslip
