// A sweep gives the same bytes however it is cut, and refuses what would mix sweeps.
#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "sample_sweep.h"
#include "sweep/engine/results_file.h"

using namespace sample;

TEST_CASE("results.nc has the same bytes for any number of threads, at any time", "[slow]")
{
    const Plan p = plan({13, 7, 11}, 64);
    TemporaryDirectory directory;
    run(p, directory / "1", 1);
    const std::string reference = bytes(directory / "1/results.nc");
    REQUIRE(reference.size() > 13 * 7 * 11 * 36);
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5 would store times in whole seconds
    for (const int threads : {1, 2, 7}) {
        const auto where = directory / ("t" + std::to_string(threads));
        const RunReport report = run(p, where, threads);
        CHECK(report.end == RunEnd::complete);
        CHECK(report.computed.points == 13 * 7 * 11);
        CHECK((bytes(where / "results.nc") == reference));
    }
}

TEST_CASE("shards merge to the bytes of one run, from one directory or several")
{
    const Plan p = plan({13, 7, 11}, 16);
    TemporaryDirectory directory;
    run(p, directory / "whole", 2);
    std::vector<fs::path> parts;
    std::uint64_t points = 0;
    for (std::uint64_t i = 0; i < 7; ++i) {
        parts.push_back(directory / ("part" + std::to_string(i)));
        points += run(p, parts.back(), 2, {i, 7}).computed.points;
        CHECK_FALSE(fs::exists(parts.back() / "results.nc"));
        run(p, directory / "together", 1, {i, 7});
    }
    CHECK(points == p.points);
    CHECK(merge(parts, directory / "merged.nc", true)->points == p.points);
    CHECK(merge({directory / "together"}, directory / "together/results.nc")->points == p.points);
    CHECK((bytes(directory / "merged.nc") == bytes(directory / "whole/results.nc")));
    CHECK((bytes(directory / "together/results.nc") == bytes(directory / "whole/results.nc")));

    parts.pop_back();
    CHECK_THROWS_WITH(merge(parts, directory / "incomplete.nc"), Catch::Contains("chunks are missing"));
    CHECK_FALSE(fs::exists(directory / "incomplete.nc"));
}

TEST_CASE("shards share the chunks evenly and each chunk once")
{
    for (const std::uint64_t chunks : {1ull, 2ull, 6ull, 97ull, 4096ull, 10007ull})
        for (const std::uint64_t count : {1ull, 2ull, 7ull, 64ull}) {
            std::vector<int> seen(chunks, 0);
            std::uint64_t least = chunks, most = 0;
            for (std::uint64_t i = 0; i < count; ++i) {
                ShardChunks shard(chunks, {i, count}, [](std::uint64_t) { return false; });
                std::uint64_t mine = 0;
                while (const auto chunk = shard.next()) ++seen.at(*chunk), ++mine;
                least = std::min(least, mine);
                most = std::max(most, mine);
            }
            CAPTURE(chunks, count);
            CHECK(most - least <= 1);
            CHECK(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; }));
        }
}

TEST_CASE("an interrupted sweep stops behind the chunks in flight and resumes to the same bytes")
{
    const Plan p = plan({40, 40}, 16);
    TemporaryDirectory directory;
    run(p, directory / "reference");
    for (const int threads : {1, 3}) {
        const auto where = directory / ("cut" + std::to_string(threads));
        std::atomic<bool> interrupt = false;
        std::atomic<int> evaluated = 0;
        RunOptions options;
        options.directory = where;
        options.engine.threads = threads;
        options.engine.interrupt = &interrupt;
        const auto evaluate = point_by_point([&](const Joint& joint) {
            if (++evaluated == 333) interrupt = true;
            return toy_point(joint);
        });
        const RunReport cut = run_sweep(p, joint(), evaluate, options);
        CHECK(cut.end == RunEnd::interrupted);
        CHECK(cut.computed.points >= 333);
        CHECK(cut.computed.points < 333 + 16 * static_cast<std::uint64_t>(threads + 1));
        CHECK(cut.computed.points == static_cast<std::uint64_t>(evaluated));
        CHECK_FALSE(fs::exists(where / "results.nc"));

        interrupt = false;
        const RunReport rest = run_sweep(p, joint(), evaluate, options);
        CHECK(rest.end == RunEnd::complete);
        CHECK(rest.resumed_chunks == cut.computed.chunks);
        CHECK(rest.computed.chunks == p.chunks() - cut.computed.chunks);
        CHECK((bytes(where / "results.nc") == bytes(directory / "reference/results.nc")));
    }
}

