// Computes the chunks that a source hands out, on the threads of one process, and journals each as soon as it is whole.
#pragma once
#include "sweep/engine/chunk_index.h"
#include "sweep/engine/chunk_source.h"
#include "sweep/engine/cursor.h"
#include "sweep/engine/journal.h"
#include "sweep/engine/plan.h"
#include "sweep/engine/progress.h"

#include <atomic>
#include <functional>
#include <span>
#include <string>

namespace stickslip {

/// Fills the rows of consecutive points, the first being where the cursor stands. Called from many threads at once,
/// each with its own cursor and rows; must depend on the joints alone. Whole chunks, so that lanes can take several
/// joints at a time.
using EvaluateChunk = std::function<void(PointCursor& cursor, std::span<PointResult> rows)>;

/// Makes an EvaluateChunk of `PointResult f(const Joint&)`; f is called directly, not through a pointer, if it is a
/// lambda.
template <class PointFunction>
EvaluateChunk point_by_point(PointFunction f)
{
    return [f](PointCursor& cursor, std::span<PointResult> rows) {
        for (PointResult& row : rows) {
            row = f(cursor.joint());
            cursor.advance();
        }
    };
}

/// How the engine runs; none of it changes a result.
struct EngineOptions {
    int threads = 0;  ///< 0: as many as the process may use
    /// Once true, chunks in flight are finished and journalled and no new one is begun.
    const std::atomic<bool>* interrupt = nullptr;
    TellProgress progress;
    double progress_seconds = 0.1;  ///< least pause between two calls of progress

    bool interrupted() const { return interrupt && interrupt->load(std::memory_order_relaxed); }
};

/// How a computation ended. Everything short of `complete` can be resumed.
enum class RunEnd {
    complete,  ///< the source has no more chunks
    interrupted,
    write_failed  ///< disk full, quota, device error; the journal holds all earlier chunks
};

struct ComputeReport {
    RunEnd end = RunEnd::complete;
    std::string message;                   ///< of write_failed, in words
    std::uint64_t chunks = 0, points = 0;  ///< computed and journalled now
    double seconds = 0;
    int threads = 0;
};

/// Runs until the source is empty, the interrupt is set or the journal fails, and enters each journalled chunk into the
/// index. The same rows whatever the number of threads. Exceptions of `evaluate` end the run and are passed on.
ComputeReport compute(const Plan& plan, const Joint& base, const EvaluateChunk& evaluate, ChunkSource& source,
                      Workload workload, Journal& journal, ChunkIndex& index, const EngineOptions& options);

}  // namespace stickslip
