// What the tables of a page show beside their words.
#pragma once
#include <map>
#include <string>
#include <vector>

namespace stickslip {

struct CellMarks {
    std::vector<std::string> links;           ///< one for each row: the page its first cell leads to, or empty
    std::vector<std::vector<double>> shares;  ///< empty, or as rows: the share of 1 that shades a cell; NaN: none
};

/// By the titles of tables.
using TableMarks = std::map<std::string, CellMarks>;

}  // namespace stickslip
