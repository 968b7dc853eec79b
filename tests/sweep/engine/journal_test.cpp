// Whatever happens to a journal, a chunk is either there bit for bit or is computed again.
#include "sweep/engine/journal.h"

#include <catch2/catch.hpp>
#include <cstring>
#include <random>

#include "sample_sweep.h"
#include "tests/sweep/file_size_limit.h"

using namespace sample;

namespace {

struct Scan {
    ChunkIndex index;
    ScanReport report;
};

Scan scan(const Plan& p, const fs::path& directory)
{
    Scan scan{ChunkIndex(p), {}};
    scan_journals(directory / run_files::journals, p, scan.index, scan.report);
    return scan;
}

/// Every chunk that is found holds the rows that were computed for it.
void check_contents(const Plan& p, const ChunkIndex& index)
{
    const RowFormat format(p.nonlinear);
    ChunkReader reader(p, index);
    std::vector<std::byte> expected;
    std::vector<PointResult> rows;
    for (std::uint64_t chunk = 0; chunk < p.chunks(); ++chunk) {
        if (!index.has(chunk)) continue;
        rows.resize(p.range(chunk).count);
        PointCursor cursor(joint(), p.axes);
        cursor.seek(p.range(chunk).first);
        point_by_point(toy_point)(cursor, rows);
        encode_record(p, format, chunk, rows, expected);
        const auto found = reader.read(chunk);
        REQUIRE(std::memcmp(found.data(), expected.data() + sizeof(ChunkHeader), found.size()) == 0);
    }
}

/// A finished sweep with one journal; its results.nc is removed, so that a repair has to write it again.
struct Finished {
    TemporaryDirectory directory;
    Plan plan_ = plan({9, 11}, 8);
    fs::path where = directory / "a";
    std::string results, journal;
    fs::path file;

    Finished()
    {
        run_kept(plan_, where);
        results = bytes(where / "results.nc");
        REQUIRE(journals(where).size() == 1);
        file = journals(where).front();
        journal = bytes(file);
    }

    void damage(const std::string& content)
    {
        for (const auto& path : journals(where)) fs::remove(path);
        fs::remove(where / "results.nc");
        set_bytes(file, content);
    }
};

}  // namespace

TEST_CASE("a journal cut anywhere keeps every whole record, and a resumed run ends with the same bytes", "[slow]")
{
    Finished sweep;
    const std::size_t record = record_bytes(RowFormat(false), 8), last = record_bytes(RowFormat(false), 3);
    REQUIRE(sweep.journal.size() == sizeof(JournalHeader) + 12 * record + last);
    for (std::size_t size = 0; size <= sweep.journal.size(); ++size) {
        sweep.damage(sweep.journal.substr(0, size));
        const Scan found = scan(sweep.plan_, sweep.where);
        const std::size_t body = size < sizeof(JournalHeader) ? 0 : size - sizeof(JournalHeader);
        const std::size_t whole = size == sweep.journal.size() ? 13 : body / record;
        REQUIRE(found.report.records == whole);
        REQUIRE(found.index.count() == whole);
        const bool torn =
            size != 0 && size != sweep.journal.size() && (size < sizeof(JournalHeader) || body % record != 0);
        REQUIRE((found.report.damaged_bytes > 0) == torn);
        if (size % 211 == 0) {
            check_contents(sweep.plan_, found.index);
            const RunReport repaired = run_kept(sweep.plan_, sweep.where);
            REQUIRE(repaired.resumed_chunks == whole);
            REQUIRE(repaired.computed.chunks == 13 - whole);
            REQUIRE((bytes(sweep.where / "results.nc") == sweep.results));
        }
    }
}

TEST_CASE("a flipped bit costs one chunk at most and never changes a result", "[slow]")
{
    Finished sweep;
    constexpr unsigned seed = 42;
    INFO("seed " << seed);
    std::mt19937 random(seed);
    for (int trial = 0; trial < 3000; ++trial) {
        std::string damaged = sweep.journal;
        const std::size_t at = random() % damaged.size();
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << random() % 8));
        sweep.damage(damaged);
        const Scan found = scan(sweep.plan_, sweep.where);
        CAPTURE(trial, at);
        REQUIRE(found.index.count() == (at < sizeof(JournalHeader) ? 13u : 12u));
        REQUIRE(found.report.damaged_bytes > 0);
        REQUIRE(found.report.damaged_files.size() == 1);
        if (trial % 100 == 0) {
            check_contents(sweep.plan_, found.index);
            run_kept(sweep.plan_, sweep.where);
            REQUIRE((bytes(sweep.where / "results.nc") == sweep.results));
        }
    }
}

