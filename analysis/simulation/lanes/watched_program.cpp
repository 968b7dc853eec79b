#include "analysis/simulation/lanes/watched_turns.h"

#include <algorithm>
#include <cmath>

#include "analysis/simulation/solvers/work.h"

namespace stickslip::lanes {
namespace {

/// Gap of a motion that came back, what is to come of it included, per amplitude; the second of one that has been
/// watched for long, which may be as good as its steps let it.
constexpr double repeated = 1e-6, repeated_roughly = 1e-5;
constexpr int settling_turns = 60;
/// Turns that hardly change, before the reference looks at them: it spends as long on some of them as lanes on these.
/// Evidence: of two masses a turn of lanes takes 5 to 10 µs, a point of the reference 50 ms.
constexpr int most_creeping = 150, most_creeping_of_two = 1500;

}  // namespace

WatchedProgram::WatchedProgram() : watched_(std::make_unique<Watched>()) {}
WatchedProgram::~WatchedProgram() = default;
Phase WatchedProgram::phase() const
{
    return phase_;
}
double WatchedProgram::tolerance() const
{
    return settings_->rtol;
}
double WatchedProgram::settled() const
{
    return (phase_ == Phase::stated ? peak_told : settled_size) * size_;
}
const WatchedAnswer& WatchedProgram::answer() const
{
    return answer_;
}
void WatchedProgram::floors(double* floor) const
{
    for (int k = 0; k < job_->groups.unknowns(); ++k) floor[k] = size_ * job_->scale[k];
}
double WatchedProgram::speed_of(double measure) const
{
    return job_->groups.logarithmic() ? std::exp(measure) : 1 + measure;
}

Action WatchedProgram::begin(const WatchedJob& job, const Settings& settings)
{
    job_ = &job;
    settings_ = &settings;
    answer_ = {};
    search_ = 0;
    if (job.rate == 0) return give_up();  // neutral
    const bool grows = job.rate > 0;
    phase_ = grows ? Phase::cycle : Phase::stated;
    if (job.stated || !grows) answer_.peak = job.start[0];
    return follow(job.start);
}

Action WatchedProgram::follow(const double (&start)[most_unknowns])
{
    double largest = 0;
    for (int k = 0; k < job_->groups.unknowns(); ++k) largest = std::max(largest, std::abs(start[k]) / job_->scale[k]);
    size_ = largest > 0 ? std::min(1.0, largest) : 1;
    watched_->turns.clear();
    watched_->first_peak = start[0];
    smaller_.forget();
    linear_turns_ = since_leap_ = creeps_ = answer_.turns = 0;
    on_turn_ = false;
    begin_turn(start[0]);
    const double magnitude = std::hypot(job_->rate, job_->frequency);
    Action action{Action::Kind::restart, {}, 1e-3 / magnitude};
    std::copy_n(start, job_->groups.unknowns(), action.y);
    return action;
}

/// As in Program; the search is made from several starts.
Action WatchedProgram::decayed()
{
    if (phase_ == Phase::search) ++search_;
    if (search_ >= job_->searches) return finish(Ending::decays);
    phase_ = Phase::search;
    return follow(job_->larger[search_]);
}

Action WatchedProgram::finish(Ending ending)
{
    answer_.ending = ending;
    return {Action::Kind::finished};
}

Action WatchedProgram::give_up()
{
    return finish(Ending::left_over);
}

void WatchedProgram::begin_turn(double X)
{
    answer_.w_min = answer_.w_max = 0;
    answer_.x_min = X;
    answer_.rest_time = rested_since_ = 0;
}

Action WatchedProgram::end_of_turn(const StepView& step, double fraction)
{
    const int n = job_->groups.unknowns();
    const double X = DenseComponent(step, 0)(fraction);
    FlowVector& end = watched_->end;
    end.setZero(n);
    for (int k = 0; k < n; ++k)
        if (k != 1) end[k] = DenseComponent(step, k)(fraction) / job_->scale[k];
    if (!on_turn_) watched_->first_peak = std::max(watched_->first_peak, X);
    const bool first = !on_turn_ && phase_ != Phase::search;
    if (first && is_set(answer_.peak)) answer_.peak = std::max(answer_.peak, X);
    if (phase_ == Phase::stated && !job_->stated)
        return decayed();  // a small one: its highest point was all to be seen
    if (phase_ != Phase::cycle && norm(end) < settled_size) return decayed();
    bool leapt = false;
    if (on_turn_) {
        note_turn(step.t + fraction * step.h);
        const double allowed = (answer_.turns < settling_turns ? repeated : repeated_roughly) * norm(end);
        const auto gap = [this](int i, int j) { return watched_->gap(i, j); };
        if (nearest_return(watched_->count(), gap, allowed) > 0)
            if (const int m = turns_to_repeat(watched_->count(), gap, allowed); m > 0) return goes_around(m);
        if (phase_ != Phase::cycle && decays_linearly()) return decayed();
        if (creeps_ > (job_->groups.two_masses() ? most_creeping_of_two : most_creeping)) return give_up();
        const bool cut_short = step.steps * Work::of_step(n) > settings_->work;
        if (answer_.turns >= settings_->watched_turns || cut_short) return out_of_patience(cut_short);
        leapt = leap();
    }
    on_turn_ = true;
    if (!leapt) watched_->start = end;
    begin_turn(watched_->start[0] * job_->scale[0]);
    Action action{Action::Kind::restart, {}, step.h};
    for (int k = 0; k < n; ++k) action.y[k] = k == 1 ? 0 : watched_->start[k] * job_->scale[k];
    return action;
}

Action WatchedProgram::handle(const StepView& step, EventFlags flags)
{
    if (phase_ != Phase::cycle && flags.settled) {
        if (phase_ == Phase::stated && !on_turn_) answer_.peak = std::max(answer_.peak, step.y1[0]);
        return decayed();
    }
    if (flags.turning) {
        const double extremum = extreme_speed(step);
        answer_.w_max = std::max(answer_.w_max, extremum);
        answer_.w_min = std::min(answer_.w_min, extremum);
    }
    if (flags.slow) {
        const double level = job_->groups.logarithmic() ? near_rest_logarithm : near_rest - 1;
        const double at = step.t + step.h * crossing(DenseComponent(step, 1), level);
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
