#include "sweep/program/program.h"

#include "analysis/simulation/lanes/instructions.h"
#include "sweep/engine/build.h"
#include "sweep/engine/run_directory.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/program/process.h"
#include "sweep/program/verbs/diagnosis_verbs.h"
#include "sweep/program/verbs/folded_text.h"
#include "sweep/program/verbs/say.h"
#include "sweep/program/verbs/usage.h"
#include "sweep/program/verbs/verbs.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace stickslip {
namespace {

/// One argument as a shell would take it back.
std::string quoted(const std::string& argument)
{
    const bool plain =
        !argument.empty() &&
        argument.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,@%") ==
            std::string::npos;
    if (plain) return argument;
    std::string text = "'";
    for (const char c : argument) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

/// Whether the answer reached its reader: a full disk shows only when the buffer is emptied.
bool answer_written()
{
    const bool written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
    if (!written) {
        const int why = errno;
        say("stickslip: the answer could not be written to standard output ({}); {}run the same command again\n",
            std::generic_category().message(why), why == ENOSPC ? "free some space and " : "");
    }
    return written;
}

/// What STICKSLIP_INSTRUCTIONS asks for: the answers of a machine with fewer instructions, on this one.
void keep_to_instructions()
{
    const char* name = std::getenv("STICKSLIP_INSTRUCTIONS");
    if (!name || !*name) return;
    try {
        lanes::use_instructions(name);
    } catch (const std::invalid_argument& e) {
        throw BadInput(std::string("STICKSLIP_INSTRUCTIONS: ") + e.what());
    }
}

void add_verbs(CommandLine& line, Invocation& invocation)
{
    add_sweep(line, invocation);
    add_boundary(line, invocation);
    add_design(line, invocation);
    add_margins(line, invocation);
    add_check(line, invocation);
    add_evaluate(line, invocation);
    add_list(line, invocation);
    add_figures(line, invocation);
    add_merge(line, invocation);
    add_report(line, invocation);
    add_simulate(line, invocation);
    add_new(line, invocation);
    add_convert(line, invocation);
    add_import(line, invocation);
    add_export(line, invocation);
    add_diagnose(line, invocation);
    add_arm_load(line, invocation);
    add_compare(line, invocation);
    add_timeline(line, invocation);
    add_plan(line, invocation);
    add_blind(line, invocation);
    add_calibrate(line, invocation);
    add_completion(line, invocation);
    add_man_page(line, invocation);
}

/// Says what the exception that is being handled means to the caller, and with which code to end. `words` are the
/// arguments.
int exit_after_failure(const CLI::App& app, const std::vector<std::string>& words)
{
    try {
        throw;
    } catch (const CLI::ParseError& e) {
        // help or version, on standard output; what follows a verb that there is not asks for nothing
        const bool of_no_verb = !words.empty() && words[0][0] != '-' && app.get_subcommands().empty();
        if (e.get_exit_code() == 0 && !of_no_verb) {
            std::ostringstream help;
            const int code = app.exit(e, help, help);
            fmt::print("{}", folded_help(help.str(), terminal_columns()));
            return answer_written() ? code : exit_interrupted;
        }
        say("{}", usage_error(app, e, words));
        return exit_bad_input;
    } catch (const BadInput& e) {
        for (const auto& message : e.messages()) say("{}\n", message);
        return exit_bad_input;
    } catch (const Refused& e) {
        say("{}\n", e.what());
        return exit_bad_input;
    } catch (const std::filesystem::filesystem_error& e) {
        say("stickslip: {}: {}\nChoose a directory that exists on a disk and that you may write to, with -o.\n",
            e.path1().string(), e.code().message());
        return exit_bad_input;
    } catch (const std::exception& e) {
        if (std::ferror(stdout) != 0 && !answer_written()) return exit_interrupted;
        say("stickslip: {}\n", e.what());
        return exit_bad_input;
    }
}

}  // namespace

int run_program(int argc, char** argv, Cluster* cluster)
{
    keep_freed_memory();
    keep_streams();
    survive_size_limits();
    leave_on_interrupts("interrupted before the answer was complete\n");
    Invocation invocation;
    const LateInterruptsIgnored ends_before_invocation;
    invocation.cluster = cluster;
    invocation.command = "stickslip";
    for (int i = 1; i < argc; ++i) invocation.command += " " + quoted(argv[i]);

    CLI::App app{
        "stickslip: stick-slip of robot joints.\n"
        "Sweeps the design space of a robot joint, locates its stability boundaries, and diagnoses sim-to-real gaps.\n"
        "All numbers are SI; a revolute joint reads rad, N·m, kg·m² where a prismatic one reads m, N, kg."};
    app.name("stickslip");
    app.set_version_flag("--version", "stickslip " + program_version());
    app.require_subcommand(1);
    app.footer(
        "Exit codes: 0 done, 1 check failed or requirements not met, 2 bad input, 3 interrupted and resumable, 4 "
        "undecided or "
        "insufficient records.\n"
        "Example: stickslip sweep -o out && xdg-open out/report.html");
    CommandLine line(app);
    add_verbs(line, invocation);
    try {
        keep_to_instructions();
        app.parse(argc, argv);
    } catch (...) {
        const int code = exit_after_failure(app, {argv + 1, argv + argc});
        if (!invocation.interrupted) return code;
        say("interrupted before the answer was complete\n");  // and the failure may have come of that
        return exit_interrupted;
    }
    return answer_written() ? invocation.exit_code : exit_interrupted;
}

}  // namespace stickslip
