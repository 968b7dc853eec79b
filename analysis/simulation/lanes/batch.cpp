#include "analysis/simulation/lanes/batch.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "analysis/simulation/lanes/grouping.h"
#include "analysis/simulation/lanes/stribeck_batch.h"
#include "analysis/simulation/lanes/watched_batch.h"
#include "analysis/simulation/sampled/loop_verdict.h"
#include "analysis/simulation/solvers/work.h"

namespace stickslip::lanes {
namespace {

bool less(const Groups& a, const Groups& b)
{
    if (a.law != b.law) return a.law < b.law;
    if (a.M != b.M) return a.M < b.M;
    if (a.c != b.c) return a.c < b.c;
    if (a.beta != b.beta) return a.beta < b.beta;
    return a.K < b.K;
}

/// By groups, then by the disturbance.
template <class Job>
bool before(const Job& a, const Job& b)
{
    if (!(a.groups == b.groups)) return less(a.groups, b.groups);
    return std::lexicographical_compare(std::begin(a.start), std::end(a.start), std::begin(b.start), std::end(b.start));
}

/// Answers those joints among `open` that have such groups, each motion once; the numbers of the others stay. `ask`
/// changes a job before it is run, `take` gets its answer and says whether that is one.
template <class Scale, class Ask, class Take>
void answer_those(std::optional<Scale> (*scaled)(const Joint&), std::span<const Joint> joints,
                  const NonlinearOptions& options, std::vector<std::size_t>& open, const Ask& ask, const Take& take)
{
    using Job = typename Scale::Job;
    struct Entry {
        Scale scale;
        Job job;
        std::size_t number;
    };
    std::vector<Entry> entries;
    std::vector<std::size_t> others;
    for (const auto i : open) {
        const auto s = scaled(joints[i]);
        Entry entry;
        if (s) entry = {*s, job(s->groups, options.region), i};
        if (s) ask(entry.job);
        const bool stated = is_set(options.disturbance.size);
        if (s && (!stated || state(options.disturbance, joints[i], *s, entry.job)))
            entries.push_back(entry);
        else
            others.push_back(i);
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return before(a.job, b.job) || (!before(b.job, a.job) && a.number < b.number);
    });
    std::vector<Job> jobs;
    std::vector<std::size_t> job_of(entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (i == 0 || before(entries[i - 1].job, entries[i].job)) jobs.push_back(entries[i].job);
        job_of[i] = jobs.size() - 1;
    }
    std::vector<typename Scale::Answer> answers(jobs.size());
    Settings settings;
    settings.rtol = options.rtol;
    settings.watched_turns = options.turn_limit;
    settings.work = Work(options.effort).left();
    run(jobs.data(), answers.data(), jobs.size(), settings, best_instructions());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const auto& e = entries[i];
        if (!take(answers[job_of[i]], e)) others.push_back(e.number);
    }
    open = std::move(others);
}

}  // namespace

namespace {

template <class Scale>
bool decay_of(const std::optional<Scale>& scale, PointResult& point)
{
    if (!scale) return false;
    const auto small = job(scale->groups, false);
    typename Scale::Answer answer;
    answer.ending = Ending::decays;
    return small.rate < 0 && write(answer, *scale, small, point);
}

}  // namespace

bool decay(const Joint& joint, const NonlinearOptions& options, PointResult& point)
{
    if (!covers(options) || is_set(options.disturbance.size)) return false;
    return decay_of(scaled(joint), point) || decay_of(stribeck_scaled(joint), point);
}

void answer(std::span<const Joint> joints, const NonlinearOptions& options, std::span<PointResult> points,
            std::vector<std::size_t>& left_over)
{
    std::vector<std::size_t> open(joints.size());
    std::iota(open.begin(), open.end(), std::size_t{0});
    if (covers(options)) {
        const auto as_it_is = [](auto&) {};
        const auto row = [&](const auto& a, const auto& entry) {
            return write(a, entry.scale, entry.job, points[entry.number]);
        };
        answer_those<Scaled>(scaled, joints, options, open, as_it_is, row);
        answer_those<StribeckScaled>(stribeck_scaled, joints, options, open, as_it_is, row);
        answer_those<WatchedScaled>(watched_scaled, joints, options, open, as_it_is, row);
    }
    left_over.insert(left_over.end(), open.begin(), open.end());
    std::sort(left_over.begin(), left_over.end());
}

void sides(std::span<const Joint> joints, const NonlinearOptions& options, std::span<double> sides)
{
    std::fill(sides.begin(), sides.end(), missing);
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < joints.size(); ++i)
        if (!has_real_loop(joints[i])) open.push_back(i);
    if (!covers(options) || !is_set(options.disturbance.size)) return;
    answer_those<Scaled>(
        scaled, joints, options, open, [](Job& job) { job.side_only = job.rate < 0; },
        [&](const Answer& a, const auto& entry) {
            const bool told = a.ending != Ending::left_over;
            if (told) sides[entry.number] = a.reached || a.ending == Ending::leaves ? 1 : -1;
            return told;
        });
}

}  // namespace stickslip::lanes
