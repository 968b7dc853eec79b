// The lanes themselves: packs of joints stepped side by side, each lane with its own time and step size, refilled from
// the jobs as it falls free. Compiled once for each instruction set; its templates differ by width, so that no object
// file can lend its instructions to another.
#pragma once
#include "analysis/simulation/lanes/functions.h"
#include "analysis/simulation/lanes/lane_program.h"

namespace stickslip::lanes {

/// `Model` holds the equations of all lanes, steps them and finds their events (one_state_model.h, stribeck_model.h).
template <template <class> class Model, int width, int count>
class Kernel {
    using P = Pack<width, count>;
    using M = Mask<width, count>;
    using Equations = Model<P>;
    using Job = typename Equations::Job;
    using Answer = typename Equations::Answer;
    using Program = typename Equations::Program;
    using Step = typename Equations::Step;
    static constexpr int lanes = P::lanes, size = Equations::size;
    static constexpr double vanished = 1e-60;  ///< a step; e-folds of speed below V_0 that no motion reaches: 138

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
        const P h = h_;
        Step s;
        equations_.step(y_, h, s);
        const P error = scaled_error(s);
        const M accepted = (error <= P(1.0)) & active_;
        const M events = accepted & (equations_.events(y_, s) | (equations_.settled(s, settled_) & may_settle_));
        if (any(events)) {
            for (int i = 0; i < lanes; ++i)
                if (events[i]) handle(i, h, s);
        }
        // a lane that restarts has its new state in place already and does not take this step
        const M taken = accepted & moving_;
        equations_.remember(taken, y_, h);
        for (int k = 0; k < size; ++k) y_[k] = select(taken, s.end(k), y_[k]);
        t_ = select(taken, t_ + h, t_);
        steps_ = steps_ + select(moving_, P(1.0), P(0.0));
        h_ = select(moving_, h * next_factor(error, accepted), h_);
        moving_ = always_;
    }

    P scaled_error(const Step& s) const
    {
        P largest(0.0);
        M finite = always_;
        for (int k = 0; k < size; ++k) {
            const P ratio = abs(s.error(k)) / (rtol_ * (floor_[k] + max(abs(y_[k]), abs(s.end(k)))));
            finite = finite & (ratio <= P(1e30));
            largest = max(largest, ratio);
        }
        // a NaN must not pass: it fails every comparison, and 1e40 takes its place
        return select(finite, largest, P(1e40));
    }

    P next_factor(const P& error, const M& accepted) const
    {
        P factor = P(0.87) * rough_power(max(error, P(1e-12)));
        factor = max(min(factor, P(5.0)), P(0.2));
        factor = select(error <= P(1e30), factor, P(0.1));
        return select(accepted, factor, min(factor, P(0.9)));
    }

    void handle(int i, const P& h, const Step& s)
    {
        typename Program::View view;
        view.t = t_[i];
        view.h = h[i];
        for (int k = 0; k < size; ++k) view.y0[k] = y_[k][i], view.y1[k] = s.end(k)[i];
        if constexpr (requires { view.steps; }) view.steps = steps_[i];
        equations_.look(i, s, view);
        carry_out(i, programs_[i].handle(view, equations_.flags(view, i, settled_[i])));
    }

    void carry_out(int i, const Action& action)
    {
        if (action.kind == Action::Kind::carry_on) return;
        if (action.kind == Action::Kind::finished) {
            answers_[number_[i]] = programs_[i].answer();
            answers_[number_[i]].steps = static_cast<long>(steps_[i]) + 1;
            if (!(steps_[i] < settings_.step_limit)) answers_[number_[i]].ending = Ending::left_over;
            --busy_;
            fill(i);
            return;
        }
        place(i, action);
        steps_.set(i, steps_[i] + 1);  // the one that was not taken
    }

    /// Takes the next job into lane i, past those that need no motion, or leaves it idle on a harmless problem.
    void fill(int i)
    {
        static constexpr Job idle = Equations::idle();
        for (; next_ < job_count_; ++next_) {
            const Action first = programs_[i].begin(jobs_[next_], settings_);
            if (first.kind == Action::Kind::finished) {
                answers_[next_] = programs_[i].answer();
                continue;
            }
            number_[i] = next_++;
            ++busy_;
            return enter(i, jobs_[number_[i]], first, true);
        }
        enter(i, idle, programs_[i].begin(idle, settings_), false);
    }

    void enter(int i, const Job& job, const Action& first, bool active)
    {
        active_.set(i, active);
        steps_.set(i, 0);
        equations_.load(i, job);
        place(i, first);
    }

    void place(int i, const Action& start)
    {
        const auto& program = programs_[i];
        double floor[size];
        program.floors(floor);
        for (int k = 0; k < size; ++k) y_[k].set(i, start.y[k]), floor_[k].set(i, floor[k]);
        equations_.start(i, start.y);
        t_.set(i, 0);
        h_.set(i, start.h);
        rtol_.set(i, program.tolerance());
        settled_.set(i, program.settled());
        may_settle_.set(i, program.phase() != Phase::cycle);
        moving_.set(i, false);
    }

    /// Gives up what would never end: a step size that went to nothing, or too many steps. Looked at now and then and
    /// not at the same steps of every job, so that what ends by itself must not be met here: a plunge towards rest
    /// takes steps of down to the speed itself and goes on, and only a step that no speed explains stays small for
    /// ever.
    void retire_endless()
    {
        for (int i = 0; i < lanes; ++i) {
            if (!active_[i]) {
                h_.set(i, 1e-3);
                continue;
            }
            const bool alive = h_[i] > vanished && steps_[i] < settings_.step_limit;
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
    Equations equations_;
    P y_[size], floor_[size];
    P t_, h_, rtol_, settled_, steps_;
    const M always_ = all_on();
    M active_ = always_, may_settle_ = always_, moving_ = always_;
    Program programs_[lanes];
    std::size_t number_[lanes] = {};
};

}  // namespace stickslip::lanes
