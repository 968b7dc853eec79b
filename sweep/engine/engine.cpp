#include "sweep/engine/engine.h"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <chrono>
#include <cstring>
#include <limits>
#include <mutex>

namespace stickslip {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// What the workers of one computation share.
class Computation {
  public:
    Computation(const Plan& plan, const Joint& base, const EvaluateChunk& evaluate, ChunkSource& source,
                Workload workload, Journal& journal, ChunkIndex& index, const EngineOptions& options)
        : plan_(plan),
          base_(base),
          evaluate_(evaluate),
          source_(source),
          workload_(workload),
          journal_(journal),
          index_(index),
          options_(options),
          format_(plan.nonlinear)
    {
    }

    /// The life of one thread: claim, compute, journal.
    void work()
    {
        PointCursor cursor(base_, plan_.axes);
        std::vector<PointResult> rows;
        std::vector<std::byte> record;
        while (!stopped()) {
            const auto chunk = source_.next();
            if (!chunk) return;
            const PointRange range = plan_.range(*chunk);
            rows.resize(range.count);
            cursor.seek(range.first);
            evaluate_(cursor, rows);
            encode_record(plan_, format_, *chunk, rows, record);
            if (!keep(*chunk, record)) return;
            points_.fetch_add(range.count, std::memory_order_relaxed);
            report_progress(false);
        }
    }

    ComputeReport report(int threads)
    {
        if (options_.progress) report_progress(true);
        ComputeReport report;
        report.chunks = chunks_;
        report.points = points_;
        report.seconds = seconds_since(start_);
        report.threads = threads;
        if (failure_) {
            report.end = RunEnd::write_failed;
            report.message = fmt::format(
                "the journal cannot be written: {}; the {} points computed so far are safe, run the same "
                "command again to go on",
                failure_.message(), workload_.done + points_);
        } else if (interrupted()) {
            report.end = RunEnd::interrupted;
        }
        return report;
    }

    void journal_closed(std::error_code error)
    {
        if (error && !failure_) failure_ = error;
    }

  private:
    bool interrupted() const { return options_.interrupt && options_.interrupt->load(std::memory_order_relaxed); }
    bool stopped() const { return failed_.load(std::memory_order_relaxed) || interrupted(); }

    bool keep(std::uint64_t chunk, std::span<const std::byte> record)
    {
        RecordHeader header;
        std::memcpy(&header, record.data(), sizeof header);
        const auto written = journal_.append(record);
        const std::scoped_lock lock(index_mutex_);
        if (const auto* error = std::get_if<std::error_code>(&written)) {
            failure_ = *error;
            failed_ = true;
            return false;
        }
        if (chunks_++ == 0) file_ = index_.add_file(journal_.path());
        index_.add(chunk, file_, std::get<std::uint64_t>(written), header.checksum);
        return true;
    }

    void report_progress(bool last)
    {
        if (!options_.progress) return;
        std::unique_lock lock(progress_mutex_, std::defer_lock);
        if (last)
            lock.lock();
        else if (!lock.try_lock())
            return;
        const double elapsed = seconds_since(start_);
        if (!last && elapsed < next_progress_) return;
        next_progress_ = elapsed + options_.progress_seconds;
        const std::uint64_t now = points_.load(std::memory_order_relaxed);
        Progress progress{workload_.done + now, workload_.total, 0, std::numeric_limits<double>::infinity()};
        if (elapsed > 0) progress.rate = static_cast<double>(now) / elapsed;
        if (now > 0) progress.seconds_left = static_cast<double>(progress.total - progress.done) / progress.rate;
        options_.progress(progress);
    }

    const Plan& plan_;
    const Joint& base_;
    const EvaluateChunk& evaluate_;
    ChunkSource& source_;
    const Workload workload_;
    Journal& journal_;
    ChunkIndex& index_;
    const EngineOptions& options_;
    const RowFormat format_;
    const Clock::time_point start_ = Clock::now();

    std::atomic<std::uint64_t> points_{0};
    std::atomic<bool> failed_{false};
    std::mutex index_mutex_;  ///< guards the four below and entries into the index
    std::uint64_t chunks_ = 0;
    std::uint32_t file_ = 0;
    std::error_code failure_;
    std::mutex progress_mutex_;
    double next_progress_ = 0;
};

}  // namespace

ComputeReport compute(const Plan& plan, const Joint& base, const EvaluateChunk& evaluate, ChunkSource& source,
                      Workload workload, Journal& journal, ChunkIndex& index, const EngineOptions& options)
{
    const int threads = options.threads > 0 ? options.threads : tbb::info::default_concurrency();
    // TBB gives no more threads than cores unless it is told that more are meant.
    const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    Computation computation(plan, base, evaluate, source, workload, journal, index, options);
    arena.execute([&] {
        tbb::task_group workers;
        for (int i = 0; i < threads; ++i) workers.run([&] { computation.work(); });
        workers.wait();
    });
    computation.journal_closed(journal.close());
    return computation.report(threads);
}

}  // namespace stickslip
