// The tables of a page about measured outcomes. Internal to sweep/report/pages.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/outcome_answer.h"

namespace stickslip {

Table laws_table(const gap::OutcomeAnswer& answer);
Table numbers_table(const gap::OutcomeAnswer& answer);
Table rows_table(const gap::OutcomeAnswer& answer);
/// Where the nominal joint is wrong, by settings.
Table settings_table(const gap::OutcomeAnswer& answer);

}  // namespace stickslip
