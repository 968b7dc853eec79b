// stickslip convert: a record in CSV from a log. The readers are those of the Python package, so that each format is
// read in one place; this verb finds them.
#include "sweep/files/records/foreign_log.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/log_options.h"
#include "sweep/program/verbs/say.h"
#include "sweep/program/verbs/verbs.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

namespace stickslip {
namespace {

struct Options {
    std::string log, csv, joint;
    LogOptions how;
};

int convert(const Options& options)
{
    auto words = conversion_command(options.log, options.csv, options.joint, options.how);
    std::vector<char*> arguments;
    for (auto& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execvp("python3", arguments.data());
    say("stickslip convert: python3 cannot be started ({}); install it with the Python package of stickslip\n",
        std::strerror(errno));
    return exit_bad_input;
}

}  // namespace

void add_convert(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto* verb = app.add_subcommand(
        "convert", "Make a record in CSV from a log: MCAP, ROS 1 bag, Parquet, SAGE, BAM, .npz, .mat, HDF5, NetCDF");
    verb->add_option("IN", options->log, "log, or folder of SAGE")->required();
    verb->add_option("OUT", options->csv, "record to write, .csv or .csv.gz")->required();
    verb->add_option("--joint", options->joint, "name of the joint, where the log has several");
    add_log_options(*verb, options->how);
    verb->footer(
        "Example: stickslip convert run.mcap run.csv --joint elbow --command /position_commands\n"
        "Needs the Python package of stickslip (python3 -m stickslip.convert is the same).");
    verb->callback([options, &invocation] { invocation.exit_code = convert(*options); });
}

}  // namespace stickslip
