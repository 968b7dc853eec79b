// A smooth law as the kernel steps it: Rodas5P, events from the measure w of speed, which is 0 at V_0.
#pragma once
#include "analysis/simulation/lanes/lane_program.h"
#include "analysis/simulation/lanes/rosenbrock.h"

namespace stickslip::lanes {

/// What a displacement of the k-th unknown counts; the others count as they are.
template <class Equations>
[[gnu::always_inline]] inline auto stiffness_of(const Equations& g, int k)
{
    using P = std::remove_cvref_t<decltype(g.K)>;
    return k == 0 ? g.K : P(1.0);
}

/// `Equations` have rate(), eliminate() and at_state() (rosenbrock.h), the numbers of each lane's job, and the level of
/// w below which the mass counts as standing.
template <class P, class Equations>
class RosenbrockModel {
    using M = typename P::MaskType;
    using State = typename Equations::State;

  public:
    using Job = typename Equations::Job;
    using Answer = typename Equations::Answer;
    using Program = typename Equations::Program;
    static constexpr int size = Equations::size;  ///< X, w, states

    class Step {
      public:
        P end(int k) const { return part(packed.end, k); }
        P error(int k) const { return part(packed.error(), k); }
        PackedStep<State> packed;
    };

    void load(int lane, const Job& job) { equations_.load(lane, job.groups); }
    static constexpr Job idle() { return Equations::idle(); }

    void start(int lane, const double* y)
    {
        w_before_.set(lane, y[1]);
        h_before_.set(lane, 1);
    }
    void step(const P* y, const P& h, Step& s) const { rodas5p_step(equations_, Equations::state(y), h, s.packed); }
    void remember(const M& taken, const P* y, const P& h)
    {
        w_before_ = select(taken, y[1], w_before_);
        h_before_ = select(taken, h, h_before_);
    }

    M events(const P* y, const Step& s) const
    {
        const P zero(0.0), slow(Equations::slow), w = y[1], end = s.end(1);
        const M section = ((zero < w) & (end <= zero)) | ((w <= zero) & (zero < end));
        const M resting = ((slow < w) & (end <= slow)) | ((w <= slow) & (slow < end));
        const M turning = (end - w) * (w - w_before_) < zero;
        return section | resting | turning;
    }
    M settled(const Step& s, const P& small) const
    {
        M all = abs(s.end(0)) * stiffness_of(equations_, 0) < small;
        for (int k = 1; k < size; ++k) all = all & (abs(s.end(k)) * stiffness_of(equations_, k) < small);
        return all;
    }

    /// What the program of one lane sees of a step.
    void look(int i, const Step& s, StepView& view) const
    {
        for (int j = 0; j < rodas5p::stages; ++j)
            for (int k = 0; k < size; ++k) view.U[j][k] = part(s.packed.U[j], k)[i];
        view.w_before = w_before_[i];
        view.h_before = h_before_[i];
    }
    EventFlags flags(const StepView& view, int i, double settled) const
    {
        EventFlags flags;
        const double w0 = view.y0[1], w1 = view.y1[1], slow = Equations::slow;
        flags.section = (w0 > 0) != (w1 > 0);
        flags.slow = (w0 > slow) != (w1 > slow);
        flags.turning = (w1 - w0) * (w0 - view.w_before) < 0;
        const auto small = [settled](double x) { return x < settled && x > -settled; };
        flags.settled = true;
        for (int k = 0; k < size; ++k)
            flags.settled = flags.settled && small(view.y1[k] * stiffness_of(equations_, k)[i]);
        return flags;
    }

  private:
    Equations equations_;
    P w_before_, h_before_;
};

}  // namespace stickslip::lanes
