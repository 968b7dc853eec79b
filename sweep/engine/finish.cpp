#include "sweep/engine/finish.h"

#include "sweep/engine/netcdf_file.h"

namespace stickslip {
namespace {

/// results.nc appears only when it is whole, so one that names this plan needs no second writing.
bool holds_results(const std::filesystem::path& path, const Plan& plan)
{
    if (!std::filesystem::exists(path)) return false;
    try {
        return NetcdfFile::open(path).text(global_attribute, "plan_id") == to_text(plan.id);
    } catch (const NetcdfError&) {
        return false;
    }
}

}  // namespace

void finish(const RunDirectory& directory, const ChunkIndex& index, const EngineOptions& options, RunReport& report)
{
    const auto results = directory.file(run_files::results);
    const auto failed = [&](const std::exception& e) {
        report.end = RunEnd::write_failed;
        report.message = std::string(e.what()) + "; all points are safe in the journal";
    };
    try {
        if (report.computed.chunks > 0 || !holds_results(results, directory.plan())) {
            report.merged = write_results(directory.plan(), index, results, options);
            if (!report.merged) {
                report.end = RunEnd::interrupted;
                return;
            }
        }
        report.end = RunEnd::complete;  // an interrupt behind the last block interrupts nothing
        report.results = results;
    } catch (const NetcdfError& e) {
        failed(e);
    } catch (const std::system_error& e) {
        failed(e);
    }
}

}  // namespace stickslip
