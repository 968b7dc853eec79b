// How the program ends.
#pragma once

namespace stickslip {

/// What the program tells its caller.
enum ExitCode {
    exit_done = 0,
    exit_check_failed = 1,
    exit_bad_input = 2,
    exit_interrupted = 3,
    exit_undecided = 4,
    exit_insufficient = 4  ///< of a diagnosis: the records say too little
};

}  // namespace stickslip
