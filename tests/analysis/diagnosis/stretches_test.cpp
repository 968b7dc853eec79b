#include "analysis/diagnosis/audit/stretches.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/heldout/unseen.h"
#include "analysis/diagnosis/policy/records.h"
#include "tests/analysis/diagnosis/record_rows.h"
#include "tests/analysis/diagnosis/small_machine.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using namespace stickslip::gap;
using stickslip::test::Machine;
using stickslip::test::nominal_joint;
using stickslip::test::record_of;

namespace {

Case case_of(const Machine& m, double seconds)
{
    std::vector<Note> notes;
    return prepare(record_of(m, 3, seconds), nominal_joint(), notes);
}

/// As long as `times` of this record after one another; the last second of it is driven to where none else is.
Case repeated(const Case& once, std::size_t times)
{
    Case c = once;
    Ticks& t = c.ticks;
    const std::size_t n = t.size();
    const double length = t.duration() + t.step.back();
    t.time.reserve(n * times);
    for (std::size_t i = 1; i < times; ++i) {
        const auto again = [&](auto& column) {
            for (std::size_t k = 0; k < n; ++k) column.push_back(column[k]);
        };
        for (auto* column :
             {&t.step, &t.reference, &t.reference_rate, &t.position, &t.velocity, &t.command, &t.effort, &t.supply})
            again(*column);
        again(t.enabled), again(t.logged);
        for (std::size_t k = 0; k < n; ++k) t.time.push_back(t.time[k] + static_cast<double>(i) * length);
    }
    return c;
}

double ticks_of(const std::vector<StretchOf>& stretches)
{
    double sum = 0;
    for (const auto& s : stretches) sum += static_cast<double>(s.to - s.from);
    return sum;
}

}  // namespace

TEST_CASE("records up to the budget are fitted as a whole", "[gap][stretches]")
{
    CHECK(stretches_of({case_of({}, 20)}).empty());
    CHECK(stretches_of({repeated(case_of({}, 20), 10)}).empty());
}

TEST_CASE("of a long record about the budget is fitted, and the one second that is unlike all others with it",
          "[gap][stretches][slow]")
{
    auto long_one = repeated(case_of({}, 20), 25);
    for (std::size_t k = 340'000; k < 341'000; ++k) long_one.ticks.position[k] += 1e-2;
    const auto stretches = stretches_of({long_one});
    CHECK(ticks_of(stretches) >= policy::fitted);
    CHECK(ticks_of(stretches) < 1.2 * policy::fitted);
    REQUIRE(stretches.size() >= static_cast<std::size_t>(policy::stretches_fitted));
    bool holds_it = false;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        holds_it = holds_it || (stretches[i].from <= 340'000 && stretches[i].to >= 341'000);
        if (i > 0) CHECK(stretches[i].from >= stretches[i - 1].to);
    }
    CHECK(holds_it);
    // the same again: nothing is drawn
    const auto again = stretches_of({long_one});
    REQUIRE(again.size() == stretches.size());
    for (std::size_t i = 0; i < again.size(); ++i) CHECK(again[i].from == stretches[i].from);
}

TEST_CASE("every record has a stretch", "[gap][stretches]")
{
    const auto small = case_of({}, 6);
    const auto stretches = stretches_of({repeated(case_of({}, 20), 25), small, small});
    std::array<int, 3> count{};
    for (const auto& s : stretches) ++count[s.record];
    CHECK(count[0] > 1);
    CHECK(count[1] == 1);
    CHECK(count[2] == 1);
}

TEST_CASE("a part predicts as the whole record does once its start is forgotten", "[gap][stretches]")
{
    const Case whole = case_of({}, 20);
    const std::size_t from = 7321, to = 15000, forgotten = 500;
    const Case part = part_of(whole, from, to);
    REQUIRE(part.ticks.size() == to - from);
    CHECK(part.ticks.time.front() == whole.ticks.time[from]);
    const Plant plant = flatten(whole.joint);
    Innovation all, cut;
    predict(plant, whole.ticks, whole.ticks.command, 50, all);
    predict(plant, part.ticks, part.ticks.command, 50, cut);
    double difference = 0, size = 0;
    for (std::size_t k = forgotten; k < part.ticks.size(); ++k) {
        difference += std::pow(cut.position[k] - all.position[from + k], 2);
        size += std::pow(all.position[from + k], 2);
    }
    CHECK(difference < 1e-3 * size);
    // and hardly worse until then: what the start is off by must not hide what the model is off by
    double first = 0, usual = 0;
    for (std::size_t k = 0; k < forgotten; ++k) {
        first = std::max(first, std::abs(cut.position[k]));
        usual = std::max(usual, std::abs(all.position[from + k]));
    }
    CHECK(first < 3 * usual);
}

TEST_CASE("the gap on unseen rows is that of the same joint on whole records", "[gap][stretches]")
{
    Machine m;
    m.coulomb *= 1.3;
    const Case whole = case_of(m, 20);
    const std::vector<StretchOf> stretches{{0, 4000, 6000}, {0, 12000, 14000}};
    const std::vector<Case> cases{part_of(whole, 4000, 6000), part_of(whole, 12000, 14000)};
    const Nominal nominal;
    const Fit fit{cases, {}, nominal, test::in_order};
    const Attribution none;
    const auto rest = hold_out_rest({whole}, stretches, fit, {whole.joint, whole.joint}, none, 4);
    // the oracle: the same simulation over all rows in one go
    const auto all = compare(whole, whole.joint, 4, -infinity, infinity);
    REQUIRE(rest.signals.size() == all.size());
    for (const auto& gap : rest.signals)
        for (const auto& s : all)
            if (s.signal == gap.signal) {
                INFO(s.signal);
                CHECK(gap.before == Approx(std::sqrt(s.difference)).epsilon(0.25));
                CHECK(gap.after == gap.before);
            }
}
