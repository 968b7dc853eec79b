// Any bytes as the journal of a small sweep: whatever is found in it is what was computed, bit for bit.
#include "sweep/engine/chunk_index.h"
#include "tests/fuzz/input_file.h"
#include "tests/sweep/engine/sample_sweep.h"

#include <cstring>

namespace {

using namespace sample;

/// The sweep, what its chunks hold, and a directory for its journal.
struct Sweep {
    TemporaryDirectory directory;
    const fs::path file = directory / "input.journal";
    const RowFormat format{false};
    Plan plan_ = sample_plan();
    std::vector<std::vector<std::byte>> records;

    /// The corpus holds journals of this plan, whatever build it is read by.
    static Plan sample_plan()
    {
        Plan plan = sample::plan({5, 4}, 3);
        plan.build = "any";
        plan.id = id_of(plan);
        return plan;
    }

    Sweep()
    {
        for (std::uint64_t chunk = 0; chunk < plan_.chunks(); ++chunk) {
            std::vector<PointResult> rows(plan_.range(chunk).count);
            PointCursor cursor(joint(), plan_.axes);
            cursor.seek(plan_.range(chunk).first);
            point_by_point(toy_point)(cursor, rows);
            encode_record(plan_, format, chunk, rows, records.emplace_back());
        }
    }

    /// The journal of the whole sweep, to mutate.
    std::vector<std::uint8_t> journal() const
    {
        const JournalHeader header = journal_header(plan_);
        std::vector<std::uint8_t> bytes(sizeof header);
        std::memcpy(bytes.data(), &header, sizeof header);
        for (const auto& record : records)
            for (const std::byte b : record) bytes.push_back(static_cast<std::uint8_t>(b));
        return bytes;
    }

    void check(std::span<const std::uint8_t> bytes) const
    {
        const fuzz::InputFile input(bytes);
        fs::remove(file);
        fs::create_symlink(input.path(), file);
        ChunkIndex index(plan_);
        ScanReport report;
        try {
            scan_journals(directory.path(), plan_, index, report);
        } catch (const std::runtime_error&) {
            return;  // a journal of another plan
        }
        fuzz::promise(report.damaged_bytes <= bytes.size(), "more damage than bytes");
        ChunkReader reader(plan_, index);
        for (std::uint64_t chunk = 0; chunk < plan_.chunks(); ++chunk) {
            if (!index.has(chunk)) continue;
            const auto found = reader.read(chunk);
            fuzz::promise(std::memcmp(found.data(), records[chunk].data() + sizeof(ChunkHeader), found.size()) == 0,
                          "a chunk that was never computed");
        }
    }
};

const Sweep& sweep()
{
    static const Sweep sweep;
    return sweep;
}

}  // namespace

/// The first byte says what the rest is: a journal as it stands, or edits of a whole one (place, byte; four bytes
/// each), since no fuzzer guesses a checksum.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0) return 0;
    const std::span<const std::uint8_t> rest(data + 1, size - 1);
    if (data[0] % 2 == 0) {
        sweep().check(rest);
        return 0;
    }
    auto journal = sweep().journal();
    for (std::size_t i = 0; i + 4 <= rest.size(); i += 4) {
        const std::size_t place = (rest[i] + 256u * rest[i + 1]) % (journal.size() + 1);
        const auto at = journal.begin() + static_cast<std::ptrdiff_t>(place);
        switch (rest[i + 2] % 4) {
            case 0:
                if (at != journal.end()) *at = rest[i + 3];
                break;
            case 1:
                journal.insert(at, rest[i + 3], 0);
                break;
            case 2:
                journal.erase(at, at + std::min<std::ptrdiff_t>(rest[i + 3], journal.end() - at));
                break;
            default: {
                const std::vector<std::uint8_t> copy(
                    at, at + std::min<std::ptrdiff_t>(8 * rest[i + 3], journal.end() - at));
                journal.insert(journal.end(), copy.begin(), copy.end());
            }
        }
        if (journal.size() > 1u << 16) break;
    }
    sweep().check(journal);
    return 0;
}
