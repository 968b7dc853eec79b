#include "analysis/diagnosis/plant/helpers.h"
#include "analysis/diagnosis/plant/runs.h"
#include "analysis/diagnosis/plant/simulator.h"
#include "analysis/simulation/lanes/job.h"

#include <algorithm>

namespace stickslip::gap {
namespace {

/// A run, and into how many substeps it divides a tick.
struct Divided {
    int parts;
    Run run;
};

/// Runs of one kind.
struct Batch {
    Kind kind;
    std::vector<Divided> runs;
};

void add(std::vector<Batch>& batches, const Run& run)
{
    const Kind kind = kind_of(*run.plant, *run.ticks);
    const Divided divided{substeps(run.ticks->step[run.from], longest_step(*run.plant)), run};
    for (auto& b : batches)
        if (b.kind == kind) return b.runs.push_back(divided);
    batches.push_back({kind, {divided}});
}

constexpr std::size_t most_lanes = 8;

/// Whether the next run fits into a lane that others of its pack leave before the pack ends.
bool falls_free_early(const Divided& run, const Divided& next)
{
    return next.parts == run.parts && next.run.to - next.run.from < run.run.to - run.run.from;
}

void go_together(std::span<const Run> runs, const Kind& kind)
{
    const auto instructions = lanes::best_instructions();
    if (runs.size() == 1)
        run_single(runs, kind);
    else if (instructions == lanes::Instructions::avx512)
        run_avx512(runs, kind);
    else if (instructions == lanes::Instructions::avx2)
        run_avx2(runs, kind);
    else
        run_baseline(runs, kind);
}

/// Runs of one kind that go together.
struct Together {
    const Kind* kind;
    std::vector<Run> runs;
};

std::vector<Together> packs_of(std::vector<Batch>& batches)
{
    std::vector<Together> packs;
    for (auto& [kind, all] : batches) {
        // what takes longest first, so that lanes end together
        std::stable_sort(all.begin(), all.end(), [](const Divided& a, const Divided& b) {
            return a.parts != b.parts ? a.parts > b.parts : a.run.to - a.run.from > b.run.to - b.run.from;
        });
        bool full = true;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (full) packs.push_back({&kind, {}});
            auto& runs = packs.back().runs;
            runs.push_back(all[i].run);
            // a lane that would be empty costs nothing, even where it waits for others that need more substeps
            full = i + 1 < all.size() && runs.size() % most_lanes == 0 && !falls_free_early(all[i], all[i + 1]);
        }
    }
    return packs;
}

/// Two packs of one: where two native vectors make a pack, half of it takes half the time.
void halve(std::vector<Together>& packs)
{
    constexpr std::size_t half = most_lanes / 2;
    auto& runs = packs[0].runs;
    if (runs.size() <= half || runs.size() > most_lanes) return;
    const auto middle = runs.begin() + static_cast<std::ptrdiff_t>((runs.size() + 1) / 2);
    Together second{packs[0].kind, {middle, runs.end()}};
    runs.erase(middle, runs.end());
    packs.push_back(std::move(second));
}

void go(std::vector<Batch>& batches)
{
    auto packs = packs_of(batches);
    const ParallelFor* helpers = Helpers::of_this_thread();
    if (helpers && packs.size() == 1 && lanes::best_instructions() != lanes::Instructions::avx512) halve(packs);
    const auto take = [&](std::size_t i) { go_together(packs[i].runs, *packs[i].kind); };
    if (helpers && packs.size() > 1)
        (*helpers)(packs.size(), take);
    else
        for (std::size_t i = 0; i < packs.size(); ++i) take(i);
}

/// Whether the record leaves open how its link rests before it moves.
bool rest_is_open(const Prediction& p)
{
    const Ticks& t = *p.ticks;
    if (!p.plant.two_mass || !t.at_rest || t.size() < 2) return false;
    const double link = p.plant.feedback_link ? t.position[0] : t.position[0] / p.plant.ratio;
    return load_force(p.plant.load, link, t.time[0]) != 0;
}

/// Which standstill predicts the first moments better. A record does not say it; a link that falls through its backlash
/// misses by thousands of prediction floors.
std::vector<Rest> rests_of(std::span<const Prediction> all)
{
    constexpr double moment = 0.2;  // numerical: s
    constexpr double omega = 50;    // numerical: rad/s
    constexpr Rest both[] = {Rest::pressed, Rest::level};
    std::vector<Rest> rests(all.size(), Rest::pressed);
    std::vector<std::size_t> open;
    std::vector<std::vector<double>> missed;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (rest_is_open(all[i])) open.push_back(i);
    std::vector<Batch> batches;
    missed.reserve(2 * open.size());
    for (const std::size_t i : open) {
        const Prediction& p = all[i];
        std::size_t count = 1;
        while (count < p.ticks->size() && p.ticks->time[count] - p.ticks->time[0] < moment) ++count;
        for (const Rest rest : both) {
            auto& error = missed.emplace_back(count, 0.0);
            add(batches, {&p.plant, p.ticks, p.command, omega, 0, count, rest, p.ticks->initial_velocity, error.data(),
                          nullptr, nullptr, nullptr});
        }
    }
    go(batches);
    const auto squares = [](const std::vector<double>& errors) {
        double sum = 0;
        for (const double e : errors) sum += is_set(e) ? e * e : 0;
        return sum;
    };
    for (std::size_t j = 0; j < open.size(); ++j)
        if (squares(missed[2 * j + 1]) < squares(missed[2 * j])) rests[open[j]] = Rest::level;
    return rests;
}

/// A prediction from each start to the next.
void add_runs(std::vector<Batch>& batches, const Prediction& p, Rest rest)
{
    const Ticks& t = *p.ticks;
    Innovation& out = *p.out;
    out.position.assign(t.size(), not_set);
    const bool more = p.wanted == Wanted::all, effort = more || p.wanted == Wanted::effort;
    if (effort) out.effort.assign(t.size(), not_set);
    if (more) out.velocity.resize(t.size()), out.predicted_effort.resize(t.size());
    Run run{&p.plant,
            p.ticks,
            p.command,
            p.omega,
            0,
            0,
            rest,
            t.initial_velocity,
            out.position.data(),
            effort ? out.effort.data() : nullptr,
            more ? out.velocity.data() : nullptr,
            more ? out.predicted_effort.data() : nullptr};
    for (std::size_t i = 0; i <= t.restarts.size(); ++i) {
        run.to = i < t.restarts.size() ? t.restarts[i].tick : t.size();
        if (run.to > run.from) add(batches, run);
        if (i == t.restarts.size()) break;
        run.from = run.to, run.velocity = t.restarts[i].velocity, run.rest = Rest::pressed;
    }
}

}  // namespace

Rest rest_at_start(const Plant& plant, const Ticks& ticks)
{
    Prediction one{plant, &ticks, {}, 0, nullptr};
    if (!rest_is_open(one)) return Rest::pressed;
    const auto command = known_command(plant, ticks);
    one.command = command;
    return rests_of({&one, 1})[0];
}

void predict_all(std::span<const Prediction> all)
{
    const auto rests = rests_of(all);
    std::vector<Batch> batches;
    for (std::size_t i = 0; i < all.size(); ++i) add_runs(batches, all[i], rests[i]);
    go(batches);
}

void predict(const Plant& plant, const Ticks& ticks, std::span<const double> command, double omega, Innovation& out)
{
    const Prediction one{plant, &ticks, command, omega, &out, Wanted::all};
    predict_all({&one, 1});
}

}  // namespace stickslip::gap