TEST_CASE("an interrupt while results.nc is written leaves none, and the next run writes it without computing")
{
    const Plan p = plan({500, 20, 20});
    TemporaryDirectory directory;
    std::atomic<bool> interrupt = false;
    RunOptions options{.directory = directory / "a"};
    options.engine.interrupt = &interrupt;
    options.engine.progress_seconds = 0;
    options.engine.progress = [&](const Progress& progress) {
        CHECK(progress.done <= progress.total);
        if (progress.stage == Progress::Stage::writing_results) interrupt = true;
    };
    const RunReport cut = run_sweep(p, joint(), point_by_point(toy_point), options);
    CHECK(cut.end == RunEnd::interrupted);
    CHECK(cut.computed.points == p.points);
    CHECK_FALSE(fs::exists(directory / "a/results.nc"));
    CHECK_FALSE(fs::exists(directory / "a/results.nc.partial"));

    const RunReport rest = run(p, directory / "a");
    CHECK(rest.computed.points == 0);
    CHECK(rest.end == RunEnd::complete);
    CHECK(ResultsFile(rest.results).points() == p.points);
}

TEST_CASE("the journal goes once the results are whole, unless it is to be kept, and nothing is computed again")
{
    const Plan p = plan({13, 7, 11}, 16);
    TemporaryDirectory directory;
    const auto where = directory / "a", kept = directory / "kept";
    CHECK(run_kept(p, kept, 2).merged);
    CHECK(journals(kept).size() == 1);
    CHECK(run(p, where, 2).merged);
    CHECK_FALSE(fs::exists(where / run_files::journals));
    CHECK((bytes(where / "results.nc") == bytes(kept / "results.nc")));

    for (const Shard shard : {Shard{}, Shard{0, 2}}) {
        const RunReport again = run(p, where, 2, shard);
        CHECK(again.end == RunEnd::complete);
        CHECK(again.computed.points == 0);
        CHECK(again.resumed_chunks == p.chunks());
        CHECK_FALSE(fs::exists(where / run_files::journals));
    }
    // a kill between the last byte of the results and the removal
    fs::copy(kept / run_files::journals, where / run_files::journals);
    CHECK(run(p, where).computed.points == 0);
    CHECK_FALSE(fs::exists(where / run_files::journals));
    CHECK((bytes(where / "results.nc") == bytes(kept / "results.nc")));

    fs::remove(where / "results.nc");
    CHECK(run(p, where).computed.points == p.points);
    CHECK((bytes(where / "results.nc") == bytes(kept / "results.nc")));
}

TEST_CASE("the journals of shards go with their merge, and a second merge finds it done")
{
    const Plan p = plan({13, 7}, 16);
    TemporaryDirectory directory;
    const std::vector<fs::path> parts{directory / "a", directory / "b"};
    for (std::uint64_t i = 0; i < 2; ++i) run(p, parts[i], 1, {i, 2});
    CHECK(merge(parts, parts[0] / "results.nc"));
    for (const auto& part : parts) CHECK_FALSE(fs::exists(part / run_files::journals));
    CHECK_FALSE(merge(parts, parts[0] / "results.nc"));
    CHECK_THROWS_WITH(merge(parts, directory / "other.nc"), Catch::Contains("chunks are missing"));
    CHECK(ResultsFile(parts[0] / "results.nc").points() == p.points);
}

