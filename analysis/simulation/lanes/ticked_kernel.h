// The lanes of sampled loops: each lane moves its joint from tick to tick with its own clock and step size, and is
// refilled from the jobs as it falls free. As in kernel.h templates differ by width between instruction sets.
#pragma once
#include "analysis/simulation/flows/near_rest.h"
#include "analysis/simulation/lanes/ticked_model.h"
#include "analysis/simulation/lanes/ticked_program.h"

namespace stickslip::lanes {

template <template <class> class Model, int width, int count>
class TickedKernel {
    using P = Pack<width, count>;
    using M = Mask<width, count>;
    using Equations = Model<P>;
    using State = typename Equations::State;
    using Step = PackedStep<State>;
    static constexpr int lanes = P::lanes, size = Equations::size;

  public:
    TickedKernel(const TickedJob* jobs, std::size_t job_count) : jobs_(jobs), job_count_(job_count) {}

    void run()
    {
        for (int i = 0; i < lanes; ++i) fill(i);
        for (long round = 0; busy_ > 0; ++round) {
            step();
            if (round % 64 == 63) retire_endless();
        }
    }

  private:
    void step()
    {
        const M last = left_ * P(1 - 1e-9) <= h_;
        const P h = select(last, left_, select(left_ < 2.0 * h_, 0.5 * left_, h_));
        Step s;
        rodas5p_step(equations_, Equations::state(y_), h, s);
        const P error = scaled_error(s);
        const M accepted = (error <= P(1.0)) & active_;
        const P w0 = y_[1], w1 = s.end.w, near(near_rest_logarithm), zero(0.0);
        const P rise = w1 - w0, at_start = rise + weighted(s, 1, dense_at_start);
        const P at_end = rise - weighted(s, 1, dense_at_end);
        const M slow0 = w0 <= near, slow1 = w1 <= near, above0 = zero < w0, above1 = zero < w1;
        const M events = accepted & ((at_start * at_end < zero) | (slow0 ^ slow1) | (above0 ^ above1));
        const M quiet = accepted & ~events;
        if (any(events)) tell(events, h, s);
        rest_ = select(events, zero, select(quiet & slow0 & slow1, rest_ + h, rest_));
        w_low_ = select(events, w1, select(quiet, min(w_low_, w1), w_low_));
        w_high_ = select(events, w1, select(quiet, max(w_high_, w1), w_high_));
        for (int k = 0; k < size; ++k) y_[k] = select(accepted, part(s.end, k), y_[k]);
        t_ = select(accepted, t_ + h, t_);
        left_ = select(accepted, left_ - h, left_);
        // ticks are alike: the next one begins with the step that this one began with
        const P grown = h * next_factor(error, accepted);
        first_ = select(accepted & at_first_, grown, first_);
        at_first_ = at_first_ & ~accepted;
        h_ = grown;
        tries_ = tries_ + 1.0;
        const M arrived = accepted & last;
        if (any(arrived)) {
            for (int i = 0; i < lanes; ++i)
                if (arrived[i]) arrive(i);
        }
    }

    /// What the slopes of the dense output take at the start and at the end of a step: k_0, k_0 + k_1 + k_2.
    static constexpr rodas5p::Row dense_at_start = rodas5p::dense[0], dense_at_end = [] {
        rodas5p::Row sum{};
        for (int r = 0; r < 3; ++r)
            for (int j = 0; j < rodas5p::stages; ++j) sum[j] += rodas5p::dense[r][j];
        return sum;
    }();

    [[gnu::always_inline]] static P weighted(const Step& s, int k, const rodas5p::Row& weights)
    {
        P sum(0.0);
        for (int j = 0; j < rodas5p::stages; ++j) sum = sum + P(weights[j]) * part(s.U[j], k);
        return sum;
    }

