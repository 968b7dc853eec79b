// The verbs before and after a diagnosis: loads of an arm for its records, and diagnoses held against each other.
#pragma once
#include "sweep/program/verbs/verbs.h"

namespace stickslip {

void add_calibrate(CLI::App& app, Invocation& invocation);
void add_compare(CLI::App& app, Invocation& invocation);
void add_arm_load(CLI::App& app, Invocation& invocation);
void add_timeline(CLI::App& app, Invocation& invocation);

}  // namespace stickslip
