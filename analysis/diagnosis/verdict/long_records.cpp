#include "analysis/diagnosis/verdict/long_records.h"

#include "analysis/diagnosis/heldout/unseen.h"

#include <algorithm>

namespace stickslip::gap {

void take_stretches(Prepared& p, Diagnosis& d)
{
    p.stretches = stretches_of(p.cases);
    if (p.stretches.empty()) return;
    p.whole = std::move(p.cases);
    const auto documented = std::move(p.documented);
    p.cases.clear(), p.documented.clear();
    for (const auto& s : p.stretches) {
        p.cases.push_back(part_of(p.whole[s.record], s.from, s.to));
        Case& c = p.cases.back();
        c.number = p.cases.size() - 1;
        p.documented.push_back(documented[s.record]);
        d.rows.stretches.push_back({p.whole[s.record].ticks.name, c.ticks.time.front(), c.ticks.time.back()});
    }
    d.rows.fitted = rows_of(p.cases), d.rows.all = rows_of(p.whole);
    const auto how = std::ranges::find_if(d.notes, [](const Note& note) {
        return note.code == Note::Code::held_out_in_turn || note.code == Note::Code::thirds_in_turn;
    });
    const Note rest{.code = Note::Code::rest_held_out,
                    .values = {d.rows.fitted, d.rows.all, static_cast<double>(p.stretches.size())}};
    if (how != d.notes.end())
        *how = rest;
    else
        d.notes.push_back(rest);
}

HeldOut held_out(const Prepared& p, const ParallelFor& parallel, const Attribution& found, int runs)
{
    const Fit fit = p.fit(parallel);
    constexpr int few = 2;  // runs: over so many rows two tell the spread
    return p.whole.empty() ? hold_out(fit, p.documented, found, runs)
                           : hold_out_rest(p.whole, p.stretches, fit, p.documented, found, std::min(runs, few));
}

}  // namespace stickslip::gap
