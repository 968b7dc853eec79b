// The tables of a page about measured outcomes. Internal to sweep/report/pages.
#pragma once
#include "analysis/diagnosis/outcomes/explain.h"
#include "analysis/results/report.h"

#include <string>

namespace stickslip {

/// "k_p" of "control.k_p".
std::string key_of(const std::string& path);

Table laws_table(const gap::OutcomeAnswer& answer);
Table numbers_table(const gap::OutcomeAnswer& answer);
Table rows_table(const gap::OutcomeAnswer& answer);
/// Where the nominal joint is wrong, by settings.
Table settings_table(const gap::OutcomeAnswer& answer);

}  // namespace stickslip
