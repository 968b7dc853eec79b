#include "sweep/engine/cursor.h"

#include <stdexcept>

namespace stickslip {

PointCursor::PointCursor(const Joint& base, std::span<const Axis> axes) : joint_(base)
{
    for (const Axis& axis : axes) {
        if (!find_parameter(joint_, axis.path) || axis.values.empty())
            throw std::invalid_argument("axis \"" + axis.path + "\" cannot be walked");
        wheels_.push_back({number_at(joint_, axis.path), axis.values, 0});
    }
    seek(0);
}

std::uint64_t PointCursor::point() const
{
    std::uint64_t point = 0;
    for (const Wheel& wheel : wheels_) point = point * wheel.values.size() + wheel.at;
    return point;
}

void PointCursor::seek(std::uint64_t point)
{
    for (std::size_t i = wheels_.size(); i-- > 0;) {
        Wheel& wheel = wheels_[i];
        wheel.at = point % wheel.values.size();
        point /= wheel.values.size();
        wheel.target = wheel.values[wheel.at];
    }
}

}  // namespace stickslip
