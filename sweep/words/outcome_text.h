// The answer to a table of measured outcomes in words.
#pragma once
#include "sweep/study/outcome_answer.h"

#include <string>

namespace stickslip {

/// The answer in one sentence, for the terminal and the top of the page.
std::string outcome_sentence(const gap::OutcomeAnswer& answer);

/// Next experiment in words, mark-up; empty where nothing is left to distinguish.
std::string next_outcome_text(const gap::OutcomeAnswer& answer);

/// "k_p" of "control.k_p".
std::string key_of(const std::string& path);

/// "low k_{p}" of "low k_p": a third of the rows by the values of one of the table's columns, mark-up.
std::string third_text(const std::string& name, const gap::OutcomeAnswer& answer);

}  // namespace stickslip
