// A design of gains as a page, as a table for the terminal and as JSON.
#pragma once
#include "analysis/boundary/kinds/nearest.h"
#include "analysis/design/design.h"
#include "analysis/results/report.h"
#include "analysis/results/trajectory.h"
#include "sweep/study/gain_chart.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace stickslip {

/// A design and what it was asked of.
struct DesignAnswer {
    std::string title, command;
    Joint joint;  ///< as given
    Requirements requirements;
    GainDesign design;
    GainRange range{{missing, missing}, {missing, missing}};  ///< that was searched
    NearestBoundary nearest;                                  ///< of the best gains
    std::optional<GainChart> map;      ///< around all the choices, at the best gains; only for a page
    Trajectory motion, motion_before;  ///< after a disturbance at the commanded velocity: best gains, gains as given
};

/// The answer in a few sentences, mark-up: the optimum, or why there is none and what would be feasible. Followed by
/// which ends of the searched gains the optimum lies on: the page says that in an alert of its own.
std::string design_text(const DesignAnswer& answer);

/// The choices side by side, and how each demand fared.
std::vector<Table> design_tables(const DesignAnswer& answer);

/// `snippets`: the gains to take into the joint file, and the file.
Report design_report(const DesignAnswer& answer, std::vector<Snippet> snippets = {});

nlohmann::ordered_json design_json(const DesignAnswer& answer);

}  // namespace stickslip
