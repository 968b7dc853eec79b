#include "sweep/engine/run_sweep.h"

#include "analysis/joint/parameters.h"
#include "sweep/engine/finish.h"
#include "sweep/engine/run_record.h"

#include <memory>
#include <stdexcept>

namespace stickslip {
namespace {

/// The source of a run and what of its work is done already.
std::unique_ptr<ChunkSource> source_for(const Plan& plan, Shard shard, const ChunkIndex& index, Workload& workload)
{
    const IsDone is_done = [&index](std::uint64_t chunk) { return index.has(chunk); };
    const auto count = [&](std::uint64_t chunk) {
        workload.total += plan.range(chunk).count;
        if (index.has(chunk)) workload.done += plan.range(chunk).count;
    };
    if (shard.whole()) {
        for (std::uint64_t chunk = 0; chunk < plan.chunks(); ++chunk) count(chunk);
        return std::make_unique<LocalChunks>(plan.chunks(), is_done);
    }
    auto source = std::make_unique<ShardChunks>(plan.chunks(), shard, is_done);
    for (std::uint64_t k = 0; const auto chunk = source->deal(k); ++k) count(*chunk);
    return source;
}

}  // namespace

RunReport run_sweep(const Plan& wanted, const Joint& base, const EvaluateChunk& evaluate, const RunOptions& options)
{
    if (canonical_text(base) != wanted.joint)
        throw std::invalid_argument("the joint is not the one that the plan was made for");
    const RunDirectory directory(options.directory, wanted, options.shard, options.fresh);
    const Plan& plan = directory.plan();
    const auto journals = directory.file(run_files::journals);

    RunReport report;
    ChunkIndex index(plan);
    if (directory.has_results()) {
        report.resumed_chunks = plan.chunks();
        finish_again(directory, options, report);
    } else {
        scan_journals(journals, plan, index, report.scan);
        report.resumed_chunks = index.count();

        Workload workload;
        const auto source = source_for(plan, options.shard, index, workload);
        Journal journal(journals, plan);
        report.computed = compute(plan, base, evaluate, *source, workload, journal, index, options.engine);
        report.end = report.computed.end;
        report.message = report.computed.message;

        if (options.shard.whole() && index.count() == plan.chunks() && report.end != RunEnd::write_failed)
            finish(directory, index, options, report);
    }
    const std::string record =
        options.shard.whole() ? run_files::run : "run." + std::to_string(options.shard.index) + ".json";
    if (report.end != RunEnd::write_failed)
        write_run_record(directory.file(record.c_str()), plan, report.end, report.computed, report.scan,
                         report.resumed_chunks, options.shard, report.merged);
    return report;
}

}  // namespace stickslip
