#include "analysis/simulation/lanes/kernel.h"
#include "analysis/simulation/lanes/kernels.h"
#include "analysis/simulation/lanes/slip_model.h"
#include "analysis/simulation/lanes/stribeck_model.h"
#include "analysis/simulation/lanes/ticked_kernel.h"

namespace stickslip::lanes {

void run_baseline(const Job* jobs, Answer* answers, std::size_t count, const Settings& settings)
{
    Kernel<SlipModel, 2, 2>(jobs, answers, count, settings).run();
}

void run_baseline(const StribeckJob* jobs, StribeckAnswer* answers, std::size_t count, const Settings& settings)
{
    Kernel<StribeckModel, 2, 2>(jobs, answers, count, settings).run();
}

void run_baseline(const TickedJob* jobs, std::size_t count, bool lags)
{
    lags ? TickedKernel<LaggingForce, 2, 2>(jobs, count).run() : TickedKernel<HeldForce, 2, 2>(jobs, count).run();
}

}  // namespace stickslip::lanes