TEST_CASE("blocks that a power cut left empty, and garbage, are skipped", "[slow]")
{
    Finished sweep;
    std::mt19937 random(7);
    for (int trial = 0; trial < 300; ++trial) {
        std::string damaged = sweep.journal;
        const std::size_t from = random() % damaged.size();
        const std::size_t length = std::min<std::size_t>(damaged.size() - from, random() % 3000);
        const bool garbage = trial % 2;
        for (std::size_t i = from; i < from + length; ++i) damaged[i] = garbage ? static_cast<char>(random()) : '\0';
        if (trial % 3 == 0) damaged.append(random() % 5000, garbage ? 'x' : '\0');
        sweep.damage(damaged);
        check_contents(sweep.plan_, scan(sweep.plan_, sweep.where).index);
        if (trial % 10 == 0) {
            run_kept(sweep.plan_, sweep.where);
            REQUIRE((bytes(sweep.where / "results.nc") == sweep.results));
        }
    }
}

TEST_CASE("the same chunk twice is counted if equal and refused if not")
{
    Finished sweep;
    fs::copy(sweep.file, sweep.where / run_files::journals / "copy.journal");
    CHECK(scan(sweep.plan_, sweep.where).report.duplicates == 13);

    const RowFormat format(false);
    std::vector<PointResult> rows(8);
    std::vector<std::byte> record;
    encode_record(sweep.plan_, format, 3, rows, record);
    Journal other(sweep.where / run_files::journals, sweep.plan_);
    CHECK(std::holds_alternative<std::uint64_t>(other.append(record)));
    CHECK_FALSE(other.close());
    CHECK_THROWS_WITH(scan(sweep.plan_, sweep.where), Catch::Contains("chunk 3 has different results"));
}

TEST_CASE("a journal of another sweep is refused")
{
    Finished sweep;
    const Plan other = plan({9, 12}, 8);
    run_kept(other, sweep.directory / "b");
    fs::copy(journals(sweep.directory / "b").front(), sweep.where / run_files::journals / "other.journal");
    fs::remove(sweep.where / "results.nc");
    CHECK_THROWS_WITH(run_kept(sweep.plan_, sweep.where), Catch::Contains("belongs to another sweep"));
}

TEST_CASE("packed rows come back as they were, all columns")
{
    std::mt19937 random(3);
    for (const bool nonlinear : {false, true}) {
        const RowFormat format(nonlinear);
        std::vector<PointResult> rows(17), back(17);
        for (auto& row : rows)
            for (const Column& column : columns()) {
                if (column.nonlinear && !nonlinear) continue;
                if (column.number)
                    row.*column.number = std::ldexp(static_cast<double>(random()), -31);
                else
                    column.set_code(row, random() % 2);
            }
        std::vector<std::byte> block(format.bytes_per_point() * rows.size());
        format.pack(rows, block.data());
        format.unpack(block.data(), back);
        for (std::size_t i = 0; i < rows.size(); ++i)
            for (const Column& column : columns()) {
                if (column.nonlinear && !nonlinear) continue;
                if (column.number)
                    REQUIRE(back[i].*column.number == rows[i].*column.number);
                else
                    REQUIRE(column.code(back[i]) == column.code(rows[i]));
            }
    }
}

TEST_CASE("a full disk ends the run in words, loses nothing, and the same run goes on when there is room")
{
    TemporaryDirectory directory;
    const Plan p = plan({100, 40}, 16);
    run_kept(p, directory / "reference");
    // Room for the plan and part of the journal; then for the journal but not for results.nc, which is larger here.
    const std::size_t journal = fs::file_size(journals(directory / "reference").front());
    REQUIRE(fs::file_size(directory / "reference/results.nc") < journal + 40000);
    for (const int threads : {1, 3}) {
        const auto where = directory / std::to_string(threads);
        RunReport report;
        {
            const FileSizeLimit limit(60000);
            report = run_kept(p, where, threads);
        }
        CHECK(report.end == RunEnd::write_failed);
        CHECK_THAT(report.message, Catch::Contains("journal") && Catch::Contains("safe"));
        CHECK_FALSE(fs::exists(where / "results.nc"));
        CHECK(report.computed.chunks > 50);
        const Scan found = scan(p, where);
        CHECK(found.index.count() == report.computed.chunks);
        CHECK(found.report.damaged_bytes == 0);

        const RunReport rest = run_kept(p, where, threads);
        CHECK(rest.end == RunEnd::complete);
        CHECK(rest.resumed_chunks == report.computed.chunks);
        CHECK((bytes(where / "results.nc") == bytes(directory / "reference/results.nc")));
    }
}

TEST_CASE("a disk that is full when results.nc is written leaves the old one or none")
{
    TemporaryDirectory directory;
    const Plan p = plan({100, 40}, 16);
    run_kept(p, directory / "a");
    const std::string before = bytes(directory / "a/results.nc");
    fs::remove(directory / "a/results.nc");
    RunReport report;
    {
        const FileSizeLimit limit(60000);
        report = run_kept(p, directory / "a");
    }
    CHECK(report.end == RunEnd::write_failed);
    CHECK_THAT(report.message, Catch::Contains("results.nc") && Catch::Contains("safe"));
    CHECK_FALSE(fs::exists(directory / "a/results.nc"));
    CHECK_FALSE(fs::exists(directory / "a/results.nc.partial"));
    CHECK(run_kept(p, directory / "a").computed.chunks == 0);
    CHECK((bytes(directory / "a/results.nc") == before));
}
