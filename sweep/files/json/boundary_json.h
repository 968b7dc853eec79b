// Located boundaries for machines: boundary.json and boundary.csv.
#pragma once
#include "sweep/study/boundary_answer.h"

#include <nlohmann/json.hpp>

#include <string>

namespace stickslip {

/// { "format", "title", "joint": path → value of the design, "lines": [ … ], "curves": [ … ] }; stable names.
nlohmann::ordered_json boundary_json(const BoundaryAnswer& answer);

/// One row a located point: kind, line or curve, piece, x, y, value, low, high, precision, status, method, evaluations.
std::string boundary_csv(const BoundaryAnswer& answer);

}  // namespace stickslip
