#include "analysis/simulation/lanes/kernel.h"
#include "analysis/simulation/lanes/kernels.h"

namespace stickslip::lanes {

void run_avx2(const Job* jobs, Answer* answers, std::size_t count, const Settings& settings)
{
    Kernel<4, 2>(jobs, answers, count, settings).run();
}

}  // namespace stickslip::lanes
