#include "analysis/diagnosis/heldout/unseen.h"

#include <algorithm>

namespace stickslip::gap {
namespace {

/// The ticks around a stretch, halfway to its neighbours in the same record, on a row.
StretchOf around(const std::vector<Case>& whole, const std::vector<StretchOf>& stretches, std::size_t i)
{
    const StretchOf& s = stretches[i];
    const Ticks& t = whole[s.record].ticks;
    const auto m = static_cast<std::size_t>(t.ticks_per_row);
    const auto halfway = [&](std::size_t a, std::size_t b) { return (a + b) / 2 / m * m; };
    StretchOf all{s.record, 0, t.size()};
    if (i > 0 && stretches[i - 1].record == s.record) all.from = halfway(stretches[i - 1].to, s.from);
    if (i + 1 < stretches.size() && stretches[i + 1].record == s.record) all.to = halfway(s.to, stretches[i + 1].from);
    return all;
}

}  // namespace

HeldOut hold_out_rest(const std::vector<Case>& whole, const std::vector<StretchOf>& stretches, const Fit& fit,
                      const std::vector<Joint>& documented, const Attribution& found, int runs)
{
    constexpr std::size_t level = 1;  // as of records that are held out in their turn
    const auto si = in_si(found.candidate, found.x[level], fit.scales);
    std::vector<FoldResult> results(stretches.size());
    std::vector<DiagnosedTrace> traces(stretches.size());
    fit.parallel(stretches.size(), [&](std::size_t i) {
        const StretchOf all = around(whole, stretches, i), seen = stretches[i];
        Case c = part_of(whole[all.record], all.from, all.to);
        c.ticks.judged.assign(c.ticks.size(), 1);
        std::fill(c.ticks.judged.begin() + static_cast<std::ptrdiff_t>(seen.from - all.from),
                  c.ticks.judged.begin() + static_cast<std::ptrdiff_t>(seen.to - all.from), 0);
        const Joint after = found.candidate.effects.empty() ? c.joint : edited(c.joint, found.candidate, si, i);
        FoldResult& r = results[i];
        r = before_and_after(c, documented[i], after, runs, -infinity, infinity);
        if (!r.trace_before.position.empty()) traces[i] = trace_of(c, r.trace_before, r.trace_after);
        r.trace_before = {}, r.trace_after = {};
    });
    HeldOut held;
    add_gaps(results, held);
    for (auto& trace : traces)
        if (!trace.time.empty()) held.traces.push_back(std::move(trace));
    return held;
}

}  // namespace stickslip::gap
