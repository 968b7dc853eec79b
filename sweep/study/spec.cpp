#include "sweep/study/spec.h"

#include "analysis/joint/parameters.h"

namespace stickslip {

Joint design_joint(const Spec& spec)
{
    Joint joint = spec.joint;
    for (std::size_t i = 0; i < spec.axes.size(); ++i) {
        const auto& values = spec.axes[i].values;
        const double design = spec.design[i].second;
        number_at(joint, spec.axes[i].path) = is_set(design) ? design : values[values.size() / 2];
    }
    return joint;
}

const Axis* axis_of(const Spec& spec, const std::string& path)
{
    for (const auto& axis : spec.axes)
        if (axis.path == path) return &axis;
    return nullptr;
}

}  // namespace stickslip
