#include "sweep/engine/merge.h"

#include "sweep/engine/hyperslab.h"
#include "sweep/engine/results_layout.h"
#include "sweep/engine/run_directory.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <netcdf.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <deque>

namespace stickslip {
namespace {

namespace fs = std::filesystem;

/// Large enough that the library's cost per call does not show, small enough for a core's cache.
constexpr std::uint64_t points_per_block = 65536;

/// Rows of consecutive chunks, column by column, on their way into the file.
class Block {
  public:
    Block(const RowFormat& format, std::uint64_t capacity)
        : format_(format),
          numbers_(format.numbers().size(), std::vector<double>(capacity)),
          codes_(format.codes().size(), std::vector<signed char>(capacity))
    {
    }

    void start_at(std::uint64_t first) { range_ = {first, 0}; }

    std::uint64_t size() const { return range_.count; }

    void append(std::span<const std::byte> rows)
    {
        const std::size_t count = rows.size() / format_.bytes_per_point();
        for (std::size_t i = 0; i < numbers_.size(); ++i)
            std::memcpy(numbers_[i].data() + range_.count, rows.data() + format_.number_offset(i, count),
                        count * sizeof(double));
        for (std::size_t i = 0; i < codes_.size(); ++i)
            std::memcpy(codes_[i].data() + range_.count, rows.data() + format_.code_offset(i, count), count);
        range_.count += count;
    }

    void count_codes(std::vector<CodeCounts>& counts) const
    {
        for (std::size_t i = 0; i < codes_.size(); ++i)
            for (std::uint64_t k = 0; k < range_.count; ++k) ++counts[i].count[static_cast<std::uint8_t>(codes_[i][k])];
    }

    void write(const NetcdfFile& file, const ResultsVariables& variables, std::span<const std::size_t> shape) const
    {
        std::uint64_t done = 0;
        for (const Hyperslab& slab : hyperslabs(shape, range_)) {
            for (std::size_t i = 0; i < numbers_.size(); ++i)
                file.check(nc_put_vara_double(file.id(), variables.numbers[i], slab.start.data(), slab.count.data(),
                                              numbers_[i].data() + done),
                           "write rows");
            for (std::size_t i = 0; i < codes_.size(); ++i)
                file.check(nc_put_vara_schar(file.id(), variables.codes[i], slab.start.data(), slab.count.data(),
                                             codes_[i].data() + done),
                           "write rows");
            done += slab.points();
        }
    }

  private:
    const RowFormat& format_;
    std::vector<std::vector<double>> numbers_;
    std::vector<std::vector<signed char>> codes_;
    PointRange range_;
};

std::vector<std::size_t> shape_of(const Plan& plan)
{
    std::vector<std::size_t> shape;
    for (const Axis& axis : plan.axes) shape.push_back(axis.values.size());
    return shape;
}

/// False if it was interrupted.
bool write_rows(const NetcdfFile& file, const Plan& plan, const ChunkIndex& index, const EngineOptions& options,
                MergeReport& report)
{
    const RowFormat format(plan.nonlinear);
    const ResultsVariables variables = define_results(file, plan, format);
    for (const Column* column : format.codes()) report.codes.push_back({std::string(column->name), {}});

    const std::vector<std::size_t> shape = shape_of(plan);
    const std::uint64_t chunks_per_block = std::max<std::uint64_t>(1, points_per_block / plan.chunk_size);
    Block block(format, std::min(plan.points, chunks_per_block * plan.chunk_size));
    ChunkReader reader(plan, index);
    ProgressMeter meter(Progress::Stage::writing_results, {plan.points, 0}, options.progress, options.progress_seconds);
    for (std::uint64_t first = 0; first < plan.chunks(); first += chunks_per_block) {
        if (options.interrupted()) return false;
        block.start_at(plan.range(first).first);
        const std::uint64_t end = std::min(first + chunks_per_block, plan.chunks());
        for (std::uint64_t chunk = first; chunk < end; ++chunk) block.append(reader.read(chunk));
        block.write(file, variables, shape);
        block.count_codes(report.codes);
        meter.add(block.size());
    }
    meter.end();
    return true;
}

void sync_file(const fs::path& path)
{
    const FileHandle file = open_file(path, O_RDONLY);
    if (::fsync(file.get()) != 0) throw std::system_error(last_error(), path.string());
}

}  // namespace

std::optional<MergeReport> write_results(const Plan& plan, const ChunkIndex& index, const fs::path& results,
                                         const EngineOptions& options)
{
    const auto start = std::chrono::steady_clock::now();
    const fs::path partial = results.string() + ".partial";
    const auto remove_partial = [&] {
        std::error_code ignored;
        fs::remove(partial, ignored);
    };
    MergeReport report;
    report.points = plan.points;
    try {
        NetcdfFile file = NetcdfFile::create(partial);
        const bool whole = write_rows(file, plan, index, options, report);
        file.close();
        if (!whole) {
            remove_partial();
            return std::nullopt;
        }
        sync_file(partial);
        fs::rename(partial, results);
        sync_directory(fs::absolute(results).parent_path());
    } catch (...) {
        remove_partial();
        throw;
    }
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return report;
}

std::optional<MergeReport> merge(const std::vector<fs::path>& directories, const fs::path& results, bool keep_journals)
{
    if (directories.empty()) throw Refused("nothing to merge: no directory is given");
    std::deque<RunDirectory> locked;
    for (const fs::path& path : directories) locked.emplace_back(path);
    const Plan& plan = locked.front().plan();
    for (const RunDirectory& other : locked)
        if (other.plan().id != plan.id)
            throw Refused(fmt::format("{} and {} hold different sweeps", locked.front().file("").parent_path().string(),
                                      other.file("").parent_path().string()));
    ChunkIndex index(plan);
    ScanReport scan;
    for (const RunDirectory& directory : locked) scan_journals(directory.file(run_files::journals), plan, index, scan);
    const std::uint64_t found = index.count();
    if (found < plan.chunks() && holds_results(results, plan)) return std::nullopt;
    if (found < plan.chunks())
        throw Refused(
            fmt::format("{} of {} chunks are missing{}; run the sweep (or the shards that lack) again, then merge",
                        plan.chunks() - found, plan.chunks(),
                        scan.damaged_bytes ? fmt::format(" ({} damaged bytes were skipped)", scan.damaged_bytes) : ""));
    const auto report = write_results(plan, index, fs::absolute(results));  // nothing can interrupt it
    if (!keep_journals)
        for (const RunDirectory& directory : locked) directory.remove_journals();
    return report;
}

}  // namespace stickslip
