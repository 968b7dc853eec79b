// What the figures of the paper show, computed anew: the answer that `stickslip figures` draws.
#pragma once
#include "analysis/stability/reduction_study.h"
#include "analysis/stability/verdict.h"
#include "sweep/study/map_answer.h"
#include "sweep/study/maps.h"
#include "sweep/study/paper/paper_numbers.h"
#include "sweep/study/root_locus.h"
#include "sweep/study/samples.h"

#include <optional>
#include <string>
#include <vector>

namespace stickslip {

/// Figs. 1a, 1b, 2 and 3.
struct PaperFriction {
    Samples kinetic_static, stribeck;           ///< steady friction over −0.1 … 0.1 m/s, NaN between the directions
    double end_of_range_A = missing;            ///< m/s, where friction of Fig. 1b rises again
    Samples velocity_steps;                     ///< friction over slip
    double faster = missing, slower = missing;  ///< slip at which the velocity steps
    struct Oscillation {
        double omega;
        Samples loop;  ///< friction over velocity, third period
    };
    std::vector<Oscillation> oscillations;
    Samples steady;  ///< over the same velocities
};

/// §4 and §5.
struct PaperStability {
    Slice regions;  ///< over k_p and k_v
    MapAnswer boundaries;
    Samples kernel;  ///< ∫ g cos ωt dt of (34) over ω
    double f_v = missing, crossing_omega = missing;
    std::optional<RootLocus> locus;
    /// Least k_v over V_0: by (22), by the slope of (6), with memory under a soft and a stiff spring. NaN where none is
    /// needed.
    Samples gauss, logarithm, soft, stiff;
    Samples critical_spring;  ///< over the rate of force
};

/// A joint of each lumped model: "fig-4", "fig-5", "fig-6-motor", "fig-6-joint", "fig-7a" and "fig-7b".
struct PaperModel {
    std::string id;
    Joint joint;
    LinearVerdict verdict;
};

struct PaperAnswer {
    LinearVerdict verdict;  ///< of paper_joint()
    PaperFriction friction;
    PaperStability stability;
    std::vector<PaperModel> models;
    std::vector<ReductionStudy> reductions;  ///< of the first model
    std::vector<PaperNumber> numbers;
};
/// The joint of the paper with a motor and a transmission, lumped more and more coarsely.
std::vector<PaperModel> paper_models();

PaperAnswer paper_answer();

}  // namespace stickslip
