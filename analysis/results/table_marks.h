// What a page shows beside the words of its report: where it leads to, and the shades of its tables.
#pragma once
#include <map>
#include <string>
#include <vector>

namespace stickslip {

struct CellMarks {
    std::vector<std::string> links;           ///< one for each row: the page its first cell leads to, or empty
    std::vector<std::vector<double>> shares;  ///< empty, or as rows: the share of 1 that shades a cell; NaN: none
};

/// A page that this one is a part of, for the head of the page; no address: none.
struct PageAbove {
    std::string title, address;
};

/// By the titles of tables.
using TableMarks = std::map<std::string, CellMarks>;

}  // namespace stickslip
