// The verbs of the program. Each adds itself to the command line and runs when chosen.
#pragma once
#include "sweep/program/verbs/command_line.h"

#include <atomic>
#include <string>
#include <string_view>

namespace stickslip {

class Cluster;

/// What every verb shares: how it was called and how it ends.
struct Invocation {
    std::string command;  ///< the command line, quoted for a shell
    int exit_code = 0;
    std::atomic<bool> interrupted{false};  ///< set by Ctrl-C
    Cluster* cluster = nullptr;            ///< the other processes that sweep with this one, if any
};

/// Marks the running program as interrupted instead of ending it, so that what is in flight can be kept.
void catch_interrupts(Invocation& invocation);

/// Ends the program at an interruption, with these words and code 3: where nothing more is in flight that could be
/// kept. As every verb begins.
void leave_on_interrupts(std::string_view words);

void add_sweep(CommandLine& line, Invocation& invocation);
void add_boundary(CommandLine& line, Invocation& invocation);
void add_design(CommandLine& line, Invocation& invocation);
void add_margins(CommandLine& line, Invocation& invocation);
void add_check(CommandLine& line, Invocation& invocation);
void add_evaluate(CommandLine& line, Invocation& invocation);
void add_export(CommandLine& line, Invocation& invocation);
void add_figures(CommandLine& line, Invocation& invocation);
void add_list(CommandLine& line, Invocation& invocation);
void add_new(CommandLine& line, Invocation& invocation);
void add_convert(CommandLine& line, Invocation& invocation);
void add_import(CommandLine& line, Invocation& invocation);
void add_merge(CommandLine& line, Invocation& invocation);
void add_diagnose(CommandLine& line, Invocation& invocation);
void add_plan(CommandLine& line, Invocation& invocation);
void add_blind(CommandLine& line, Invocation& invocation);
void add_report(CommandLine& line, Invocation& invocation);
void add_completion(CommandLine& line, Invocation& invocation);
void add_man_page(CommandLine& line, Invocation& invocation);
void add_simulate(CommandLine& line, Invocation& invocation);

}  // namespace stickslip
