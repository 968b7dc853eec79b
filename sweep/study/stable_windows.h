// The gains with which one joint slides, as a diagnosis reports them without and with its cause.
#pragma once
#include "analysis/base/crossing.h"
#include "analysis/joint/joint.h"
#include "analysis/results/point.h"

#include <cmath>
#include <string>
#include <vector>

namespace stickslip {

/// Linear theory at one velocity. Gains as the drive counts them, which reads and pushes at the encoder's side of a
/// gear.
struct StableWindows {
    double V0 = missing;
    double k_v_min = missing;  ///< of the velocity-only model
    bool stable = false;       ///< with the joint's own gains
    double spectral_abscissa = missing, k_cr = missing;
    std::vector<Interval> k_p;
    std::string refused;  ///< what the theory says against the joint; then all above is missing

    bool known() const { return refused.empty() && !std::isnan(spectral_abscissa); }  ///< there is a verdict
};

/// The joint as it acts at `velocity`, whatever it commands: its sum of gains, counted at the joint's side of a gear.
Joint acting_at(const Joint& joint, double velocity);

/// At `velocity`, whatever the joint commands.
StableWindows stable_windows(const Joint& joint, double velocity);

/// The velocity that the joint commands, else a tenth of the usual speed of its records.
double reported_velocity(const Joint& joint, double usual_speed);

/// At that velocity, or under the ramp of force that the joint commands.
StableWindows own_windows(const Joint& joint, double usual_speed);

/// Both joints of a diagnosis: as documented, and with what was named.
struct WindowsOfBoth {
    StableWindows before, after;
};

/// The stable window over the velocity: that which holds the joint's own gain, or else the first. NaN where it has no
/// such end.
struct WindowEnds {
    std::vector<double> low, high;
};

struct MovedBoundary {
    double velocity = missing;  ///< of both windows; missing where the data show no motion, and then nothing is known
    double own_gain = missing;  ///< k_p of the joint as documented
    WindowsOfBoth at;
    std::vector<double> speeds;  ///< from a hundredth to twice of it, in its direction
    WindowEnds before, after;
};

MovedBoundary moved_boundary(const Joint& before, const Joint& after, double velocity);

}  // namespace stickslip
