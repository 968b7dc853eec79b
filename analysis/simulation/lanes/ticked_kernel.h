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
        P X_dense[3], w_dense[3];
        for (int r = 0; r < 3; ++r) dense(s, r, X_dense[r], w_dense[r]);
        const P rise = w1 - w0, at_start = rise + w_dense[0];
        const P at_end = rise - (w_dense[0] + w_dense[1] + w_dense[2]);
        const M slow0 = w0 <= near, slow1 = w1 <= near, above0 = zero < w0, above1 = zero < w1;
        const M events = accepted & ((at_start * at_end < zero) | (slow0 ^ slow1) | (above0 ^ above1));
        const M quiet = accepted & ~events;
        if (any(events)) {
            for (int i = 0; i < lanes; ++i) {
                if (!events[i]) continue;
                programs_[i].event({t_[i],
                                    h[i],
                                    y_[0][i],
                                    part(s.end, 0)[i],
                                    {X_dense[0][i], X_dense[1][i], X_dense[2][i]},
                                    w0[i],
                                    w1[i],
                                    {w_dense[0][i], w_dense[1][i], w_dense[2][i]}},
                                   passed(i));
            }
        }
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

    /// k_r of the dense output, of X and w.
    [[gnu::always_inline]] static void dense(const Step& s, int r, P& X, P& w)
    {
        X = P(0.0), w = P(0.0);
        for (int j = 0; j < rodas5p::stages; ++j) {
            const P weight(rodas5p::dense[r][j]);
            X = X + weight * part(s.U[j], 0), w = w + weight * s.U[j].w;
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
        g.K.set(i, 0), g.per_M.set(i, 1 / joint.M), g.beta.set(i, joint.beta);
        equations_.set_lag(i, joint.lag);
        rtol_.set(i, joint.rtol);
        first_.set(i, 0.05 * first.length);
        place(i, first);
    }

    void place(int i, const TickedPiece& piece)
    {
        for (int k = 0; k < size; ++k) y_[k].set(i, piece.y[k]);
        equations_.force.set(i, piece.force), equations_.c.set(i, piece.drag);
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
