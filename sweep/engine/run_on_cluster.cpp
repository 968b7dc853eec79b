#include "sweep/engine/run_on_cluster.h"

#include "analysis/joint/parameters.h"
#include "sweep/engine/finish.h"
#include "sweep/engine/run_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <stdexcept>

namespace stickslip {
namespace {

/// One bit a chunk, as text for the broadcast.
std::string done_bits(const ChunkIndex& index, std::uint64_t chunks)
{
    std::string bits((chunks + 7) / 8, '\0');
    for (std::uint64_t chunk = 0; chunk < chunks; ++chunk)
        if (index.has(chunk)) bits[chunk / 8] = static_cast<char>(bits[chunk / 8] | 1 << chunk % 8);
    return bits;
}

/// Rank 0's part of the beginning: fills directory, done and the scan of the report, or returns why there is none.
std::string open_directory(const Plan& plan, const RunOptions& options, const std::vector<std::string>& plans,
                           std::optional<RunDirectory>& directory, std::string& done, RunReport& report)
{
    for (std::size_t rank = 1; rank < plans.size(); ++rank)
        if (plans[rank] != plans[0])
            return fmt::format(
                "rank {} would compute another sweep than rank 0: other input, build or kind of CPU\n"
                "  rank 0: {}\n  rank {}: {}",
                rank, plans[0], rank, plans[rank]);
    try {
        directory.emplace(options.directory, plan, Shard{}, options.fresh);
        if (directory->has_results()) {
            report.resumed_chunks = plan.chunks();
            done = std::string((plan.chunks() + 7) / 8, '\xff');
            return {};
        }
        ChunkIndex index(plan);
        scan_journals(directory->file(run_files::journals), plan, index, report.scan);
        report.resumed_chunks = index.count();
        done = done_bits(index, plan.chunks());
        return {};
    } catch (const std::exception& e) {
        return e.what();
    }
}

bool is_set(const std::string& bits, std::uint64_t chunk)
{
    return bits[chunk / 8] >> chunk % 8 & 1;
}

/// Rank 0 tells of all ranks: what has been claimed counts as done, ahead of the truth by what is in flight.
TellProgress progress_of_all(const Plan& plan, const TellProgress& tell, const ClusterChunks& source,
                             std::uint64_t resumed)
{
    if (!tell) return {};
    return [&plan, &source, tell, resumed, start = std::chrono::steady_clock::now()](Progress progress) {
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        progress.total = plan.points;
        progress.done = std::min((resumed + source.claimed()) * plan.chunk_size, plan.points);
        progress.rate = static_cast<double>(source.claimed() * plan.chunk_size) / seconds;
        progress.seconds_left = static_cast<double>(progress.total - progress.done) / progress.rate;
        tell(progress);
    };
}

/// Makes the report of this rank that of all.
void add_up(Cluster& cluster, RunReport& report)
{
    ComputeReport& mine = report.computed;
    const bool failed = cluster.sum(mine.end == RunEnd::write_failed) > 0;
    const bool interrupted = cluster.sum(mine.end == RunEnd::interrupted) > 0;
    mine.end = failed ? RunEnd::write_failed : interrupted ? RunEnd::interrupted : RunEnd::complete;
    for (const std::string& message : cluster.gather(mine.message))
        if (mine.message.empty()) mine.message = message;
    cluster.broadcast(mine.message);
    mine.chunks = cluster.sum(mine.chunks);
    mine.points = cluster.sum(mine.points);
    mine.threads = static_cast<int>(cluster.sum(static_cast<std::uint64_t>(mine.threads)));
    report.end = mine.end;
    report.message = mine.message;
}

/// Rank 0: reads what all ranks have journalled, and ends the sweep if that is everything.
void conclude(const RunDirectory& directory, const RunOptions& options, RunReport& report)
{
    if (directory.has_results()) {
        finish_again(directory, options, report);
    } else {
        ChunkIndex all(directory.plan());
        ScanReport ignored;  // damage was reported when the run began
        scan_journals(directory.file(run_files::journals), directory.plan(), all, ignored);
        if (all.count() == directory.plan().chunks() && report.end != RunEnd::write_failed)
            finish(directory, all, options, report);
        else if (report.end == RunEnd::complete)
            report.end = RunEnd::interrupted;
    }
    if (report.end != RunEnd::write_failed)
        write_run_record(directory.file(run_files::run), directory.plan(), report.end, report.computed, report.scan,
                         report.resumed_chunks, Shard{}, report.merged);
}

}  // namespace

RunReport run_on_cluster(const Plan& plan, const Joint& base, const EvaluateChunk& evaluate, const RunOptions& options,
                         Cluster& cluster)
{
    if (canonical_text(base) != plan.joint)
        throw std::invalid_argument("the joint is not the one that the plan was made for");
    if (!options.shard.whole())
        throw std::invalid_argument("the ranks share the sweep out among themselves: a shard has no place");
    const bool leads = cluster.rank() == 0;
    RunReport report;
    std::optional<RunDirectory> directory;
    std::string refusal, done;
    const auto plans = cluster.gather(to_text(plan.id) + ", " + plan.build);
    if (leads) refusal = open_directory(plan, options, plans, directory, done, report);
    cluster.broadcast(refusal);
    if (!refusal.empty()) throw Refused(refusal);
    cluster.broadcast(done);
    report.resumed_chunks = cluster.sum(report.resumed_chunks);  // rank 0 alone has counted

    const auto journals = std::filesystem::absolute(options.directory) / run_files::journals;
    if (cluster.sum(!std::filesystem::is_directory(journals)) > 0)
        throw Refused(
            fmt::format("not all ranks see {}: it must lie on a file system that they share", journals.string()));

    try {
        const auto source = cluster.chunks(plan.chunks(), [&done](std::uint64_t chunk) { return is_set(done, chunk); });
        EngineOptions engine = options.engine;
        engine.progress =
            leads ? progress_of_all(plan, options.engine.progress, *source, report.resumed_chunks) : TellProgress{};
        Journal journal(journals, plan);
        ChunkIndex mine(plan);
        report.computed = compute(plan, base, evaluate, *source, {plan.points, 0}, journal, mine, engine);
        source->leave();
        add_up(cluster, report);
        if (leads) conclude(*directory, options, report);
    } catch (const std::exception& e) {
        cluster.abort(e.what());  // the other ranks are waiting for this one
    }
    std::string end(1, static_cast<char>(report.end));
    cluster.broadcast(end);
    cluster.broadcast(report.message);
    report.end = static_cast<RunEnd>(end.front());
    return report;
}

}  // namespace stickslip
