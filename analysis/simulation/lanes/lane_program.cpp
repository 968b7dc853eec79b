#include "analysis/simulation/lanes/lane_program.h"

#include <algorithm>

namespace stickslip::lanes {
namespace {

/// A rough cycle counts where the return map contracts by that (clear_decay in care.cpp).
constexpr double clear_multiplier = 0.95;

}  // namespace

Program::Program() = default;
Phase Program::phase() const
{
    return phase_;
}
double Program::settled() const
{
    return (phase_ == Phase::stated ? peak_told : settled_size) * size_;
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
    const double magnitude = std::hypot(job_->rate, job_->frequency);
    return std::clamp(fast, 1e-3 / magnitude, 3e-2 / magnitude);
}

void Program::floors(double* floor) const
{
    const auto& g = job_->groups;
    floor[0] = size_ * (1 + g.beta + g.c + std::sqrt(g.K * g.M)) / g.K;
    floor[1] = size_;
    floor[2] = size_ * g.beta;
}

Action Program::begin(const Job& job, const Settings& settings)
{
    job_ = &job;
    settings_ = &settings;
    answer_ = {};
    if (job.rate == 0) return give_up();  // neutral
    const bool grows = job.rate > 0;
    phase_ = grows ? Phase::cycle : Phase::stated;
    if (!job.stated && !grows) return decayed();
    if (job.stated) answer_.peak = job.start[0];
    return begin_phase(phase_);
}

/// The basin of a stated disturbance is decided to full tolerance at once, and so is what a rough search leaves open.
Action Program::begin_phase(Phase phase)
{
    phase_ = phase;
    const bool rough = !job_->stated && settings_->rough > settings_->rtol;
    care_ = phase == Phase::search ? first_care_of_search() : rough ? Care::rough : Care::fine;
    return follow(phase == Phase::search ? job_->rest_start : job_->start);
}

Action Program::follow(const double (&start)[3])
{
    const double largest = std::max({std::abs(job_->groups.K * start[0]), std::abs(start[1]), std::abs(start[2])});
    size_ = largest > 0 ? std::min(1.0, largest) : 1;
    secants_ = {};
    smaller_.forget();
    basin_.forget();
    rested_since_ = 0;
    answer_.turns = refinements_ = 0;
    weakest_decay_ = 0;
    const double falls = job_->groups.K * start[0] + start[2];
    on_turn_ = phase_ == Phase::cycle && !job_->stated && start[1] == 0 && falls > 0;
    turn_start_ = {job_->groups.K * start[0], start[2]};
    answer_.x_min = start[0];
    return start_at(start[0], start[1], start[2]);
}

/// The disturbance has decayed; where that is wanted, the search for a coexisting cycle begins.
Action Program::decayed()
{
    if (phase_ == Phase::search && !clearly_decays()) return with_more_care();
    if (phase_ == Phase::search || !job_->search) return finish(Ending::decays);
    return begin_phase(Phase::search);
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

void Program::note_extremum(const StepView& s)
{
    const double extremum = extreme_speed(s);
    answer_.w_max = std::max(answer_.w_max, extremum);
    answer_.w_min = std::min(answer_.w_min, extremum);
}

Action Program::end_of_turn(const StepView& step, double fraction)
{
    const auto& g = job_->groups;
    const double X = DenseComponent(step, 0)(fraction), p = DenseComponent(step, 2)(fraction);
    const Point end{g.K * X, p};
    Point start = end;
    if (job_->stated && !on_turn_ && phase_ != Phase::search) answer_.peak = std::max(answer_.peak, X);
    if (phase_ == Phase::stated && length(end) < settled_size) return decayed();
    if (on_turn_) {
        ++answer_.turns;
        answer_.period = step.t + fraction * step.h;
        const auto told = told_by_turns(end, start);
        if (told == BasinSide::Told::decays) return decayed();
        if (told == BasinSide::Told::leaves && job_->side_only) return finish(Ending::leaves);
        const auto state = basin_.moved() ? SecantSearch::State::searching : next_turn(end, start);
        if (state == SecantSearch::State::closed) {
            if (care_ == Care::rough) {
                if (secants_.multiplier() > clear_multiplier) return all_again(Care::fine);
                refine(Care::nearing);
            } else if (phase_ == Phase::cycle && care_ != Care::exact && weakly_contracting()) {
                refine(Care::exact);
            } else {
                if (weakly_contracting()) return give_up();
                answer_.multiplier = secants_.multiplier();
                answer_.x_max = std::max(turn_start_.a / g.K, X);
                answer_.reached = phase_ != Phase::search;
                return finish(phase_ == Phase::cycle ? Ending::cycle : Ending::bistable);
            }
        } else {
            const int limit = in_basin() ? settings_->patient_turn_limit : settings_->turn_limit;
            if (state == SecantSearch::State::lost || answer_.turns >= limit) return with_more_care();
            if (phase_ == Phase::search && (length(start) < settled_size || none_smaller(end))) return decayed();
        }
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
    if (phase_ != Phase::cycle && flags.settled) {
        if (phase_ == Phase::stated && !on_turn_) answer_.peak = std::max(answer_.peak, step.y1[0]);
        return decayed();
    }
    if (flags.turning) note_extremum(step);
    if (flags.slow) {
        const double at = step.t + step.h * crossing(DenseComponent(step, 1), near_rest_logarithm);
        if (step.y1[1] < step.y0[1])
            rested_since_ = at;
        else
            answer_.rest_time += at - rested_since_;
    }
    if (flags.section) {
        const double fraction = crossing(DenseComponent(step, 1), 0);
        if (step.y1[1] < step.y0[1]) return end_of_turn(step, fraction);
        if (on_turn_) answer_.x_min = std::min(answer_.x_min, DenseComponent(step, 0)(fraction));
    }
    return {};
}

}  // namespace stickslip::lanes
