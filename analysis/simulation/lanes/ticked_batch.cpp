#include "analysis/simulation/lanes/ticked_batch.h"

#include <vector>

#include "analysis/simulation/lanes/grouping.h"
#include "analysis/simulation/lanes/kernels.h"
#include "analysis/simulation/lanes/ticked_program.h"

namespace stickslip::lanes {

bool in_ticked_lanes(const Joint& joint)
{
    if (!one_state(joint.friction).law || !single(joint) || !plain(joint.friction, joint.load)) return false;
    if (!has_real_loop(joint) || !(joint.control.V0 > 0) || !(joint.sensor.position_scale > 0)) return false;
    const auto& a = joint.actuator;
    const bool motor = a.kind == ActuatorKind::dc_motor;
    const bool bends = a.limit < infinity || (motor && a.supply_resistance > 0);
    const bool bends_by_command = motor ? is_set(a.supply_voltage) : a.sag_effort < infinity;
    return !bends && !(a.lag > 0 && bends_by_command);
}

void answer_ticked(std::span<const Joint* const> joints, const LoopQuestion& question, std::span<LoopVerdict> verdicts,
                   bool* answered, Instructions instructions)
{
    for (const auto law : {StateLaw::slip, StateLaw::ageing})
        for (const bool lags : {false, true}) {
            const TickedKind kind{law, lags};
            std::vector<TickedJob> jobs;
            for (std::size_t i = 0; i < joints.size(); ++i)
                if (TickedKind{one_state(joints[i]->friction).kind, joints[i]->actuator.lag > 0} == kind)
                    jobs.push_back({joints[i], &question, &verdicts[i], &answered[i]});
            if (!jobs.empty()) run(jobs.data(), jobs.size(), kind, instructions);
        }
}

}  // namespace stickslip::lanes
