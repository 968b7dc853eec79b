#include "analysis/simulation/lanes/every_kernel.h"

namespace stickslip::lanes {

void run_baseline(const Job* jobs, Answer* answers, std::size_t count, const Settings& settings, StateLaw law)
{
    run_wide<2, 2>(jobs, answers, count, settings, law);
}

void run_baseline(const StribeckJob* jobs, StribeckAnswer* answers, std::size_t count, const Settings& settings)
{
    run_wide<2, 2>(jobs, answers, count, settings);
}

void run_baseline(const WatchedJob* jobs, WatchedAnswer* answers, std::size_t count, const Settings& settings,
                  WatchedLaw law)
{
    run_wide<2, 2>(jobs, answers, count, settings, law);
}

void run_baseline(const TickedJob* jobs, std::size_t count, TickedKind kind)
{
    run_wide<2, 2>(jobs, count, kind);
}

}  // namespace stickslip::lanes
