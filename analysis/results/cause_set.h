// Causes that stay possible, with a promise how often those that act are among them. Plain data, the fields of `set` in
// diagnosis.json.
#pragma once
#include <string>
#include <vector>

namespace stickslip {

struct CauseSet {
    /// For whom the promise holds: for joints with each single cause, or for joints drawn as the calibration's were.
    enum class Holds { every_cause, population };

    double coverage = 0;    ///< share of such joints whose every cause is in their set, at least
    double confidence = 0;  ///< that the calibration's cases were not better than the population by luck
    Holds holds = Holds::population;
    std::vector<std::vector<std::string>> names;  ///< one cause each, the likeliest first; several may act
    bool no_gap = false;
    bool none_of_these = false;             ///< a cause outside the catalogue
    std::vector<std::string> uncalibrated;  ///< too few cases: kept (every_cause), or without a promise (population)
    int cases = 0;                          ///< of the calibration
    std::string population;                 ///< how its cases were drawn

    std::size_t size() const { return names.size() + no_gap + none_of_these; }
};

/// "every-cause" or "population".
inline std::string name_of(CauseSet::Holds holds)
{
    return holds == CauseSet::Holds::every_cause ? "every-cause" : "population";
}

}  // namespace stickslip
