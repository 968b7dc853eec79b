// How far a design is from its boundaries: in all directions at once, one parameter at a time, and at worst.
#pragma once
#include "analysis/boundary/kinds/nearest.h"
#include "analysis/results/report.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace stickslip {

/// Everything a question about margins was answered with.
struct MarginsAnswer {
    std::string title, command;
    Joint joint;
    NearestBoundary nearest;
    std::vector<NearestBoundary> alone;  ///< one parameter each
    std::vector<Coordinate> alone_of;
    Uncertainty uncertainty;
    std::optional<WorstCase> worst;
    std::optional<FollowedBoundary> nominal, robust;  ///< over two axes
};

/// The margins of a joint: its natural coordinates for the nearest boundary, those and both gains one by one.
MarginsAnswer margins_of(const Joint& joint);

/// One row a parameter: value, boundary, change.
Table alone_table(const MarginsAnswer& answer);

std::string margins_text(const MarginsAnswer& answer);
Report margins_report(const MarginsAnswer& answer);
nlohmann::ordered_json margins_json(const MarginsAnswer& answer);

}  // namespace stickslip
