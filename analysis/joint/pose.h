// Where the other joints of a robot stand: inertia and gravity of this one follow from it.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "analysis/base/field.h"

namespace stickslip {

struct Joint;

/// Another joint of the robot, and where its description lets it go.
struct RobotNeighbour {
    std::string name;                            ///< as the description has it
    Quantity quantity = Quantity::angle;         ///< angle [rad] where it turns, length [m] where it slides
    double lower = -infinity, upper = infinity;  ///< rad or m
};

/// What a robot makes of one of its joints at every pose of the others.
class PosedDynamics {
  public:
    PosedDynamics(std::vector<RobotNeighbour> around, std::string identity)
        : neighbours(std::move(around)), id(std::move(identity))
    {
    }
    PosedDynamics(const PosedDynamics&) = delete;
    PosedDynamics& operator=(const PosedDynamics&) = delete;
    virtual ~PosedDynamics() = default;

    /// Gives the joint the inertia and gravity that it has there; one coordinate for each of `neighbours`.
    virtual void apply(const std::vector<double>& coordinates, Joint& joint) const = 0;

    const std::vector<RobotNeighbour> neighbours;
    const std::string id;  ///< equal ids: equal numbers at every pose
};

/// The pose at which a joint stands in its robot.
struct Pose {
    std::shared_ptr<const PosedDynamics> of;  ///< null: the joint stands alone
    std::vector<double> coordinates;          ///< rad or m, one for each of `of->neighbours`

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        for (std::size_t i = 0; i < self.coordinates.size(); ++i) {
            const auto& other = self.of->neighbours[i];
            visit.number(
                {other.name, other.quantity, any_finite, Need::optional, "where this joint of the robot stands"},
                self.coordinates[i]);
        }
    }
};

}  // namespace stickslip
