// The program: one verb a file in verbs/, exit codes in one place.
#pragma once

namespace stickslip {

/// What the program tells its caller.
enum ExitCode { exit_done = 0, exit_check_failed = 1, exit_bad_input = 2, exit_interrupted = 3, exit_undecided = 4 };

class Cluster;

/// Runs one command line to its end and returns its exit code. With a cluster, every rank calls it and sweeps together.
int run_program(int argc, char** argv, Cluster* cluster = nullptr);

}  // namespace stickslip
