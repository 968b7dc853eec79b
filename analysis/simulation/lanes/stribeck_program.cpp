#include "analysis/simulation/lanes/stribeck_program.h"

#include <algorithm>

#include "analysis/numerics/hermite.h"
#include "analysis/simulation/flows/near_rest.h"

namespace stickslip::lanes {
namespace {

constexpr double equal_turns = 1e-9;  ///< gap of two turns that stick, per amplitude
constexpr double first_share = 1e-2;  ///< of the fastest time at rest: the first step out of it

class Dense {
  public:
    Dense(const StribeckView& s, int component)
    {
        double k[dormand_prince::stages];
        for (int j = 0; j < dormand_prince::stages; ++j) k[j] = s.k[j][component];
        dormand_prince::fill_dense(s.y0[component], s.y1[component], k, s.h, c_);
    }
    double operator()(double f) const { return dormand_prince::dense(c_, f); }

  private:
    double c_[5];
};

/// Where within the step, up to `end`, the speed takes a level, which it has on one side only.
double crossing(const Dense& u, double level, bool falls, double end = 1)
{
    double low = 0, high = end;
    for (int i = 0; i < 52; ++i) {
        const double middle = 0.5 * (low + high);
        ((u(middle) > level) == falls ? low : high) = middle;
    }
    return high;
}

}  // namespace

double StribeckGroups::release() const
{
    return zeta - alpha * std::expm1(rho);  // q(−1) = −1 for both powers
}
double StribeckGroups::damping() const
{
    return zeta - alpha * rho * power;
}

StribeckProgram::StribeckProgram() = default;
Phase StribeckProgram::phase() const
{
    return phase_;
}
double StribeckProgram::tolerance() const
{
    return settings_->rtol;
}
double StribeckProgram::settled() const
{
    return (phase_ == Phase::stated ? peak_told : settled_size) * size_;
}
const StribeckAnswer& StribeckProgram::answer() const
{
    return answer_;
}
void StribeckProgram::floors(double* floor) const
{
    floor[0] = floor[1] = size_;
}

Action StribeckProgram::restart(double X, double u, double h) const
{
    return {Action::Kind::restart, {X, u, 0}, h};
}

/// Leaves rest with no acceleration, as the forces balance there, and gathers speed as X falls.
Action StribeckProgram::from_rest()
{
    const auto& g = job_->groups;
    const double fast = 1 + std::abs(g.zeta) + std::abs(g.alpha) * g.rho * std::exp(g.rho);
    return restart(g.release(), -1, first_share / fast);
}

Action StribeckProgram::begin(const StribeckJob& job, const Settings& settings)
{
    job_ = &job;
    settings_ = &settings;
    answer_ = {};
    if (job.rate == 0) return give_up();  // neutral
    const bool grows = job.rate > 0;
    phase_ = grows ? Phase::cycle : Phase::stated;
    if (!job.stated && !grows) return decayed();
    if (job.stated) answer_.peak = job.start[0];
    return follow(job.start[0], job.start[1]);
}

Action StribeckProgram::follow(double X, double u)
{
    const double largest = std::max(std::abs(X), std::abs(u));
    size_ = largest > 0 ? std::min(1.0, largest) : 1;
    secants_ = {};
    elapsed_ = rested_since_ = 0;
    answer_.turns = 0;
    stuck_before_ = false;
    on_turn_ = phase_ == Phase::cycle && !job_->stated;
    turn_start_ = answer_.x_min = X;
    sticks_ = u == -1;  // so that the first turn that sticks is known to repeat
    return sticks_ ? from_rest() : restart(X, u, 1e-2 / (1 + std::abs(job_->groups.zeta)));
}

/// As in Program.
Action StribeckProgram::decayed()
{
    if (phase_ == Phase::search || !job_->search) return finish(Ending::decays);
    phase_ = Phase::search;
    return follow(job_->groups.release(), -1);
}

Action StribeckProgram::finish(Ending ending)
{
    answer_.ending = ending;
    return {Action::Kind::finished};
}

Action StribeckProgram::give_up()
{
    return finish(Ending::left_over);
}

Action StribeckProgram::end_of_turn(double X, double h)
{
    double start = X;
    if (job_->stated && !on_turn_ && phase_ != Phase::search) answer_.peak = std::max(answer_.peak, X);
    if (phase_ == Phase::stated && X < settled_size) return decayed();
    if (on_turn_) {
        ++answer_.turns;
        const bool stated = phase_ == Phase::stated;
        const auto cycle = [&] {
            answer_.x_max = std::max(turn_start_, X);
            answer_.reached = phase_ != Phase::search;
            return finish(phase_ == Phase::cycle ? Ending::cycle : Ending::bistable);
        };
        // rest forgets everything: two turns that stick are the same turn
        if (sticks_ && stuck_before_ && std::abs(X - turn_start_) <= equal_turns * X) {
            answer_.multiplier = 0;
            return cycle();
        }
        if (sticks_) {
            secants_.forget();
        } else {
            Point next;
            const auto state = stated ? secants_.next_in_basin({turn_start_, 0}, {X, 0}, next)
                                      : secants_.next({turn_start_, 0}, {X, 0}, phase_ == Phase::search, next);
            answer_.multiplier = secants_.multiplier();
            if (state == SecantSearch::State::closed) {
                if (answer_.multiplier > uncertain_multiplier) return give_up();
                return cycle();
            }
            if (state == SecantSearch::State::lost) return give_up();
            start = next.a;
        }
        if (answer_.turns >= (stated ? settings_->patient_turn_limit : settings_->turn_limit)) return give_up();
        if (phase_ == Phase::search && start < settled_size) return decayed();
    }
    on_turn_ = true;
    stuck_before_ = sticks_;
    sticks_ = false;
    turn_start_ = answer_.x_min = start;
    answer_.u_min = answer_.u_max = 0;
    answer_.rest_time = elapsed_ = 0;
    return restart(start, 0, h);
}

/// The mass stays while the spring pushes with less than the static friction; X then falls at speed 1.
Action StribeckProgram::arrive_at_rest(double X)
{
    const double release = job_->groups.release();
    if (X >= job_->groups.reverse) return give_up();  // backwards
    answer_.u_min = -1;
    if (X <= release) return restart(X, -1, 1e-6);
    sticks_ = true;
    elapsed_ += X - release;
    return from_rest();
}

Action StribeckProgram::handle(const StribeckView& step, EventFlags flags)
{
    const Dense u(step, 1);
    const bool falls = step.y1[1] < step.y0[1];
    const auto now = [&](double fraction) { return elapsed_ + step.t + fraction * step.h; };
    if (flags.turning) {
        if (const auto at = hermite_turning(step.y0[1], step.y1[1], step.k[0][1], step.k[6][1], step.h)) {
            answer_.u_max = std::max(answer_.u_max, u(*at));
            answer_.u_min = std::min(answer_.u_min, u(*at));
            // rest between two ends that both move
            if (!flags.rest && !flags.section && step.y0[1] > -1 && u(*at) <= -1) {
                if (step.y0[1] > near_rest - 1) rested_since_ = now(crossing(u, near_rest - 1, true, *at));
                const double fraction = crossing(u, -1, true, *at);
                elapsed_ = now(fraction);
                return arrive_at_rest(Dense(step, 0)(fraction));
            }
        }
    }
    if (flags.slow) {
        const double at = now(crossing(u, near_rest - 1, falls));
        falls ? rested_since_ = at : answer_.rest_time += at - rested_since_;
    }
    if (flags.section) {
        const double fraction = crossing(u, 0, falls);
        const double X = Dense(step, 0)(fraction);
        if (falls) {
            answer_.period = now(fraction);
            return end_of_turn(X, step.h);
        }
        if (on_turn_) answer_.x_min = std::min(answer_.x_min, X);
    }
    if (flags.rest) {
        const double fraction = crossing(u, -1, true);
        elapsed_ = now(fraction);
        return arrive_at_rest(Dense(step, 0)(fraction));
    }
    if (phase_ != Phase::cycle && flags.settled) {
        if (phase_ == Phase::stated && !on_turn_) answer_.peak = std::max(answer_.peak, step.y1[0]);
        return decayed();
    }
    return {};
}

}  // namespace stickslip::lanes
