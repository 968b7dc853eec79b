#include "analysis/simulation/lanes/program.h"

#include <algorithm>

#include "analysis/numerics/hermite.h"
#include "analysis/simulation/flows/disturbance.h"

namespace stickslip::lanes {
namespace {

constexpr double kick = 1.0;  ///< size of w, p or K X to which a growing disturbance is lifted

/// The dense output of one component (rodas5p_table.h).
struct Dense {
    double y0, y1, k[3];
    Dense(const StepView& s, int component) : y0(s.y0[component]), y1(s.y1[component])
    {
        for (int r = 0; r < 3; ++r) {
            k[r] = 0;
            for (int j = 0; j < rodas5p::stages; ++j) k[r] += rodas5p::dense[r][j] * s.U[j][component];
        }
    }
    double operator()(double f) const
    {
        const double rest = 1 - f;
        return rest * y0 + f * (y1 + rest * (k[0] + f * (k[1] + f * k[2])));
    }
    double slope_at_start() const { return y1 - y0 + k[0]; }  ///< per step
    double slope_at_end() const { return y1 - y0 - k[0] - k[1] - k[2]; }
};

/// Where the component takes the value `level` within the step (Illinois on the dense output).
double crossing(const Dense& y, double level)
{
    double left = 0, right = 1, at_left = y.y0 - level, at_right = y.y1 - level;
    int kept = 0;
    for (int i = 0; i < 50 && right - left > 1e-13; ++i) {
        const double middle = (left * at_right - right * at_left) / (at_right - at_left);
        const double value = y(middle) - level;
        if (std::abs(value) < 1e-15) return middle;
        if ((value > 0) == (at_right > 0)) {
            right = middle, at_right = value;
            if (kept == -1) at_left /= 2;
            kept = -1;
        } else {
            left = middle, at_left = value;
            if (kept == 1) at_right /= 2;
            kept = 1;
        }
    }
    return 0.5 * (left + right);
}

/// Where y turned in the step before: on the cubic through its start, both ends of this step and the slope between
/// them.
double turned_before(const StepView& s, const Dense& y)
{
    const double slope = y.slope_at_start() / s.h, back = s.h_before;
    const double ahead = (y.y1 - y.y0 - slope * s.h) / (s.h * s.h);
    const double behind = (s.w_before - y.y0 + slope * back) / (back * back);
    const double c = (ahead - behind) / (s.h + back), b = ahead - c * s.h;
    const double t = -slope / (b + std::copysign(std::sqrt(b * b - 3 * c * slope), b));
    return t < 0 && t > -back ? y.y0 + t * (slope + t * (b + t * c)) : y.y0;
}

}  // namespace

Program::Program() = default;
Phase Program::phase() const
{
    return phase_;
}
double Program::end_time() const
{
    return phase_ == Phase::grow ? job_->window : 1e300;
}
double Program::tolerance() const
{
    return settings_->rtol * (phase_ == Phase::grow ? job_->fineness : 1);
}
const Answer& Program::answer() const
{
    return answer_;
}

Action Program::start_at(double X, double w, double p) const
{
    return {Action::Kind::restart, {X, w, p}, first_step(w)};
}

/// A tenth of the fastest time constant or, where that is the inertia's at tiny M, a thousandth of the motion's own:
/// L-stability takes care of the rest, and the error control of what was too bold.
double Program::first_step(double w) const
{
    const auto& g = job_->groups;
    const double v = std::exp(std::min(w, 0.0));
    const double fast = g.M * v / (1 + g.c * v);
    return std::clamp(fast, 1e-3 / job_->magnitude, 3e-2 / job_->magnitude);
}

double Program::slow_size(const double y[3]) const
{
    double real = 0, imaginary = 0;
    for (int i = 0; i < 3; ++i) real += job_->left[i][0] * y[i], imaginary += job_->left[i][1] * y[i];
    return std::hypot(real, imaginary);
}

void Program::floors(double* floor) const
{
    const auto& g = job_->groups;
    const double share = phase_ == Phase::grow ? settings_->floor : 1;
    floor[0] = share * (1 + g.beta + g.c + std::sqrt(g.K * g.M)) / g.K;
    floor[1] = share;
    floor[2] = share * g.beta;
}

Action Program::begin(const Job& job, const Settings& settings)
{
    job_ = &job;
    settings_ = &settings;
    answer_ = {};
    phase_ = Phase::grow;
    secants_ = {};
    on_turn_ = false;
    rested_since_ = 0;
    size0_ = slow_size(job.start);
    return start_at(job.start[0], job.start[1], job.start[2]);
}

Action Program::finish(Ending ending)
{
    answer_.ending = ending;
    return {Action::Kind::finished};
}

Action Program::give_up()
{
    return finish(Ending::left_over);
}

/// ln(V/V_0) at which the forces balance for given spring and state: where a light mass goes at once.
double Program::balanced_speed(double X, double p) const
{
    const auto& g = job_->groups;
    double w = std::min(0.0, -(g.K * X + p));
    for (int i = 0; i < 50; ++i) {
        const double step = (g.c * std::expm1(w) + g.K * X + w + p) / (g.c * std::exp(w) + 1);
        w -= std::clamp(step, -2.0, 2.0);
        if (std::abs(step) < 1e-12) break;
    }
    return w;
}

Action Program::end_of_growth(const StepView& step)
{
    answer_.growth = std::log(slow_size(step.y1) / size0_) / (step.t + step.h);
    if (!std::isfinite(answer_.growth)) return give_up();
    const bool measurable = std::abs(answer_.growth) > measurable_growth * job_->magnitude;
    const bool grows = measurable ? answer_.growth > 0 : job_->rate > 0;
    if (!grows && !job_->search) return finish(Ending::decays);
    if (!grows) {
        phase_ = Phase::search;
        return start_at(job_->rest_start[0], job_->rest_start[1], job_->rest_start[2]);
    }
    phase_ = Phase::cycle;
    const auto& g = job_->groups;
    const double size = std::max({std::abs(step.y1[1]), std::abs(step.y1[2]), std::abs(g.K * step.y1[0])});
    const double lift = kick / size;
    const double X = lift * step.y1[0], p = lift * step.y1[2];
    const bool light = g.M < 0.1;
    return start_at(X, light ? balanced_speed(X, p) : lift * step.y1[1], p);
}

void Program::note_extremum(const StepView& s)
{
    // slopes of the dense output, as rates of a stiff motion are no better than its tolerance times its stiffness
    const Dense w(s, 1);
    const auto within = hermite_turning(w.y0, w.y1, w.slope_at_start(), w.slope_at_end(), 1);
    const double extremum = within ? w(*within) : turned_before(s, w);
    answer_.w_max = std::max(answer_.w_max, extremum);
    answer_.w_min = std::min(answer_.w_min, extremum);
}

Action Program::end_of_turn(const StepView& step, double fraction)
{
    const auto& g = job_->groups;
    const double X = Dense(step, 0)(fraction), p = Dense(step, 2)(fraction);
    const Point end{g.K * X, p};
    Point start = end;
    if (on_turn_) {
        ++answer_.turns;
        answer_.period = step.t + fraction * step.h;
        const auto state = secants_.next(turn_start_, end, phase_ == Phase::search, start);
        answer_.multiplier = secants_.multiplier();
        if (state == SecantSearch::State::closed) {
            if (answer_.multiplier > uncertain_multiplier) return give_up();
            answer_.x_max = std::max(turn_start_.a / g.K, X);
            return finish(phase_ == Phase::search ? Ending::bistable : Ending::cycle);
        }
        if (state == SecantSearch::State::lost || answer_.turns >= settings_->turn_limit) return give_up();
        if (phase_ == Phase::search && length(start) < settled_size) return finish(Ending::decays);
    }
    on_turn_ = true;
    turn_start_ = start;
    answer_.w_min = answer_.w_max = 0;
    answer_.x_min = start.a / g.K;
    answer_.rest_time = 0;
    Action action{Action::Kind::restart, {start.a / g.K, 0, start.b}, step.h};
    return action;
}

Action Program::handle(const StepView& step, EventFlags flags)
{
    if (phase_ == Phase::grow) return flags.time ? end_of_growth(step) : Action{};
    if (phase_ == Phase::search && flags.settled) return finish(Ending::decays);
    if (flags.turning) note_extremum(step);
    if (flags.slow) {
        const double at = step.t + step.h * crossing(Dense(step, 1), near_rest_logarithm);
        if (step.y1[1] < step.y0[1])
            rested_since_ = at;
        else
            answer_.rest_time += at - rested_since_;
    }
    if (flags.section) {
        const double fraction = crossing(Dense(step, 1), 0);
        if (step.y1[1] < step.y0[1]) return end_of_turn(step, fraction);
        if (on_turn_) answer_.x_min = std::min(answer_.x_min, Dense(step, 0)(fraction));
    }
    return {};
}

}  // namespace stickslip::lanes
