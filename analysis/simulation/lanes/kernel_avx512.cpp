#include "analysis/simulation/lanes/every_kernel.h"

namespace stickslip::lanes {

void run_avx512(const Job* jobs, Answer* answers, std::size_t count, const Settings& settings, StateLaw law)
{
    run_wide<8, 2>(jobs, answers, count, settings, law);
}

void run_avx512(const StribeckJob* jobs, StribeckAnswer* answers, std::size_t count, const Settings& settings)
{
    run_wide<8, 2>(jobs, answers, count, settings);
}

void run_avx512(const WatchedJob* jobs, WatchedAnswer* answers, std::size_t count, const Settings& settings,
                WatchedLaw law)
{
    run_wide<8, 2>(jobs, answers, count, settings, law);
}

void run_avx512(const TickedJob* jobs, std::size_t count, TickedKind kind)
{
    run_wide<8, 2>(jobs, count, kind);
}

}  // namespace stickslip::lanes
