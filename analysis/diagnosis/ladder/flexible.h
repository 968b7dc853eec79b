// What any model could explain: what a joint's model leaves, regressed on a flexible force of its own signals, on rows
// that the regression has not seen.
#pragma once
#include "analysis/diagnosis/ladder/windows.h"

#include <string_view>
#include <utility>

namespace stickslip::gap {

struct Flexible {
    double before = 0, after = 0;  ///< squares beyond the noise, over all held-out rows
    /// What a force of one kind of signal alone takes of `before`: "position", "direction", "velocity", "history",
    /// "acceleration", "effort", "time"; largest first.
    std::vector<std::pair<std::string_view, double>> alone;

    double share_of(std::string_view signal) const;
};

/// The force is a sum of functions: smooth in position, in velocity, in time and in the drive's effort, of position
/// times direction, of play operators on position (Visintin 1994), of relaxations of direction and
/// velocity, and of the acceleration; waves that stand out in time or in position are added. Every function is sent
/// through the observer's own error equation, e'' + 2ζω e' + ω² e = f/J, so that it is compared with what the fits
/// compare; while the joint sticks no force moves it. Ridge regression (Hoerl and Kennard 1970), its weight chosen on
/// the same folds. `x` are the model's numbers in every fold.
Flexible regress(const HeldOutData& data, const Scales& scales, const Candidate& candidate,
                 const std::array<Eigen::VectorXd, HeldOutData::folds>& x, const Eigen::VectorXd& x_of_all);

}  // namespace stickslip::gap
