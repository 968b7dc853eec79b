#include "analysis/simulation/lanes/kernel.h"
#include "analysis/simulation/lanes/kernels.h"
#include "analysis/simulation/lanes/slip_model.h"
#include "analysis/simulation/lanes/stribeck_model.h"
#include "analysis/simulation/lanes/ticked_kernel.h"

namespace stickslip::lanes {

void run_avx512(const Job* jobs, Answer* answers, std::size_t count, const Settings& settings)
{
    Kernel<SlipModel, 8, 2>(jobs, answers, count, settings).run();
}

void run_avx512(const StribeckJob* jobs, StribeckAnswer* answers, std::size_t count, const Settings& settings)
{
    Kernel<StribeckModel, 8, 2>(jobs, answers, count, settings).run();
}

void run_avx512(const TickedJob* jobs, std::size_t count, bool lags)
{
    lags ? TickedKernel<LaggingForce, 8, 2>(jobs, count).run() : TickedKernel<HeldForce, 8, 2>(jobs, count).run();
}

}  // namespace stickslip::lanes
