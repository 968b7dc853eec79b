// Walks the points of a plan: a joint of its own whose swept numbers are overwritten in place, so that a point costs a
// few stores instead of a look-up by name.
#pragma once
#include "analysis/joint/parameters.h"
#include "analysis/results/stability_map.h"

#include <cstdint>
#include <span>
#include <vector>

namespace stickslip {

/// One cursor a thread; it holds pointers into its own joint and so cannot be copied. The axes must outlive it.
class PointCursor {
  public:
    /// Every axis path must name a number of the joint, as make_plan has checked; throws std::invalid_argument
    /// otherwise.
    PointCursor(const Joint& base, std::span<const Axis> axes);
    PointCursor(const PointCursor&) = delete;
    PointCursor& operator=(const PointCursor&) = delete;

    /// Goes to the point of that number, row-major, the first axis slowest.
    void seek(std::uint64_t point);

    /// Where it stands.
    std::uint64_t point() const;

    /// Goes to the next point; after the last one to the first.
    void advance()
    {
        for (std::size_t i = wheels_.size(); i-- > 0;) {
            Wheel& wheel = wheels_[i];
            const bool turned_over = ++wheel.at == wheel.values.size();
            if (turned_over) wheel.at = 0;
            wheel.target = wheel.values[wheel.at];
            if (!turned_over) return;
        }
    }

    /// The joint of the current point; changes with the next seek or advance.
    const Joint& joint() const { return joint_; }

  private:
    struct Wheel {
        JointNumber target;
        std::span<const double> values;
        std::size_t at;
    };
    Joint joint_;
    std::vector<Wheel> wheels_;
};

}  // namespace stickslip
