// The verbs of the program. Each adds itself to the command line and runs when chosen.
#pragma once
#include <CLI/CLI.hpp>

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

void add_sweep(CLI::App& app, Invocation& invocation);
void add_boundary(CLI::App& app, Invocation& invocation);
void add_design(CLI::App& app, Invocation& invocation);
void add_margins(CLI::App& app, Invocation& invocation);
void add_check(CLI::App& app, Invocation& invocation);
void add_evaluate(CLI::App& app, Invocation& invocation);
void add_export(CLI::App& app, Invocation& invocation);
void add_figures(CLI::App& app, Invocation& invocation);
void add_list(CLI::App& app, Invocation& invocation);
void add_new(CLI::App& app, Invocation& invocation);
void add_convert(CLI::App& app, Invocation& invocation);
void add_import(CLI::App& app, Invocation& invocation);
void add_merge(CLI::App& app, Invocation& invocation);
void add_diagnose(CLI::App& app, Invocation& invocation);
void add_plan(CLI::App& app, Invocation& invocation);
void add_blind(CLI::App& app, Invocation& invocation);
void add_report(CLI::App& app, Invocation& invocation);
void add_completion(CLI::App& app, Invocation& invocation);
void add_man_page(CLI::App& app, Invocation& invocation);
void add_simulate(CLI::App& app, Invocation& invocation);

}  // namespace stickslip
