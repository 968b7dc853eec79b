#include "sweep/report/figures/line_figure.h"

namespace stickslip {

AxisName axis_label(std::string_view name, Quantity quantity, Units units)
{
    return {std::string(name), std::string(unit_of(quantity, units))};
}

Figure line_figure(std::string id, Picture chart, std::string finding, std::string reading)
{
    Figure figure;
    figure.id = std::move(id);
    figure.caption = finding + " " + std::move(reading);
    figure.finding = std::move(finding);
    figure.picture = std::move(chart);
    return figure;
}

}  // namespace stickslip
