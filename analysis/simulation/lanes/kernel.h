// The lanes themselves: packs of joints stepped side by side, each lane with its own time and step size, refilled from
// the jobs as it falls free. Compiled once for each instruction set; its templates differ by width, so that no object
// file can lend its instructions to another.
#pragma once
#include "analysis/simulation/lanes/program.h"
#include "analysis/simulation/lanes/rosenbrock.h"

namespace stickslip::lanes {

template <int width, int count>
class Kernel {
    using P = Pack<width, count>;
    using M = Mask<width, count>;
    static constexpr int lanes = P::lanes;
    static constexpr double longest_step = 1e30;

  public:
    Kernel(const Job* jobs, Answer* answers, std::size_t job_count, const Settings& settings)
        : jobs_(jobs), answers_(answers), job_count_(job_count), settings_(settings)
    {
    }

    void run()
    {
        for (int i = 0; i < lanes; ++i) fill(i);
        moving_ = always_;
        for (long round = 0; busy_ > 0; ++round) {
            step();
            if (round % 64 == 63) retire_endless();
        }
    }

  private:
    void step()
    {
        const P room = end_time_ - t_;
        const P h = min(h_, room);
        PackedStep<P> s;
        rodas5p_step(groups_, y_, h, s);
        const P error = scaled_error(s);
        const M accepted = (error <= P(1.0)) & active_;
        const M events = accepted & watch(h, room, s);
        if (any(events)) {
            for (int i = 0; i < lanes; ++i)
                if (events[i]) handle(i, h, s);
        }
        // a lane that restarts has its new state in place already and does not take this step
        const M taken = accepted & moving_;
        w_before_ = select(taken, y_.w, w_before_);
        h_before_ = select(taken, h, h_before_);
        y_.X = select(taken, s.end.X, y_.X);
        y_.w = select(taken, s.end.w, y_.w);
        y_.p = select(taken, s.end.p, y_.p);
        t_ = select(taken, t_ + h, t_);
        steps_ = steps_ + 1.0;
        h_ = select(moving_, h * next_factor(error, accepted), h_);
        moving_ = always_;
    }

    P scaled_error(const PackedStep<P>& s) const
    {
        const auto ratio = [&](const P& e, const P& floor, const P& before, const P& after) {
            return abs(e) / (rtol_ * (floor + max(abs(before), abs(after))));
        };
        const P x = ratio(s.error().X, floor_.X, y_.X, s.end.X), w = ratio(s.error().w, floor_.w, y_.w, s.end.w),
                p = ratio(s.error().p, floor_.p, y_.p, s.end.p);
        // a NaN must not pass: it fails every comparison, and 1e40 takes its place
        const P largest = max(max(x, w), p);
        return select((x <= P(1e30)) & (w <= P(1e30)) & (p <= P(1e30)), largest, P(1e40));
    }

    P next_factor(const P& error, const M& accepted) const
    {
        P factor = P(0.87) * rough_power(max(error, P(1e-12)));
        factor = max(min(factor, P(5.0)), P(0.2));
        factor = select(error <= P(1e30), factor, P(0.1));
        return select(accepted, factor, min(factor, P(0.9)));
    }

    /// Lanes whose step is of interest to their program.
    M watch(const P& h, const P& room, const PackedStep<P>& s) const
    {
        const P zero(0.0), slow(near_rest_logarithm), small(settled_size);
        const M time = room <= h;
        const M section = ((zero < y_.w) & (s.end.w <= zero)) | ((y_.w <= zero) & (zero < s.end.w));
        const M resting = ((slow < y_.w) & (s.end.w <= slow)) | ((y_.w <= slow) & (slow < s.end.w));
        const M turning = (s.end.w - y_.w) * (y_.w - w_before_) < zero;
        const M settled =
            (abs(s.end.X) * groups_.K < small) & (abs(s.end.w) < small) & (abs(s.end.p) < small) & searching_;
        return time | ((section | resting | turning) & turning_phase_) | settled;
    }

