#include "analysis/diagnosis/verdict/stage_meter.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <stdexcept>
#include <thread>

using namespace stickslip;
using namespace stickslip::gap;

TEST_CASE("within a stage the part that is done grows with every task and stays below the next stage's", "[gap]")
{
    std::vector<double> told;
    const StageProgress tell = [&](DiagnosisStage stage, double done) {
        CHECK(stage == DiagnosisStage::fitting_singles);
        told.push_back(done);
    };
    const ParallelFor run = test::in_order;
    StageMeter meter(run, tell);
    meter.begin(DiagnosisStage::fitting_singles);
    for (int round = 0; round < 50; ++round) meter.run(4, [](std::size_t) {});
    CHECK(told.front() == begins_at(DiagnosisStage::fitting_singles));
    CHECK(std::ranges::is_sorted(told));
    CHECK(told[1] > told[0]);
    CHECK(told[4] > told[1]);
    CHECK(told.back() <= begins_at(DiagnosisStage::correcting_numbers));
}

TEST_CASE("the tasks of a task are counted with it, and other threads tell nothing", "[gap]")
{
    const auto caller = std::this_thread::get_id();
    int told = 0, done = 0;
    const StageProgress tell = [&](DiagnosisStage, double) {
        CHECK(std::this_thread::get_id() == caller);
        ++told;
    };
    const ParallelFor elsewhere = [](std::size_t n, const std::function<void(std::size_t)>& task) {
        std::thread([&] { test::in_order(n, task); }).join();
    };
    StageMeter meter(elsewhere, tell);
    meter.begin(DiagnosisStage::climbing_ladder);
    meter.run(2, [&](std::size_t) { meter.run(3, [&](std::size_t) { ++done; }); });
    CHECK(done == 6);
    CHECK(told == 2);
}

TEST_CASE("threads help each other once the last task of a round has begun, and between rounds", "[gap]")
{
    const ParallelFor run = test::in_order;
    const StageProgress tell = [](DiagnosisStage, double) {};
    {
        StageMeter meter(run, tell);
        CHECK(Helpers::of_this_thread() == &run);
        std::vector<bool> helped;
        meter.run(3, [&](std::size_t) { helped.push_back(Helpers::of_this_thread() == &run); });
        CHECK(helped == std::vector<bool>{false, false, true});
        CHECK(Helpers::of_this_thread() == &run);
    }
    CHECK(Helpers::of_this_thread() == nullptr);
}

TEST_CASE("what a task throws is thrown when its round has ended", "[gap]")
{
    const ParallelFor run = test::in_order;
    const StageProgress tell = [](DiagnosisStage, double) {};
    StageMeter meter(run, tell);
    int done = 0;
    const auto task = [&](std::size_t i) { i == 0 ? throw std::runtime_error("of the first") : void(++done); };
    CHECK_THROWS_WITH(meter.run(3, task), "of the first");
    CHECK(done == 2);
}
