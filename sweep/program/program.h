// The program: one verb a file in verbs/.
#pragma once
#include "sweep/program/verbs/exit_code.h"

namespace stickslip {

class Cluster;

/// Runs one command line to its end and returns its exit code. With a cluster, every rank calls it and sweeps together.
int run_program(int argc, char** argv, Cluster* cluster = nullptr);

}  // namespace stickslip
