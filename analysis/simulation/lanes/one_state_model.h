// A rate-and-state law with one state as the kernel steps it: Rodas5P, events from ln V.
#pragma once
#include "analysis/simulation/lanes/lane_program.h"
#include "analysis/simulation/lanes/rosenbrock.h"

namespace stickslip::lanes {

template <class P, template <class> class Friction>
class OneStateModel {
    using M = typename P::MaskType;

  public:
    using Job = lanes::Job;
    using Answer = lanes::Answer;
    using Program = lanes::Program;
    static constexpr int size = 3;  ///< X, w, p

    class Step {
      public:
        P end(int k) const { return part(packed.end, k); }
        P error(int k) const { return part(packed.error(), k); }
        PackedStep<Triple<P>> packed;
    };

    void load(int lane, const Job& job)
    {
        groups_.K.set(lane, job.groups.K);
        groups_.per_M.set(lane, 1 / job.groups.M);
        groups_.friction.set_beta(lane, job.groups.beta);
        groups_.c.set(lane, job.groups.c);
    }
    /// A harmless problem for a lane without a job.
    static constexpr Job idle() { return {{1, 1, 1, 0}, -1, 1, true, {0, 0, 0}, false, {0, 0, 0}}; }

    void start(int lane, const double* y)
    {
        w_before_.set(lane, y[1]);
        h_before_.set(lane, 1);
    }
    void step(const P* y, const P& h, Step& s) const
    {
        rodas5p_step(groups_, Triple<P>{y[0], y[1], y[2]}, h, s.packed);
    }
    void remember(const M& taken, const P* y, const P& h)
    {
        w_before_ = select(taken, y[1], w_before_);
        h_before_ = select(taken, h, h_before_);
    }

    M events(const P* y, const Step& s) const
    {
        const P zero(0.0), slow(near_rest_logarithm), w = y[1], end = s.end(1);
        const M section = ((zero < w) & (end <= zero)) | ((w <= zero) & (zero < end));
        const M resting = ((slow < w) & (end <= slow)) | ((w <= slow) & (slow < end));
        const M turning = (end - w) * (w - w_before_) < zero;
        return section | resting | turning;
    }
    M settled(const Step& s, const P& small) const
    {
        return (abs(s.end(0)) * groups_.K < small) & (abs(s.end(1)) < small) & (abs(s.end(2)) < small);
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
        const double w0 = view.y0[1], w1 = view.y1[1];
        flags.section = (w0 > 0) != (w1 > 0);
        flags.slow = (w0 > near_rest_logarithm) != (w1 > near_rest_logarithm);
        flags.turning = (w1 - w0) * (w0 - view.w_before) < 0;
        const auto small = [settled](double x) { return x < settled && x > -settled; };
        flags.settled = small(view.y1[0] * groups_.K[i]) && small(w1) && small(view.y1[2]);
        return flags;
    }

  private:
    static P part(const Triple<P>& y, int k) { return k == 0 ? y.X : k == 1 ? y.w : y.p; }

    PackedGroups<P, Friction> groups_;
    P w_before_, h_before_;
};

template <class P>
using SlipModel = OneStateModel<P, SlipState>;
template <class P>
using AgeingModel = OneStateModel<P, AgeingState>;

}  // namespace stickslip::lanes
