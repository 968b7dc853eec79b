// The best gains of a joint under requirements: what a design run found.
#pragma once
#include <string>
#include <vector>

#include "analysis/results/point.h"

namespace stickslip {

/// What a search for gains is busy with.
enum class DesignStage { best, requirements, front, velocity_only };

/// One pair of gains and what it brings.
struct GainChoice {
    double k_p = missing, k_v = missing;
    double motion_noise = missing;       ///< rms motion of the link that sensor noise causes
    double effort_noise = missing;       ///< rms command that sensor noise causes
    double peak_effort = missing;        ///< |steady effort| and the stated multiple of effort_noise
    double steady_deflection = missing;  ///< how far the link is behind its reference in steady sliding, signed
    double margin = missing;             ///< distance to the nearest boundary; negative: unstable
    double least_velocity = missing;     ///< from here up to V_0 sliding is stable
    double cost = missing;               ///< what was minimised
};

/// A requirement, what was specified, and what the best gains achieve.
struct RequirementReport {
    std::string name;  ///< "margin" | "effort_limit" | "least_velocity"
    double specified = missing;
    double achieved = missing;    ///< by the best gains
    double attainable = missing;  ///< the most that gains can do for it while every other requirement is met
    bool others_met = true;       ///< false: the others contradict one another; attainable is then of this one alone
    bool met = false;
};

struct GainDesign {
    bool decided = false;  ///< the joint slides and can be judged
    bool feasible = false;
    /// Infeasible: all requirements but one met and that one violated least, or where no such gains exist, all violated
    /// least. Its cost is NaN or infinite where the objective is no number for any gains.
    GainChoice best;
    double margin_reach = missing;   ///< margins are looked for up to here; that much means: at least that much
    double steady_effort = missing;  ///< what steady sliding takes at most without any noise, gravity included
    std::vector<RequirementReport> requirements;
    std::vector<GainChoice> front;     ///< least cost for each margin, ascending; the other requirements met
    bool velocity_only_found = false;  ///< whether velocity-only thinking finds gains at all
    GainChoice velocity_only;          ///< its choice, judged with memory
    GainChoice as_joint;               ///< the joint's own gains
    int evaluations = 0;               ///< pairs of gains that were judged
};

}  // namespace stickslip
