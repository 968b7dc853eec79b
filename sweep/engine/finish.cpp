#include "sweep/engine/finish.h"

#include "sweep/engine/netcdf_file.h"

namespace stickslip {

void finish_again(const RunDirectory& directory, const RunOptions& options, RunReport& report)
{
    report.end = RunEnd::complete;  // an interrupt behind the last block interrupts nothing
    report.results = directory.file(run_files::results);
    if (!options.keep_journal) directory.remove_journals();
}

void finish(const RunDirectory& directory, const ChunkIndex& index, const RunOptions& options, RunReport& report)
{
    const auto failed = [&](const std::exception& e) {
        report.end = RunEnd::write_failed;
        report.message = std::string(e.what()) + "; all points are safe in the journal";
    };
    try {
        report.merged = write_results(directory.plan(), index, directory.file(run_files::results), options.engine);
        if (report.merged)
            finish_again(directory, options, report);
        else
            report.end = RunEnd::interrupted;
    } catch (const NetcdfError& e) {
        failed(e);
    } catch (const std::system_error& e) {
        failed(e);
    }
}

}  // namespace stickslip
