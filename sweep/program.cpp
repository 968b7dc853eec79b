#include "sweep/program.h"

#include <cstdio>

namespace stickslip {

int run_program(int, char**)
{
    std::puts("stickslip 0.1.0");
    return exit_done;
}

}  // namespace stickslip
