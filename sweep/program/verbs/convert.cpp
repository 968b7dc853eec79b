// stickslip convert: a record in CSV from a log. The readers are those of the Python package, so that each format is
// read in one place; this verb finds them.
#include "sweep/files/records/foreign_log.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/log_options.h"
#include "sweep/program/verbs/say.h"
#include "sweep/program/verbs/verbs.h"

#include <memory>
#include <string>

namespace stickslip {
namespace {

struct Options {
    std::string log, csv, joint;
    LogOptions how;
};

int convert(const Options& options, const Invocation& invocation)
{
    const int code = run_conversion(conversion_command(options.log, options.csv, options.joint, options.how));
    if (invocation.interrupted && code != exit_done) return exit_interrupted;
    constexpr int by_python_itself = 1;  // it has no package stickslip, or one that does not start
    if (code == by_python_itself)
        say("convert needs the Python package of stickslip; STICKSLIP_PYTHON=path chooses the Python that has it\n");
    // Python's own codes say that there is no such package, or that a reader failed
    return code == exit_done || code == exit_interrupted ? code : exit_bad_input;
}

}  // namespace

void add_convert(CommandLine& line, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto verb = line.add_verb(
        "convert",
        "Make a record in CSV from a log: bags of ROS 2 and 1, Parquet, SAGE, BAM, .npz, .mat, HDF5, NetCDF");
    verb.add_option("IN", options->log, "log, or folder of SAGE or of a ROS 2 bag")->required();
    verb.add_option("OUT", options->csv, "record to write, .csv or .csv.gz")->required();
    verb.add_option("--joint", options->joint, "name of the joint, where the log has several");
    add_log_options(verb, options->how);
    verb.footer(
        "Example: stickslip convert run.mcap run.csv --joint elbow --command /position_commands\n"
        "Needs the Python package of stickslip (python3 -m stickslip.convert is the same).\n"
        "Exit codes: 0 done, 2 bad input, 3 interrupted: nothing is written.");
    verb.callback([options, &invocation] {
        catch_interrupts(invocation);
        invocation.exit_code = convert(*options, invocation);
    });
}

}  // namespace stickslip
