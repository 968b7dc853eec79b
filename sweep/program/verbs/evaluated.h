// What `evaluate` is asked of one joint and what it finds, before it is printed or drawn.
#pragma once
#include "analysis/simulation/set_point/set_point.h"
#include "analysis/stability/integral_cost.h"
#include "analysis/stability/load_study.h"
#include "analysis/stability/neighbour_modes.h"
#include "analysis/stability/study.h"
#include "analysis/stability/verdict.h"
#include "sweep/program/verbs/disturbance_option.h"
#include "sweep/program/verbs/stage_line.h"
#include "sweep/program/verbs/surroundings_option.h"
#include "sweep/study/open_verdict.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace stickslip {

struct EvaluateOptions {
    std::string joint, directory;
    std::vector<std::string> settings;
    DisturbanceOption disturbance;
    SurroundingsOption surroundings;
    double effort = 1;
    bool json = false, ideal_loop = false;
};

/// Everything that one evaluation found.
struct Evaluated {
    Joint joint;
    Joint summed;  ///< pages and studies turn k_p, which a cascade has only as part of its sum of gains
    LinearVerdict verdict;
    NonlinearVerdict nonlinear;
    std::optional<LinearStudy> study;  ///< for JSON and pages
    std::optional<DisturbedMotion> motion;
    std::optional<LoadStudy> loads;
    std::optional<SetPoint> rest;
    std::vector<NearMode> near;
    std::vector<std::string> contradicting;  ///< terms by which the motion does the opposite of the linear theory
    std::optional<IntegralCost> integral;
    std::string servo;
    std::optional<Joint> described;  ///< with the loop that --ideal-loop leaves out
    double described_growth = missing;

    bool decided() const { return verdict.steady.reason == Reason::none; }
    bool open() const { return decided() && is_open(nonlinear); }
    bool answered() const { return only_rest() ? rest->hunting != Hunting::undecided : decided() && !open(); }
    bool only_rest() const { return rest && (joint.control.V0 == 0 || (!is_set(joint.control.V0) && !decided())); }
    Units units() const { return units_of(joint); }
};

/// Throws BadInput. Stages that take long are shown on the line.
Evaluated evaluated(const EvaluateOptions& options, StageLine& line);

/// Its page, into the folder of the options; where the page stands.
std::filesystem::path write_evaluated(const Evaluated& e, const EvaluateOptions& options, const std::string& command);

}  // namespace stickslip
