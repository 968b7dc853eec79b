// Words on a terminal: in colour where somebody looks, plain where a program reads.
#pragma once
#include "analysis/results/report.h"

#include <string>

namespace stickslip {

/// The text in the colour of its tone, if standard output is a terminal and NO_COLOR is not set.
std::string toned(const std::string& text, Headline::Tone tone);

/// Verdict, alerts and headlines of a report as lines for standard output: the answer without opening the page.
std::string terminal_summary(const Report& report);

/// The answer on standard output, from mark-up: in lines of its width on a terminal.
void print_sentence(const std::string& text);

/// A table on standard output, columns as wide as their longest cell.
void print_table(const Table& table);

}  // namespace stickslip
