// The tables of a diagnosis: where, which causes, which numbers, how far.
#pragma once
#include "analysis/results/diagnosis.h"
#include "analysis/results/report.h"

namespace stickslip {

/// "asymmetric friction with delay"
std::string together(const std::vector<std::string>& names);
/// "38 %", "–" where there is none.
std::string whole_percent(double part);

/// "commanded effort" of the column effort_command.
std::string signal_words(const std::string& column);
/// "frictional memory: lag" of frictional-memory.lag.
std::string parameter_words(const std::string& name);

Table causes_table(const Diagnosis& d);
Table parameters_table(const Diagnosis& d);
/// What the documented parameters become with the first cause; no rows where it changes none of them.
Table values_table(const Diagnosis& d);
/// "166.9 (166.1 … 167.6) N·s/m", or that the records do not say.
std::string value_text(const SheetValue& value);
Table shares_table(const char* title, const std::vector<Share>& shares);
Table gap_table(const Diagnosis& d);
Table records_table(const Diagnosis& d);
/// How records were held out, in sentences; empty where none were.
std::string method_text(const Diagnosis& d);
/// What was assumed or could not be done; a note that many records share is said once, with their number.
std::vector<std::string> gathered_notes(const Diagnosis& d);

}  // namespace stickslip
