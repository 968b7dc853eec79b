// Small multiples: one stability map at several values of a third axis and a fourth.
#pragma once
#include "analysis/results/stability_map.h"

namespace stickslip {

/// A stability map at one value of a third axis, and of a fourth where there is one.
struct StabilityPanel {
    double across = 0, up = 0;
    std::vector<double> abscissa;  ///< as in StabilityMap
    std::vector<Region> region;
    std::vector<Curve> curves;
};

/// Small multiples: the same map again and again, along a third axis and a fourth, with one scale and one legend.
struct StabilityPanels {
    std::string title, fixed;
    Units units;
    Axis x, y;
    Axis across, up;                     ///< with the values shown; the fourth one's name is empty where there is none
    std::vector<StabilityPanel> panels;  ///< row-major: index = i_up * across.values.size() + i_across
    DesignPoint design;                  ///< marked in the panel that it belongs to
    std::size_t own = 0;                 ///< which panel that is
    bool has_design = false;
    std::string command;  ///< as in StabilityMap; {depth} is `across`, {up} the fourth
};

}  // namespace stickslip