TEST_CASE("a finished sweep is not computed again, and its results are written again only if they are gone")
{
    const Plan p = plan({10, 10}, 16);
    TemporaryDirectory directory;
    run_kept(p, directory / "a");
    const std::string before = bytes(directory / "a/results.nc");
    RunReport again = run_kept(p, directory / "a");
    CHECK(again.computed.points == 0);
    CHECK_FALSE(again.merged);
    CHECK(again.results == fs::absolute(directory / "a/results.nc"));
    fs::remove(directory / "a/results.nc");
    again = run_kept(p, directory / "a");
    CHECK(again.computed.points == 0);
    CHECK(again.merged);
    CHECK((bytes(directory / "a/results.nc") == before));
}

TEST_CASE("another sweep, another build and a second run are refused with the way out, and nothing is touched")
{
    const Plan p = plan({10, 10}, 16);
    TemporaryDirectory directory;
    const auto where = directory / "a";
    run(p, where);
    const std::string before = bytes(where / "results.nc");
    const auto refusal = [&](const Plan& other) {
        try {
            run(other, where);
        } catch (const Refused& e) {
            CHECK((bytes(where / "results.nc") == before));
            return std::string(e.what());
        }
        return std::string();
    };

    CHECK_THAT(refusal(plan({10, 11}, 16)),
               Catch::Contains("another axis \"control.k_v\"") && Catch::Contains("--fresh"));
    CHECK_THAT(refusal(plan({10}, 16)), Catch::Contains("other axes") && Catch::Contains("--fresh"));
    CHECK_THAT(refusal(plan({10, 10}, 16, "tolerance = 1")),
               Catch::Contains("other options") && Catch::Contains("--fresh"));
    CHECK_THAT(refusal(plan({10, 10}, 32)), Catch::Contains("other options"));

    Plan other_build = p;
    other_build.build = "another compiler";
    other_build.id = id_of(other_build);
    CHECK_THAT(refusal(other_build),
               Catch::Contains("another build") && Catch::Contains("another compiler") && Catch::Contains("--fresh"));
    {
        const RunDirectory busy(where);
        CHECK_THAT(refusal(p), Catch::Contains("another run is working") && Catch::Contains("-o"));
    }
    CHECK(run(plan({10, 11}, 16), where, 1, {}, true).computed.points == 110);  // the way out
    CHECK(ResultsFile(where / "results.nc").points() == 110);
}

TEST_CASE("the same shard twice at once is refused, two shards are not")
{
    const Plan p = plan({10, 10}, 16);
    TemporaryDirectory directory;
    const RunDirectory one(directory / "a", p, {0, 2}, false);
    CHECK_THROWS_AS(RunDirectory(directory / "a", p, {0, 2}, false), Refused);
    CHECK_NOTHROW(RunDirectory(directory / "a", p, {1, 2}, false));
    CHECK_THROWS_AS(RunDirectory(directory / "a", p, {}, false), Refused);
    CHECK_THROWS_AS(RunDirectory(directory / "b", p, {0, 2}, true), Refused);
}

TEST_CASE("a sweep that the disk cannot hold is refused with its size before it starts, a small shard of it is not")
{
    const Plan p = plan({1000, 1000, 1000, 1000}, 1u << 20);  // 36 TB of results, as much of journals
    TemporaryDirectory directory;
    try {
        run(p, directory / "a");
        FAIL("this disk holds 72 TB: the test needs a larger sweep");
    } catch (const Refused& e) {
        CHECK_THAT(e.what(), Catch::Contains("about 36 TB of results and 4.7 days of one core") &&
                                 Catch::Contains("72 TB more") && Catch::Contains("-o"));
    }
    CHECK_FALSE(fs::exists(directory / "a" / run_files::plan));  // or a smaller sweep would be refused next
    CHECK(run(plan({10, 10}, 16), directory / "a").computed.points == 100);
    CHECK_NOTHROW(RunDirectory(directory / "b", p, {0, 1'000'000}, false));  // 36 MB
}

