// The verbs before and after a diagnosis: loads of an arm for its records, and diagnoses held against each other.
#pragma once
#include "sweep/program/verbs/verbs.h"

namespace stickslip {

void add_calibrate(CommandLine& line, Invocation& invocation);
void add_compare(CommandLine& line, Invocation& invocation);
void add_arm_load(CommandLine& line, Invocation& invocation);
void add_timeline(CommandLine& line, Invocation& invocation);

}  // namespace stickslip
