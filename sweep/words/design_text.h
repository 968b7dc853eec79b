// A design of gains in words, for the page and the terminal.
#pragma once
#include "analysis/results/report.h"
#include "analysis/results/text.h"
#include "sweep/study/design_answer.h"

#include <string>
#include <vector>

namespace stickslip {

/// Numbers of a design with their units.
struct DesignUnits {
    Units units;
    std::string stiffness(double v) const { return with_unit(v, Quantity::position_gain, units, 4); }
    std::string damping(double v) const { return with_unit(v, Quantity::velocity_gain, units, 4); }
    std::string position(double v) const { return with_unit(v, Quantity::position, units); }
    std::string effort(double v) const { return with_unit(v, Quantity::effort, units, 4); }
    std::string velocity(double v) const { return with_unit(v, Quantity::velocity, units); }
};

/// "k_{p} = 20 kN/m, k_{v} = 10 N·s/m"
std::string gains_text(const GainChoice& c, const DesignUnits& u);

/// What is still searched.
std::string stage_text(DesignStage stage);

/// Of a requirement, in words.
std::string requirement_name(const std::string& name);

/// A margin as large as was looked for is at least that large.
std::string margin_text(double margin, const GainDesign& d);

/// A value of a requirement with its unit.
std::string requirement_value(const RequirementReport& d, double value, const DesignAnswer& a, const DesignUnits& u);

/// An optimum at the end of what was searched is one of the search.
std::vector<std::string> ends_of_range(const DesignAnswer& a, const DesignUnits& u);

/// The answer in a few sentences, mark-up: the optimum, or why there is none and what would be feasible.
std::string design_verdict_text(const DesignAnswer& answer);

/// The same, followed by the ends of the searched range on which the optimum lies: the page has alerts for those.
std::string design_text(const DesignAnswer& answer);

/// The Pareto front, least margin first.
Table front_table(const DesignAnswer& answer);

/// The choices side by side, and how each requirement fared.
std::vector<Table> design_tables(const DesignAnswer& answer);

}  // namespace stickslip
