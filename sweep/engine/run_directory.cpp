#include "sweep/engine/run_directory.h"

#include "sweep/engine/netcdf_file.h"
#include "sweep/engine/plan_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

namespace stickslip {
namespace {

namespace fs = std::filesystem;

constexpr char way_out[] = "choose another directory with -o, or discard what is there with --fresh";

/// A lock that ends with the process, however it ends.
FileHandle take_lock(const fs::path& path, int mode)
{
    FileHandle handle = open_file(path, O_CREAT | O_RDWR);
    if (::flock(handle.get(), mode | LOCK_NB) == 0) return handle;
    if (errno == EWOULDBLOCK)
        throw Refused(fmt::format("another run is working in {}; wait for it, or choose another directory with -o",
                                  path.parent_path().string()));
    // A file system without locks (some cluster mounts): journals are per process and equal chunks are compared, so two
    // runs at once cost time there but do no harm.
    if (errno == ENOLCK || errno == ENOSYS || errno == EOPNOTSUPP) return handle;
    throw std::system_error(last_error(), path.string());
}

/// Says which part of the sweep is another one.
std::string difference(const Plan& found, const Plan& wanted)
{
    if (found.build != wanted.build)
        return fmt::format("was computed by another build or on another kind of CPU\n  there: {}\n  here:  {}\n",
                           found.build, wanted.build);
    if (found.joint != wanted.joint) return "holds a sweep of another joint; ";
    if (found.axes.size() != wanted.axes.size()) return "holds a sweep over other axes; ";
    for (std::size_t i = 0; i < found.axes.size(); ++i)
        if (found.axes[i].path != wanted.axes[i].path || found.axes[i].values != wanted.axes[i].values)
            return fmt::format("holds a sweep with another axis \"{}\"; ", found.axes[i].path);
    return "holds a sweep with other options; ";
}

}  // namespace

Plan read_plan(const fs::path& directory)
{
    const fs::path path = directory / run_files::plan;
    if (!fs::exists(path))
        throw Refused(fmt::format("{} holds no sweep ({} is missing)", directory.string(), run_files::plan));
    try {
        return plan_from_json(read_text(path));
    } catch (const std::runtime_error& e) {
        throw Refused(fmt::format("{}: {}; {}", path.string(), e.what(), way_out));
    }
}

bool holds_results(const fs::path& results, const Plan& plan)
{
    if (!fs::exists(results)) return false;
    try {
        return NetcdfFile::open(results).text(global_attribute, "plan_id") == to_text(plan.id);
    } catch (const NetcdfError&) {
        return false;
    }
}

RunDirectory::RunDirectory(fs::path path, const Plan& plan, Shard shard, bool fresh) : path_(fs::absolute(path))
{
    if (fresh && !shard.whole())
        throw Refused(
            "--fresh with a shard would discard what other shards have done; remove the directory by hand first");
    fs::create_directories(path_);
    lock(shard);
    // refused for want of space, a sweep must not leave its plan behind: a smaller one would be refused for that
    const bool resumes = !fresh && fs::exists(file(run_files::plan));
    if (!resumes) check_space(plan, shard);
    admit(plan, fresh);
    if (resumes) check_space(plan, shard);
    fs::create_directories(file(run_files::journals));
    sync_directory(path_);
}

RunDirectory::RunDirectory(fs::path path) : path_(fs::absolute(path))
{
    if (!fs::is_directory(path_)) throw Refused(fmt::format("{} is not a directory", path_.string()));
    lock({});
    plan_ = read_plan(path_);
}

bool RunDirectory::has_results() const
{
    return holds_results(file(run_files::results), plan_);
}

void RunDirectory::remove_journals() const
{
    std::error_code ignored;
    fs::remove_all(file(run_files::journals), ignored);
}

void RunDirectory::lock(Shard shard)
{
    lock_ = take_lock(file(run_files::lock), shard.whole() ? LOCK_EX : LOCK_SH);
    if (!shard.whole())
        shard_lock_ = take_lock(path_ / fmt::format("{}.{}-of-{}", run_files::lock, shard.index, shard.count), LOCK_EX);
}

void RunDirectory::admit(const Plan& wanted, bool fresh)
{
    const fs::path plan_path = file(run_files::plan);
    if (fresh) {
        fs::remove(plan_path);
        fs::remove_all(file(run_files::journals));
        fs::remove(file(run_files::results));
        fs::remove(file(run_files::run));
    }
    if (!fs::exists(plan_path)) {
        for (const char* leftover : {run_files::results, run_files::journals})
            if (fs::exists(file(leftover)))
                throw Refused(
                    fmt::format("{} holds {} but no {}; {}", path_.string(), leftover, run_files::plan, way_out));
        // Shards may start at the same moment: link(2) lets one of them set the plan, and each compares with what it
        // finds.
        const fs::path draft = path_ / fmt::format("plan.{}.{}", host_name(), ::getpid());
        replace_file(draft, to_json(wanted));
        std::error_code failed;
        fs::create_hard_link(draft, plan_path, failed);
        if (failed && !fs::exists(plan_path)) fs::rename(draft, plan_path);
        fs::remove(draft);
        sync_directory(path_);
    }
    plan_ = read_plan(path_);
    if (plan_.id != wanted.id)
        throw Refused(fmt::format("{} {}{}", path_.string(), difference(plan_, wanted), way_out));
}

void RunDirectory::check_space(const Plan& plan, Shard shard) const
{
    // Journal and results.nc hold every row once, together until the journal goes; what a former run has written
    // already is not asked for again. A shard journals its own part, and results.nc is for the merge to judge.
    if (fs::exists(file(run_files::results))) return;
    const PlanCost cost = plan_cost(static_cast<double>(plan.points), plan.nonlinear);
    double needed = shard.whole() ? 2 * cost.bytes : cost.bytes / static_cast<double>(shard.count);
    if (fs::exists(file(run_files::journals)))
        for (const auto& entry : fs::directory_iterator(file(run_files::journals)))
            needed -= static_cast<double>(entry.file_size());
    const double free = static_cast<double>(fs::space(path_).available);
    if (needed > free)
        throw Refused(
            fmt::format("{} points (about {}) need {} more in {}, which has {} free; take fewer points, or a "
                        "larger disk with -o",
                        plan.points, describe(cost), bytes_text(needed), path_.string(), bytes_text(free)));
}

}  // namespace stickslip
