#include "analysis/simulation/lanes/stribeck_program.h"

#include <algorithm>

#include "analysis/numerics/hermite.h"
#include "analysis/simulation/flows/disturbance.h"
#include "analysis/simulation/flows/near_rest.h"

namespace stickslip::lanes {
namespace {

constexpr double equal_turns = 1e-9;  ///< gap of two turns that stick, per amplitude
constexpr double kick = 0.1;          ///< size of X and u to which a growing disturbance is lifted
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

/// Where within the step the speed takes a level, which it has on one side only.
double crossing(const Dense& u, double level, bool falls)
{
    double low = 0, high = 1;
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
double StribeckProgram::end_time() const
{
    return phase_ == Phase::grow ? job_->window : 1e300;
}
double StribeckProgram::tolerance() const
{
    return settings_->rtol * (phase_ == Phase::grow ? job_->fineness : 1);
}
const StribeckAnswer& StribeckProgram::answer() const
{
    return answer_;
}
void StribeckProgram::floors(double* floor) const
{
    floor[0] = floor[1] = phase_ == Phase::grow ? settings_->floor : 1;
}

double StribeckProgram::slow_size(const double* y) const
{
    double real = 0, imaginary = 0;
    for (int i = 0; i < 2; ++i) real += job_->left[i][0] * y[i], imaginary += job_->left[i][1] * y[i];
    return std::hypot(real, imaginary);
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
    phase_ = Phase::grow;
    secants_ = {};
    on_turn_ = sticks_ = stuck_before_ = false;
    elapsed_ = rested_since_ = 0;
    size0_ = slow_size(job.start);
    return restart(job.start[0], job.start[1], 1e-2 / (1 + std::abs(job.groups.zeta)));
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

Action StribeckProgram::end_of_growth(const StribeckView& step)
{
    answer_.growth = std::log(slow_size(step.y1) / size0_) / (step.t + step.h);
    if (!std::isfinite(answer_.growth)) return give_up();
    const bool measurable = std::abs(answer_.growth) > measurable_growth * job_->magnitude;
    const bool grows = measurable ? answer_.growth > 0 : job_->rate > 0;
    if (!grows && !job_->search) return finish(Ending::decays);
    phase_ = grows ? Phase::cycle : Phase::search;
    if (!grows) {
        sticks_ = true;  // so that the first turn that sticks is known to repeat
        return from_rest();
    }
    const double lift = kick / std::max(std::abs(step.y1[0]), std::abs(step.y1[1]));
    return restart(lift * step.y1[0], lift * step.y1[1], step.h);
}

Action StribeckProgram::end_of_turn(double X, double h)
{
    double start = X;
    if (on_turn_) {
        ++answer_.turns;
        const bool searching = phase_ == Phase::search;
        const auto cycle = [&] {
            answer_.x_max = std::max(turn_start_, X);
            return finish(searching ? Ending::bistable : Ending::cycle);
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
            const auto state = secants_.next({turn_start_, 0}, {X, 0}, searching, next);
            answer_.multiplier = secants_.multiplier();
            if (state == SecantSearch::State::closed) {
                if (answer_.multiplier > uncertain_multiplier) return give_up();
                return cycle();
            }
            if (state == SecantSearch::State::lost) return give_up();
            start = next.a;
        }
        if (answer_.turns >= settings_->turn_limit) return give_up();
        if (searching && start < settled_size) return finish(Ending::decays);
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
    if (phase_ == Phase::grow) return flags.time ? end_of_growth(step) : Action{};
    const Dense u(step, 1);
    const bool falls = step.y1[1] < step.y0[1];
    const auto now = [&](double fraction) { return elapsed_ + step.t + fraction * step.h; };
    if (flags.turning) {
        if (const auto at = hermite_turning(step.y0[1], step.y1[1], step.k[0][1], step.k[6][1], step.h)) {
            answer_.u_max = std::max(answer_.u_max, u(*at));
            answer_.u_min = std::min(answer_.u_min, u(*at));
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
    if (phase_ == Phase::search && flags.settled) return finish(Ending::decays);
    return {};
}

}  // namespace stickslip::lanes
