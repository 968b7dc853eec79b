// A whole joint in its loop, tick by tick: encoder, controller, hold, dead time, actuator, mechanism. A continuous loop
// has ticks of its own, short beside everything that it does.
#pragma once
#include "analysis/numerics/seeded_noise.h"
#include "analysis/simulation/sampled/closed_loop/loop_controller.h"
#include "analysis/simulation/sampled/plant/driven_motion.h"

#include <string_view>
#include <vector>

namespace stickslip {

struct LoopOptions {
    MotionOptions motion;
    std::uint64_t seed = 0;      ///< of the noise; 0: none
    double tick = missing;       ///< s, of a continuous loop; not set: tick_of()
    bool ideal_encoder = false;  ///< leaves out quantum and noise, which leave no steady state
    bool readings = true;        ///< of velocity and effort, for records; off: those that the controller needs
};

/// The period of the loop; of a continuous one, ticks short enough beside all that it does.
double tick_of(const Joint& joint);
/// Why some joints cannot be simulated: a joint of extreme numbers.
inline constexpr std::string_view no_time_step =
    "the fastest rate of the joint leaves no time step that the simulation can take";

/// What one tick read and commanded. Where readings come late, the loop lives at the moment that is read: all dead time
/// lies behind the command, and the effort beside a reading is that of `ticks_late()` ticks later.
struct TickReadings {
    double position = 0, velocity = 0, command = 0, effort = 0;
};

class SampledLoop {
  public:
    /// In a frame that moves at F with the joint [joint side]; `speed` is the scale of its velocities.
    SampledLoop(const Joint& joint, double frame, double speed, LoopSide side, const LoopOptions& options);

    /// Slides steadily, or false where the loop has no steady sliding.
    bool begin_steadily();
    /// Slides at this share of V_0 instead, forces balanced, from where V_0 is commanded; 0: rests where the law can,
    /// with the effort of V_0 where limits leave too little for slower sliding.
    bool begin_slower(double share);
    /// Slides steadily with the reference at `reading` and moving at `rate`: for laws that cannot rest. In a frame at
    /// rest.
    bool begin_sliding(double reading, double rate);
    /// Rests at this reading, nothing commanded yet.
    void begin_at_rest(double reading);
    /// Rests there, this commanded for ever by a controller that integrates.
    void begin_holding(double reading, double command);

    /// Moves all bodies, and the readings so far, by this much [joint side]: a step of the commanded position.
    void displace(double x);

    /// One tick under a reference [reading units, in the frame] and its velocity [not in the frame]; the command that
    /// it gives, and what is added to it, arrives after the dead time. False where the motion could not be followed.
    template <class Observer>
    bool tick(double reference, double rate, double added, Observer&& observe);
    bool tick()
    {
        return tick(0, frame_reading_, 0, [](const DrivenStep&) {});
    }

    /// A tick in pieces, for who moves `motion` himself: asks the controller, and the length of the first piece, over
    /// which what arrives is held; then that of the next, 0 where the tick is over.
    double open_tick();
    double next_piece();

    /// Everything that the next ticks depend on, as one vector: mechanism, controller, commands on their way.
    std::vector<double> state() const;
    void set_state(const std::vector<double>& state);

    /// What time the controller has, for its dither, and what time it is for what depends on time.
    void set_clock(double controller, double t);
    /// The motion about a steady state becomes this many times as large, its past included.
    void scale_about(const std::vector<double>& steady, double by);

    double period() const { return period_; }
    /// Whole ticks by which readings are late.
    long ticks_late() const { return ticks_late_; }
    double time() const { return static_cast<double>(ticks_) * period_; }
    double frame() const { return motion.joint.frame(); }
    double reference_velocity() const { return frame_reading_; }
    const TickReadings& readings() const { return readings_; }
    const LoopController& controller() const { return controller_; }
    bool continuous() const { return controller_.continuous(); }
    /// The last entries of state(), oldest first.
    std::size_t commands_on_the_way() const { return line_.size() - 1; }
    std::size_t taps() const { return controller_.state.window.size(); }
    bool integrates() const { return controller_.integrates(); }
    double integral_gain() const { return controller_.integral_gain(); }
    double stiffness() const { return std::abs(joint_.control.k_p); }
    double steady_command() const { return steady_command_; }
    bool within_limits() const;

    DrivenMotion motion;

  private:
    bool slide(double rate, double reference);
    double read();
    double measured_effort();
    void ask(double reference, double rate, double added);
    template <class Observer>
    bool move(Observer&& observe);

    Joint joint_;
    LoopOptions options_;
    SeededNoise noise_;
    double period_, frame_reading_;
    LoopController controller_;
    std::vector<double> line_;  ///< commands on their way, oldest first; the last is that of the present tick
    double delayed_part_ = 0;   ///< of the tick, in which the command before the oldest still holds
    long ticks_late_ = 0;
    double reading_part_ = 0;  ///< of the tick by which readings are late beyond whole ones
    bool in_delayed_part_ = false;
    long ticks_ = 0;
    double clock_ = 0;  ///< of the controller at its first tick
    double steady_command_ = missing;
    TickReadings readings_;
};

template <class Observer>
bool SampledLoop::tick(double reference, double rate, double added, Observer&& observe)
{
    ask(reference, rate, added);
    const bool moved = move(observe);
    ++ticks_;
    return moved;
}

template <class Observer>
bool SampledLoop::move(Observer&& observe)
{
    const double t = time(), early = delayed_part_ * period_, logged = reading_part_ * period_;
    bool moved = true;
    double from = 0;
    const auto advance = [&](double to) {
        if (moved && to > from) moved = motion.advance(t + from, to - from, observe);
        from = to;
    };
    const auto log_effort = [&] { advance(logged), readings_.effort = measured_effort(); };
    if (logged > 0 && logged < early) log_effort();
    if (early > 0) {
        advance(early);
        motion.joint.arriving = line_[1];
        motion.enter();
    }
    if (logged > 0 && logged >= early) log_effort();
    advance(period_);
    return moved;
}

}  // namespace stickslip
