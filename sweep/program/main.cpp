#include "sweep/program/program.h"

int main(int argc, char** argv)
{
    return stickslip::run_program(argc, argv);
}
