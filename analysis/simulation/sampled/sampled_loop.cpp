#include "analysis/simulation/sampled/sampled_loop.h"

namespace stickslip {
namespace {

constexpr double whole = 1e-9;  ///< of a tick: dead times nearer to a whole number of ticks are meant to be one

constexpr double slowest = 1e-9;  ///< of V_0, for bodies that rest: their friction is that of the slowest sliding

/// Ticks of a continuous loop: so many a radian of the fastest thing that the loop does, and a part of its filters.
constexpr double ticks_per_radian = 100, filter_part = 0.05;

}  // namespace

double tick_of(const Joint& joint)
{
    const auto& c = joint.control;
    if (is_set(c.period)) return c.period;
    const Chain chain = chain_of(joint);
    double fastest = 0, before = 0;  // of each body against what holds it
    for (int i = 0; i < chain.bodies; ++i) {
        const double behind = i + 1 < chain.bodies ? chain.stiffness[i] : c.contact_stiffness;
        const double held = before + behind + (i == 0 ? std::abs(c.k_p) : 0);
        fastest = std::max(fastest, std::sqrt(held / chain.body[i].inertia));
        before = behind;
    }
    double tick = 1 / (ticks_per_radian * std::max(fastest, 1e-9));
    for (const double filter : {c.velocity_estimate.tau, joint.actuator.lag})
        if (filter > 0) tick = std::min(tick, filter_part * filter);
    return tick;
}

SampledLoop::SampledLoop(const Joint& joint, double frame, double speed, LoopSide side, const LoopOptions& options)
    : motion(DrivenJoint(joint, frame, speed, side), options.motion),
      joint_(joint),
      side_(side),
      options_(options),
      noise_(options.seed),
      period_(is_set(options.tick) && !is_set(joint.control.period) ? options.tick : tick_of(joint)),
      frame_reading_(joint.sensor.position_scale * motion.joint.reading_ratio() * frame),
      controller_(joint.control, frame_reading_)
{
    const double late = joint.control.delay / period_;
    const double ticks = std::floor(late + whole);
    late_part_ = late - ticks > whole ? late - ticks : 0;
    // with a part of a tick of dead time the command before the oldest one still holds when a tick begins
    line_.resize(static_cast<std::size_t>(ticks) + 1 + (late_part_ > 0 ? 1 : 0));
}

bool SampledLoop::within_limits() const
{
    return std::isfinite(steady_command_) && std::abs(steady_command_) < joint_.control.effort_limit;
}

bool SampledLoop::begin_steadily()
{
    const auto steady = motion.joint.steady(motion.joint.frame());
    steady_command_ = steady.command;
    if (!within_limits()) return false;
    std::fill(line_.begin(), line_.end(), steady.command);
    const double reading = controller_.steady_reading(steady.command);
    const auto& s = joint_.sensor;
    const double x = (reading - s.position_offset) / s.position_scale / motion.joint.reading_ratio();
    motion.y = steady.y;
    for (int i = 0; i < motion.joint.bodies(); ++i) motion.y[i] += x;
    motion.joint.arriving = steady.command;
    motion.enter();
    controller_.begin(reading, steady.command);
    ticks_ = 0;
    return std::isfinite(x);
}

bool SampledLoop::begin_slower(double share)
{
    if (!begin_steadily()) return false;
    auto& j = motion.joint;
    const double full = steady_command_, V0 = j.frame();
    const auto steady = j.steady(std::max(share, slowest) * V0);
    if (!std::isfinite(steady.command)) return false;
    const double v = share * frame_reading_;
    // the controller sees an estimate of this share of V_0
    const double lag_behind = joint_.control.k_v * (frame_reading_ - v);
    const double reading = controller_.steady_reading(steady.command - lag_behind);
    const double was = controller_.state.reading;
    const double per_reading = 1 / (joint_.sensor.position_scale * j.reading_ratio());
    const double clock = j.has_clock() ? j.clock(motion.y.data()) : 0, x0 = motion.y[j.measured()];
    motion.y = steady.y;
    for (int i = 0; i < j.bodies(); ++i) {
        motion.y[i] += x0 + (reading - was) * per_reading;
        if (share == 0) j.set_velocity(motion.y.data(), i, 0);
    }
    if (j.has_clock()) j.clock(motion.y.data()) = clock;
    std::fill(line_.begin(), line_.end(), steady.command);
    j.arriving = steady.command;
    controller_.begin(reading, steady.command);
    controller_.state.velocity = controller_.state.before = v;
    auto& w = controller_.state.window;
    for (std::size_t i = 0; i < w.size(); ++i)  // where it was before, in a frame that moves faster
        w[i] = reading + (frame_reading_ - v) * period_ * static_cast<double>(w.size() - 1 - i);
    motion.enter();
    steady_command_ = full;
    return true;
}

void SampledLoop::displace(double x)
{
    for (int i = 0; i < motion.joint.bodies(); ++i) motion.y[i] += x;
    for (double& reading : controller_.state.window)
        reading += joint_.sensor.position_scale * motion.joint.reading_ratio() * x;
}

bool SampledLoop::begin_sliding(double reading, double rate)
{
    auto& j = motion.joint;
    const double per_reading = 1 / (joint_.sensor.position_scale * j.reading_ratio());
    const auto steady = j.steady(rate * per_reading);
    steady_command_ = steady.command;
    if (!within_limits()) return false;
    // the reference stands at `reading`: the joint hangs behind it by what the controller needs
    const double lost = joint_.control.reference_velocity ? 0 : joint_.control.k_v * rate;
    const double now = reading + controller_.steady_reading(steady.command + lost);
    std::fill(line_.begin(), line_.end(), steady.command);
    motion.y = steady.y;
    const double x = (now - joint_.sensor.position_offset) * per_reading;
    for (int i = 0; i < j.bodies(); ++i) motion.y[i] += x;
    j.arriving = steady.command;
    motion.enter();
    controller_.begin(now, steady.command);
    controller_.state.velocity = controller_.state.before = rate;
    auto& w = controller_.state.window;
    for (std::size_t i = 0; i < w.size(); ++i) w[i] = now - rate * period_ * static_cast<double>(w.size() - i);
    ticks_ = 0;
    return std::isfinite(x);
}

void SampledLoop::begin_at_rest(double reading)
{
    const auto& s = joint_.sensor;
    motion.y = motion.joint.at_rest((reading - s.position_offset) / s.position_scale / motion.joint.reading_ratio());
    std::fill(line_.begin(), line_.end(), 0);
    motion.joint.arriving = 0;
    motion.enter();
    ticks_ = 0;
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
    const double exact = joint_.sensor.position_scale * j.reading_ratio() * j.velocity(motion.y.data(), j.measured());
    readings_.position = read();
    controller_.read(readings_.position, period_, exact);
    std::copy(line_.begin() + 1, line_.end(), line_.begin());
    line_.back() = controller_.command(reference, rate, added);
    motion.joint.arriving = line_.front();
    motion.enter();
    readings_.velocity = controller_.state.velocity;
    readings_.command = line_.back();
    readings_.effort = j.effort(motion.y.data());
    if (options_.seed != 0 && !options_.ideal_encoder) readings_.effort += joint_.sensor.effort_noise * noise_();
}

std::vector<double> SampledLoop::state() const
{
    std::vector<double> all(motion.y.begin(), motion.y.begin() + motion.joint.size());
    const auto& c = controller_.state;
    all.insert(all.end(), c.window.begin(), c.window.end());
    all.push_back(c.velocity);
    if (controller_.continuous()) all.push_back(c.before), all.push_back(c.output);
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
    if (controller_.continuous()) controller_.state.before = *next++, controller_.state.output = *next++;
    take(line_.begin() + 1, line_.end());
    controller_.state.fresh = false;
}

}  // namespace stickslip