    void handle(int i, const P& h, const PackedStep<P>& s)
    {
        StepView view;
        view.t = t_[i];
        view.h = h[i];
        view.y0[0] = y_.X[i], view.y0[1] = y_.w[i], view.y0[2] = y_.p[i];
        view.y1[0] = s.end.X[i], view.y1[1] = s.end.w[i], view.y1[2] = s.end.p[i];
        for (int j = 0; j < rodas5p::stages; ++j)
            view.U[j][0] = s.U[j].X[i], view.U[j][1] = s.U[j].w[i], view.U[j][2] = s.U[j].p[i];
        view.w_before = w_before_[i];
        view.h_before = h_before_[i];
        EventFlags flags;
        const double w0 = view.y0[1], w1 = view.y1[1];
        flags.time = end_time_[i] - view.t <= view.h;
        flags.section = (w0 > 0) != (w1 > 0);
        flags.slow = (w0 > near_rest_logarithm) != (w1 > near_rest_logarithm);
        flags.turning = (w1 - w0) * (w0 - view.w_before) < 0;
        flags.settled = size_below(view.y1, i);
        carry_out(i, programs_[i].handle(view, flags));
    }

    bool size_below(const double y[3], int i) const
    {
        const auto small = [](double x) { return x < settled_size && x > -settled_size; };
        return small(y[0] * groups_.K[i]) && small(y[1]) && small(y[2]);
    }

    void carry_out(int i, const Action& action)
    {
        if (action.kind == Action::Kind::carry_on) return;
        if (action.kind == Action::Kind::finished) {
            answers_[number_[i]] = programs_[i].answer();
            answers_[number_[i]].steps = static_cast<long>(steps_[i]) + 1;
            --busy_;
            fill(i);
            return;
        }
        place(i, action);
    }

    /// Takes the next job into lane i, or leaves it idle on a harmless problem.
    void fill(int i)
    {
        const bool more = next_ < job_count_;
        active_.set(i, more);
        steps_.set(i, 0);
        static constexpr Job idle{{1, 1, 1, 0}, {0, 0, 0}, {{0, 0}, {1, 0}, {0, 0}}, 1e300, 1, -1, 1, false, {0, 0, 0}};
        const Job& job = more ? jobs_[next_] : idle;
        if (more) {
            number_[i] = next_++;
            ++busy_;
        }
        groups_.K.set(i, job.groups.K);
        groups_.per_M.set(i, 1 / job.groups.M);
        groups_.beta.set(i, job.groups.beta);
        groups_.c.set(i, job.groups.c);
        place(i, programs_[i].begin(job, settings_));
    }

    void place(int i, const Action& start)
    {
        const auto& program = programs_[i];
        y_.X.set(i, start.y[0]);
        y_.w.set(i, start.y[1]);
        y_.p.set(i, start.y[2]);
        t_.set(i, 0);
        h_.set(i, start.h);
        w_before_.set(i, start.y[1]);
        h_before_.set(i, 1);
        end_time_.set(i, program.end_time());
        rtol_.set(i, program.tolerance());
        double floor[3];
        program.floors(floor);
        floor_.X.set(i, floor[0]);
        floor_.w.set(i, floor[1]);
        floor_.p.set(i, floor[2]);
        turning_phase_.set(i, program.phase() != Phase::grow);
        searching_.set(i, program.phase() == Phase::search);
        moving_.set(i, false);
    }

    /// Gives up what would never end: a step size that went to zero or to nothing, or too many steps.
    void retire_endless()
    {
        for (int i = 0; i < lanes; ++i) {
            if (!active_[i]) {
                h_.set(i, 1e-3);
                continue;
            }
            const bool alive = h_[i] > 1e-13 * (t_[i] > 1e-3 ? t_[i] : 1e-3) && steps_[i] < settings_.step_limit;
            if (!alive) carry_out(i, programs_[i].give_up());
        }
        moving_ = always_;
    }

    static M all_on()
    {
        M mask;
        for (int i = 0; i < lanes; ++i) mask.set(i, true);
        return mask;
    }

    const Job* jobs_;
    Answer* answers_;
    std::size_t job_count_, next_ = 0;
    Settings settings_;
    int busy_ = 0;
    PackedGroups<P> groups_;
    Triple<P> y_, floor_;
    P t_, h_, rtol_, end_time_, w_before_, h_before_, steps_;
    const M always_ = all_on();
    M active_ = always_, turning_phase_ = always_, searching_ = always_, moving_ = always_;
    Program programs_[lanes];
    std::size_t number_[lanes] = {};
};

}  // namespace stickslip::lanes