    void tell(const M& events, const P& h, const Step& s)
    {
        P X[3], w[3];
        for (int r = 0; r < 3; ++r) X[r] = weighted(s, 0, rodas5p::dense[r]), w[r] = weighted(s, 1, rodas5p::dense[r]);
        for (int i = 0; i < lanes; ++i) {
            if (!events[i]) continue;
            const TickedStep step{t_[i],
                                  h[i],
                                  y_[0][i],
                                  part(s.end, 0)[i],
                                  {X[0][i], X[1][i], X[2][i]},
                                  y_[1][i],
                                  s.end.w[i],
                                  {w[0][i], w[1][i], w[2][i]}};
            programs_[i].event(step, passed(i));
        }
    }

    P scaled_error(const Step& s) const
    {
        P largest(0.0);
        M finite = always_;
        for (int k = 0; k < size; ++k) {
            const P ratio = abs(part(s.error(), k)) / (rtol_ * (P(1.0) + max(abs(y_[k]), abs(part(s.end, k)))));
            finite = finite & (ratio <= P(1e30));
            largest = max(largest, ratio);
        }
        // a NaN must not pass: it fails every comparison, and 1e40 takes its place
        return select(finite, largest, P(1e40));
    }

    static P next_factor(const P& error, const M& accepted)
    {
        P factor = P(0.87) * rough_power(max(error, P(1e-12)));
        factor = max(min(factor, P(5.0)), P(0.2));
        factor = select(error <= P(1e30), factor, P(0.1));
        return select(accepted, factor, min(factor, P(0.9)));
    }

    TickedPassage passed(int i) const { return {w_low_[i], w_high_[i], rest_[i]}; }

    void arrive(int i)
    {
        double y[4] = {0, 0, 0, 0};
        for (int k = 0; k < size; ++k) y[k] = y_[k][i];
        TickedPiece next;
        if (programs_[i].arrive(y, passed(i), next)) return place(i, next);
        --busy_;
        fill(i);
    }

    /// Takes the next job into lane i, past those that need no motion, or leaves it idle on a harmless problem.
    void fill(int i)
    {
        TickedJoint joint;
        TickedPiece first;
        bool found = false;
        while (!found && next_ < job_count_) found = programs_[i].begin(jobs_[next_++], joint, first);
        if (found)
            ++busy_;
        else
            joint = {}, first = {};
        active_.set(i, found);
        auto& g = equations_;
        g.K.set(i, 0), g.per_M.set(i, 1 / joint.M), g.friction.set_beta(i, joint.beta);
        equations_.set_lag(i, joint.lag);
        first_.set(i, 0.05 * first.length);
        place(i, first);
    }

    void place(int i, const TickedPiece& piece)
    {
        for (int k = 0; k < size; ++k) y_[k].set(i, piece.y[k]);
        equations_.force.set(i, piece.force), equations_.c.set(i, piece.drag);
        rtol_.set(i, piece.rtol);
        t_.set(i, 0), left_.set(i, piece.length), h_.set(i, first_[i]);
        w_low_.set(i, piece.y[1]), w_high_.set(i, piece.y[1]), rest_.set(i, 0);
        at_first_.set(i, true), tries_.set(i, 0);
    }

    /// Gives up a piece that would never end: a step that went to zero or to nothing, or too many steps.
    void retire_endless()
    {
        constexpr double most_tries = 20'000;
        for (int i = 0; i < lanes; ++i) {
            if (!active_[i]) {
                left_.set(i, 1), h_.set(i, 0.05);
                continue;
            }
            const bool alive = h_[i] > 1e-14 * left_[i] && tries_[i] < most_tries;
            if (alive) continue;
            --busy_;
            fill(i);
        }
    }

    static M all_on()
    {
        M mask;
        for (int i = 0; i < lanes; ++i) mask.set(i, true);
        return mask;
    }

    const TickedJob* jobs_;
    std::size_t job_count_, next_ = 0;
    int busy_ = 0;
    Equations equations_;
    P y_[size], t_, left_, h_, first_, rtol_, w_low_, w_high_, rest_, tries_;
    const M always_ = all_on();
    M active_ = always_, at_first_ = always_;
    TickedProgram programs_[lanes];
};

}  // namespace stickslip::lanes
