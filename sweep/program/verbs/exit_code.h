// How the program ends.
#pragma once

namespace stickslip {

/// What the program tells its caller.
enum ExitCode {
    exit_done = 0,
    exit_not_met = 1,  ///< a check failed, or no gains meet the requirements
    exit_bad_input = 2,
    exit_interrupted = 3,
    exit_undecided = 4,
    exit_insufficient = 4  ///< of a diagnosis: insufficient records
};

}  // namespace stickslip
