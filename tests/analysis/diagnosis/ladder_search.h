// Ladders over records of a small machine.
#pragma once
#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/ladder/ladder.h"
#include "analysis/diagnosis/plant/simulator.h"
#include "analysis/diagnosis/policy/ladder.h"
#include "analysis/diagnosis/verdict/judge_ladder.h"
#include "tests/analysis/diagnosis/small_machine.h"
#include "tests/in_order.h"

#include <array>

namespace stickslip::gap {

/// A ladder over two records of a machine, to be climbed with these causes.
struct LadderRecords {
    std::vector<Case> cases;
    Scales scales;
    Nominal nominal;
    std::vector<Attribution> singles;
    std::unique_ptr<LadderSearch> search;

    LadderRecords(const test::Machine& m, std::initializer_list<const char*> causes, double dropped = 0)
        : LadderRecords({m, m}, causes, dropped)
    {
    }
    LadderRecords(const std::array<test::Machine, 2>& machines, std::initializer_list<const char*> causes,
                  double dropped = 0)
    {
        std::vector<Note> notes;
        std::mt19937 random(7);
        std::uniform_real_distribution<double> uniform;
        for (unsigned seed : {1u, 2u}) {
            Record r = test::record_of(machines[seed - 1], seed, 5);
            for (std::size_t k = 1; k < r.position.size(); ++k)  // an encoder that now and then holds a reading
                if (uniform(random) < dropped) r.position[k] = r.position[k - 1];
            cases.push_back(prepare(r, test::nominal_joint(), notes));
            cases.back().number = cases.size() - 1;
        }
        begin(causes);
    }
    /// Anew with records that this joint would have logged in their place.
    void simulate(const Joint& joint, std::initializer_list<const char*> causes)
    {
        for (auto& c : cases) {
            const Trace trace = simulate_closed_loop(flatten(joint), c.ticks, c.number + 1);
            c.ticks.position = trace.position, c.ticks.velocity = trace.velocity, c.ticks.command = trace.command;
        }
        singles.clear();
        begin(causes);
    }
    void begin(std::initializer_list<const char*> causes)
    {
        scales = scales_of(cases);
        nominal = judge_nominal(cases);
        for (const char* name : causes) singles.push_back(single(name));
        search = std::make_unique<LadderSearch>(Fit{cases, scales, nominal, test::in_order}, singles, policy::ladder);
    }
    /// A cause of the catalogue in its first form, "stribeck", or in the one behind a colon.
    Attribution single(std::string_view cause) const
    {
        const auto colon = std::min(cause.find(':'), cause.size());
        const Effect* e = effect_named(cause.substr(0, colon));
        const auto form =
            std::ranges::find(e->forms, cause.substr(std::min(colon + 1, cause.size())), &EffectForm::name);
        Attribution a;
        a.candidate = {{e}, {form == e->forms.end() ? &e->forms[0] : &*form}, cases.size()};
        a.x.fill(to_fit(a.candidate, a.candidate.forms[0]->seeds[0]));
        return a;
    }
    JudgedLadder judged(Ladder ladder) const
    {
        JudgedLadder j;
        j.ladder = std::move(ladder);
        judge(j, search->data(), {cases, scales, nominal, test::in_order});
        return j;
    }
};

}  // namespace stickslip::gap
