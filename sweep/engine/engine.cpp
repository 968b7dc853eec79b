#include "sweep/engine/engine.h"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <cstring>
#include <mutex>

namespace stickslip {
namespace {

/// What the workers of one computation share.
class Computation {
  public:
    Computation(const Plan& plan, const Joint& base, const EvaluateChunk& evaluate, ChunkSource& source,
                Workload workload, Journal& journal, ChunkIndex& index, const EngineOptions& options)
        : plan_(plan),
          base_(base),
          evaluate_(evaluate),
          source_(source),
          journal_(journal),
          index_(index),
          options_(options),
          format_(plan.nonlinear),
          done_before_(workload.done),
          meter_(Progress::Stage::computing, workload, options.progress, options.progress_seconds)
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
            evaluate(cursor, rows);
            encode_record(plan_, format_, *chunk, rows, record);
            if (!keep(*chunk, record)) return;
            meter_.add(range.count);
        }
    }

    ComputeReport report(int threads)
    {
        meter_.end();
        ComputeReport report;
        report.chunks = chunks_;
        report.points = meter_.added();
        report.seconds = meter_.seconds();
        report.threads = threads;
        if (failure_) {
            report.end = RunEnd::write_failed;
            report.message = fmt::format("the journal cannot be written: {}; the {} points computed so far are safe",
                                         failure_.message(), done_before_ + meter_.added());
        } else if (options_.interrupted()) {
            report.end = RunEnd::interrupted;
        }
        return report;
    }

    void journal_closed(std::error_code error)
    {
        if (error && !failure_) failure_ = error;
    }

  private:
    bool stopped() const { return failed_.load(std::memory_order_relaxed) || options_.interrupted(); }

    /// Other workers would go on to the end of the sweep before the exception reaches the caller.
    void evaluate(PointCursor& cursor, std::span<PointResult> rows)
    {
        try {
            evaluate_(cursor, rows);
        } catch (...) {
            failed_ = true;
            throw;
        }
    }

    bool keep(std::uint64_t chunk, std::span<const std::byte> record)
    {
        ChunkHeader header;
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

    const Plan& plan_;
    const Joint& base_;
    const EvaluateChunk& evaluate_;
    ChunkSource& source_;
    Journal& journal_;
    ChunkIndex& index_;
    const EngineOptions& options_;
    const RowFormat format_;
    const std::uint64_t done_before_;

    ProgressMeter meter_;
    std::atomic<bool> failed_{false};
    std::mutex index_mutex_;  ///< guards the three below and entries into the index
    std::uint64_t chunks_ = 0;
    std::uint32_t file_ = 0;
    std::error_code failure_;
};

}  // namespace

ComputeReport compute(const Plan& plan, const Joint& base, const EvaluateChunk& evaluate, ChunkSource& source,
                      Workload workload, Journal& journal, ChunkIndex& index, const EngineOptions& options)
{
    const int threads = options.threads > 0 ? options.threads : tbb::info::default_concurrency();
    // TBB gives no more threads than cores unless more are requested.
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
