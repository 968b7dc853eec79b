// What `evaluate` is asked of one joint, and everything that it finds, before that is printed or drawn.
#pragma once
#include "analysis/loop/loop_use.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/set_point/set_point.h"
#include "analysis/stability/integral_cost.h"
#include "analysis/stability/load_study.h"
#include "analysis/stability/neighbour_modes.h"
#include "analysis/stability/study.h"
#include "analysis/stability/verdict.h"
#include "sweep/study/disturbed_motion.h"
#include "sweep/study/gain_chart.h"
#include "sweep/study/joint_answer.h"
#include "sweep/study/left_out_loop.h"
#include "sweep/study/open_verdict.h"
#include "sweep/study/root_locus.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace stickslip {

struct EvaluationQuestion {
    Joint joint;              ///< as its file describes it
    bool ideal_loop = false;  ///< with the paper's loop in place of its own
    NonlinearOptions nonlinear;
    AskedDisturbance force;                 ///< of no kind: none
    std::optional<TimeSeries> normal_load;  ///< per the one at which the numbers of the law hold
    bool study = true;                      ///< for JSON and pages
};

/// In their order.
enum class EvaluationStage { linear, nonlinear, study, surroundings };

struct JointEvaluation {
    Joint joint;
    Joint summed;  ///< pages and studies turn k_p, which a cascade has only as part of its sum of gains
    LinearVerdict verdict;
    NonlinearVerdict nonlinear;
    std::optional<LinearStudy> study;
    std::vector<GainRoots> locus;  ///< with the study
    AskedDisturbance force;
    std::optional<DisturbedMotion> motion;
    std::optional<LoadStudy> loads;
    std::optional<SetPoint> rest;
    std::vector<NearMode> near;
    std::vector<std::string> contradicting;  ///< terms by which the motion does the opposite of the linear theory
    std::optional<IntegralCost> integral;
    std::optional<LeftOutLoop> left_out;

    bool decided() const { return verdict.steady.reason == Reason::none; }
    bool open() const { return decided() && is_open(nonlinear); }
    bool answered() const { return only_rest() ? rest->hunting != Hunting::undecided : decided() && !open(); }
    bool only_rest() const { return rest && (joint.control.V0 == 0 || (!is_set(joint.control.V0) && !decided())); }
    Units units() const { return units_of(joint); }
};

/// `at` is told each stage as it begins.
JointEvaluation evaluate_joint(
    const EvaluationQuestion& question, const std::function<void(EvaluationStage)>& at = [](EvaluationStage) {});

/// What its page draws beside: `evaluation.study` is there.
struct EvaluationCharts {
    JointAnswer answer;
    std::optional<GainChart> gains;               ///< of a joint with a real loop
    std::vector<Interval> ideal_loop, real_loop;  ///< stable k_p
};
EvaluationCharts evaluation_charts(const JointEvaluation& evaluation);

}  // namespace stickslip