TEST_CASE("results of unknown origin and a damaged plan are not overwritten")
{
    const Plan p = plan({10, 10}, 16);
    TemporaryDirectory directory;
    fs::create_directories(directory / "a");
    set_bytes(directory / "a/results.nc", "precious");
    CHECK_THROWS_AS(run(p, directory / "a"), Refused);
    CHECK((bytes(directory / "a/results.nc") == "precious"));

    run(p, directory / "b");
    std::string text = bytes(directory / "b/plan.json");
    text.replace(text.find("\"chunk_size\": 16"), 16, "\"chunk_size\": 17");
    set_bytes(directory / "b/plan.json", text);
    CHECK_THROWS_WITH(run(p, directory / "b"),
                      Catch::Contains("does not agree with its id") && Catch::Contains("--fresh"));
}

TEST_CASE("plans of every shape run: no axis, one point, one axis, five axes")
{
    TemporaryDirectory directory;
    const std::vector<std::vector<std::size_t>> shapes{{}, {1}, {5}, {1, 1, 1}, {2, 3, 4, 5, 6}, {1000}, {3, 1, 200}};
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const Plan p = plan(shapes[i]);
        const auto where = directory / std::to_string(i);
        CHECK(run(p, where, 2).end == RunEnd::complete);
        const ResultsFile results(where / "results.nc");
        CHECK(results.points() == p.points);
        const auto k_v_min = results.numbers("k_v_min"), k_cr = results.numbers("k_cr");
        const auto region = results.codes("region");
        PointCursor cursor(joint(), p.axes);
        for (std::uint64_t k = 0; k < p.points; ++k, cursor.advance()) {
            const PointResult expected = toy_point(cursor.joint());
            REQUIRE(k_v_min[k] == expected.k_v_min);
            REQUIRE((k_cr[k] == expected.k_cr || (std::isnan(k_cr[k]) && std::isnan(expected.k_cr))));
            REQUIRE(region[k] == static_cast<std::uint8_t>(expected.region));
        }
    }
}

TEST_CASE("an evaluation that throws ends the run with its message and keeps what was journalled")
{
    const Plan p = plan({40, 40}, 16);
    TemporaryDirectory directory;
    RunOptions options{.directory = directory / "a"};
    options.engine.threads = 2;
    std::atomic<int> evaluated = 0;
    const auto evaluate = point_by_point([&](const Joint& joint) {
        const int number = ++evaluated;
        if (number == 500) throw std::runtime_error("evaluation failed");
        if (number > 500)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));  // or it ends before it can hear of it
        return toy_point(joint);
    });
    CHECK_THROWS_WITH(run_sweep(p, joint(), evaluate, options), "evaluation failed");
    CHECK(evaluated < 1000);  // the other thread stops too
    CHECK(run(p, directory / "a").resumed_chunks >= 500 / 16 - 2);
}

TEST_CASE("progress ends at the total, never runs backwards and is throttled")
{
    const Plan p = plan({100, 100}, 16);
    TemporaryDirectory directory;
    std::vector<Progress> seen;
    RunOptions options{.directory = directory / "a"};
    options.engine.threads = 3;
    options.engine.progress = [&](const Progress& progress) { seen.push_back(progress); };
    options.engine.progress_seconds = 1e9;
    run_sweep(p, joint(), point_by_point(toy_point), options);
    REQUIRE(seen.size() == 4);  // the first and the end of both stages
    for (const Progress& last : {seen[1], seen[3]}) {
        CHECK(last.done == p.points);
        CHECK(last.total == p.points);
    }
    CHECK(seen[0].done <= seen[1].done);
    CHECK(seen[3].stage == Progress::Stage::writing_results);
}
