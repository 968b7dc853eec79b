// Delayed friction, f(t) = f_ss(V(t − τ)), by the method of steps: over less than a lag the delayed friction is
// a known function of time, and the motion a flow like any other.
#pragma once
#include "analysis/results/detail.h"
#include "analysis/simulation/flows/chain_flow.h"
#include "analysis/simulation/flows/mode.h"
#include "analysis/simulation/flows/past_speeds.h"

#include <array>

namespace stickslip {

/// A chain of one to three bodies, some with a time lag on their friction. y is that of the chain and, last, the time
/// itself. The lag delays the level of the friction; its direction is that of the present motion, as in the model of
/// Armstrong-Hélouvry, Dupont & Canudas de Wit, Automatica 30 (1994), so that a body may turn back, and at rest a body
/// holds what its static friction allows. The flow carries the past of one motion: each motion needs a copy.
class DelayedFlow final : public SwitchingFlow {
  public:
    explicit DelayedFlow(ChainFlow chain);

    const ChainFlow& chain() const { return chain_; }
    double V0 = not_set;

    int size() const override { return chain_.size() + 1; }
    FlowVector steady() const override { return with_clock(chain_.steady(), 0); }
    FlowVector scale() const override { return with_clock(chain_.scale(), past_.longest_lag()); }
    void rate(const FlowVector& y, FlowVector& rate) const override;
    void jacobian(const FlowVector& y, FlowMatrix& jacobian) const override;
    double velocity(const FlowVector& y) const override { return chain_.velocity(y); }
    double position(const FlowVector& y) const override { return chain_.position(y); }
    double speed_measure(const FlowVector& y) const override { return chain_.speed_measure(y); }
    FlowVector speed_gradient(const FlowVector& y) const override { return with_clock(chain_.speed_gradient(y), 0); }
    double commanded_velocity() const override { return chain_.commanded_velocity(); }
    bool logarithmic_speed() const override { return chain_.logarithmic_speed(); }
    void surround(double d, double normal_load) override { chain_.surround(d, normal_load); }
    std::unique_ptr<Flow> with_gain(double k_p) const override;
    double gain() const override { return chain_.gain(); }
    double wind_up_time() const override { return chain_.wind_up_time(); }
    std::unique_ptr<Flow> copy() const override { return std::make_unique<DelayedFlow>(*this); }

    int switches() const override { return chain_.switches(); }
    void switch_values(const FlowVector& y, double* values) const override;
    void enter(FlowVector& y) override;
    void pass(int which, FlowVector& y) override;
    bool anything_rests() const override { return chain_.anything_rests(); }
    bool link_stuck() const { return chain_.link_stuck(); }
    double link_friction(const FlowVector& y) const { return chain_.link_friction(y, friction_at(clock(y))); }

    // The past of the motion.
    double clock(const FlowVector& y) const { return y[chain_.size()]; }
    /// Begins a motion at y, after steady sliding for ever.
    void begin(FlowVector& y);
    /// Makes ready for a step from y and says by when it must end: the past that it needs must be known and smooth.
    double step_limit(const FlowVector& y);
    /// Takes a step into the past; `at` is the state within it.
    template <class At>
    void remember(const FlowVector& from, const FlowVector& to, const At& at);
    /// The velocity of some body has a kink now, and its friction a lag later.
    void note_kink(const FlowVector& y) { past_.note_kink(clock(y)); }

    /// Of the delayed bodies: a_i of v̇_i(t) = … + a_i v_i(t − τ_i) about steady sliding.
    double delayed_rate(int i) const;
    double lag(int i) const { return past_.lag(i); }
    double longest_lag() const { return past_.longest_lag(); }
    const SpeedHistory& history(int i) const { return past_.history(i); }

  private:
    FlowVector with_clock(const FlowVector& y, double clock) const;
    /// What the bodies' friction resists, and its change in time.
    DelayedForces friction_at(double clock) const;
    DelayedForces friction_rate_at(double clock) const;
    PastSpeeds::Speeds steady_speeds() const;

    ChainFlow chain_;
    PastSpeeds past_;
};

template <class At>
void DelayedFlow::remember(const FlowVector& from, const FlowVector& to, const At& at)
{
    const double t0 = clock(from), t1 = clock(to);
    if (!(t1 > t0)) return;
    const std::array<FlowVector, 5> y = {from, at(0.25), at(0.5), at(0.75), to};
    for (int i = 0; i < chain_.bodies; ++i) {
        if (lag(i) == 0) continue;
        SpeedHistory::Step step{t0, t1, {}};
        for (std::size_t k = 0; k < y.size(); ++k) step.velocity[k] = chain_.velocity(y[k], i);
        past_.append(i, step);
    }
}

/// The flow of a joint some of whose bodies are delayed; nothing if none does.
struct DelayedOrReason {
    DelayedFlow flow;
    Reason reason = Reason::none;
};
bool has_delayed_friction(const Joint& joint);

/// Why a joint of the ideal loop is `unsupported`: it has no flow, delayed or not.
Detail why_no_flow(const Joint& joint);
DelayedOrReason delayed_flow(const Joint& joint);

/// The rightmost root of the characteristic equation with its null vectors.
SlowMode slow_mode(const DelayedFlow& flow);
double default_size(const DelayedFlow& flow, const SlowMode& mode, DisturbanceKind kind);
/// As for a chain. One body has no state that could balance an offset: `position` and `velocity` change nothing else.
FlowVector disturbed(const DelayedFlow& flow, const SlowMode& mode, DisturbanceKind kind, double size);
void push(const DelayedFlow& flow, FlowVector& y, double impulse);

/// As measure_growth of a flow, with the memory of the motion in the projection on the mode.
double measure_growth(const DelayedFlow& flow, const SlowMode& mode, const FlowVector& probe);

}  // namespace stickslip
