#include "analysis/diagnosis/rig/rig_experiment.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

/// Speeds of the load point one after the other, as multiples of the record's first speed.
struct Motion {
    TestMotion kind;
    std::vector<double> speeds;
};

const std::vector<Motion> motions{
    {TestMotion::rig_step_down, {1, 0.1, 1}},
    {TestMotion::rig_step_up, {1, 10, 1}},
    {TestMotion::rig_hold, {1, 0, 1}},
};

constexpr double hold = 100;            // numerical: s, of the proposed motion
constexpr std::size_t rows = 1200;      // of each part
constexpr double part_of_travel = 0.3;  // numerical: of the record's travel, at every speed

Rig along(const Rig& rig, const Motion& motion)
{
    Rig made;
    made.speed = rig.speed, made.levels = 1;
    RigRun& run = made.runs.emplace_back();
    run.start_speed = rig.speed;
    double t = 0, x = 0;
    for (double multiple : motion.speeds) {
        const double speed = multiple * rig.speed;
        const double duration = speed > 0 ? part_of_travel * rig.travel / speed : hold;
        for (std::size_t k = 0; k < rows; ++k) {
            run.time.push_back(t);
            run.displacement.push_back(x);
            t += duration / rows, x += speed * duration / rows;
        }
    }
    made.travel = x;
    return made;
}

}  // namespace

NextExperiment design_rig_experiment(const Rig& rig, double noise, RigLaw one, const RigNumbers& p, RigLaw other,
                                     const RigNumbers& q)
{
    NextExperiment best;
    for (const auto& motion : motions) {
        const Rig made = along(rig, motion);
        const auto a = rig_force(made, one, p).front(), b = rig_force(made, other, q).front();
        double distance = 0;
        for (std::size_t k = 0; k < a.size(); ++k) distance = std::max(distance, std::abs(a[k] - b[k]) / noise);
        if (distance <= best.distance) continue;
        best = {motion.kind, {}, distance, made.runs[0].time, made.runs[0].displacement};
    }
    return best;
}

}  // namespace stickslip::gap
