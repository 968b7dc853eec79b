// kill -9 at random moments: what a run leaves behind is always whole, and the next one ends with the same bytes.
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <random>
#include <thread>

#include "sample_sweep.h"

using namespace sample;

namespace {

constexpr char child_directory[] = "STICKSLIP_TEST_CHILD_DIRECTORY";

Plan killed_plan()
{
    return plan({60, 50, 40}, 256);
}

/// A few tens of milliseconds of work on two threads, so that kills fall into start, computation and merge alike.
EvaluateChunk slow_evaluation()
{
    return [](PointCursor& cursor, std::span<PointResult> rows) {
        point_by_point(toy_point)(cursor, rows);
        std::this_thread::sleep_for(std::chrono::microseconds(400));
    };
}

/// This program again, in a process of its own that runs only the test case below.
pid_t start_child(const fs::path& directory)
{
    setenv(child_directory, directory.c_str(), 1);
    std::string name = "the child of the kill test";
    char* arguments[] = {const_cast<char*>("child"), name.data(), nullptr};
    pid_t child = 0;
    posix_spawn_file_actions_t quiet;
    posix_spawn_file_actions_init(&quiet);
    posix_spawn_file_actions_addopen(&quiet, STDOUT_FILENO, "/dev/null", 1, 0);
    REQUIRE(posix_spawn(&child, "/proc/self/exe", &quiet, nullptr, arguments, environ) == 0);
    posix_spawn_file_actions_destroy(&quiet);
    unsetenv(child_directory);
    return child;
}

/// How long a child lives that nobody disturbs, start of the process included: it differs with machine, load and build.
std::chrono::microseconds undisturbed(const fs::path& directory)
{
    const auto begin = std::chrono::steady_clock::now();
    int status = 0;
    const pid_t child = start_child(directory);
    REQUIRE(waitpid(child, &status, 0) == child);
    REQUIRE(WIFEXITED(status));
    return std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - begin);
}

}  // namespace

TEST_CASE("the child of the kill test", "[.]")
{
    const char* directory = std::getenv(child_directory);
    if (!directory) return;
    RunOptions options{.directory = directory};
    options.engine.threads = 2;
    REQUIRE(run_sweep(killed_plan(), joint(), slow_evaluation(), options).end == RunEnd::complete);
}

TEST_CASE("a sweep survives kill -9 at random moments", "[slow]")
{
    constexpr unsigned seed = 20261121;
    INFO("seed " << seed);
    std::mt19937 random(seed);
    TemporaryDirectory directory;
    const Plan p = killed_plan();
    run(p, directory / "reference", 2);
    const std::string reference = bytes(directory / "reference/results.nc");
    long life = undisturbed(directory / "undisturbed").count();  // µs

    int kills = 0, in_computation = 0;
    for (int sweep = 0; kills < 20 || in_computation < 8; ++sweep) {
        INFO("kills " << kills << ", of them in the computation " << in_computation);
        REQUIRE(sweep < 40);
        const auto where = directory / std::to_string(sweep);
        const int killed_before = kills;
        bool finished = false;
        for (int attempt = 0; attempt < 100 && !finished; ++attempt) {
            const pid_t child = start_child(where);
            std::this_thread::sleep_for(
                std::chrono::microseconds(std::uniform_int_distribution<long>(0, life)(random)));
            kill(child, SIGKILL);
            int status = 0;
            REQUIRE(waitpid(child, &status, 0) == child);
            finished = WIFEXITED(status);
            if (finished)
                REQUIRE(WEXITSTATUS(status) == 0);
            else
                ++kills;
            if (!finished && fs::exists(where / run_files::journals) && !fs::exists(where / "results.nc"))
                ++in_computation;
            if (fs::exists(where / "results.nc")) REQUIRE((bytes(where / "results.nc") == reference));
        }
        const RunReport last = run(p, where, 1);
        CHECK(last.end == RunEnd::complete);
        CHECK((bytes(where / "results.nc") == reference));
        CHECK_FALSE(fs::exists(where / "results.nc.partial"));
        // the machine was slower when that was measured
        if (kills == killed_before) life = undisturbed(directory / ("again-" + std::to_string(sweep))).count();
    }
}
