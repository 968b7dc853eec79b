#include "sweep/study/hunting_field.h"

#include "analysis/simulation/set_point/set_point.h"
#include "sweep/study/maps.h"
#include "sweep/study/samples.h"

namespace stickslip {
namespace {

/// Along each axis; a followed place takes milliseconds, one that is simulated tick by tick tens of them.
constexpr int nodes_in_closed_form = 81, nodes_followed = 25, nodes_simulated = 15;

}  // namespace

HuntingField hunting_field(const Joint& design, Axis x, Axis y, const ParallelFor& parallel)
{
    HuntingField field;
    const auto method = set_point(design, quick_set_point).method;
    const bool followed = method == SetPointMethod::event_driven || method == SetPointMethod::presliding;
    const int nodes = method == SetPointMethod::simulated ? nodes_simulated
                      : followed                          ? nodes_followed
                                                          : nodes_in_closed_form;
    x.values = spaced(x.values.front(), x.values.back(), nodes, x.log);
    y.values = spaced(y.values.front(), y.values.back(), nodes, y.log);
    field.places.resize(x.values.size() * y.values.size());
    parallel(y.values.size(), [&](std::size_t j) {
        Joint joint = design;
        const auto u = number_at(joint, x.path), v = number_at(joint, y.path);
        for (std::size_t i = 0; i < x.values.size(); ++i) {
            u = x.values[i], v = y.values[j];
            field.places[j * x.values.size() + i] = set_point(joint, quick_set_point);
        }
    });
    field.design = place_over(design, x, y);
    field.x = std::move(x), field.y = std::move(y);
    return field;
}

}  // namespace stickslip
