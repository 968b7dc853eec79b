#include "analysis/simulation/lanes/kernels.h"

namespace stickslip::lanes {

Instructions best_instructions()
{
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) return Instructions::avx512;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return Instructions::avx2;
#endif
    return Instructions::baseline;
}

namespace {

template <class Job, class Answer>
void run_widest(const Job* jobs, Answer* answers, std::size_t count, const Settings& settings,
                Instructions instructions)
{
    if (count == 0) return;
    switch (instructions) {
        case Instructions::avx512:
            return run_avx512(jobs, answers, count, settings);
        case Instructions::avx2:
            return run_avx2(jobs, answers, count, settings);
        case Instructions::baseline:
            return run_baseline(jobs, answers, count, settings);
    }
}

}  // namespace

void run(const Job* jobs, Answer* answers, std::size_t count, const Settings& settings, Instructions instructions)
{
    run_widest(jobs, answers, count, settings, instructions);
}

void run(const StribeckJob* jobs, StribeckAnswer* answers, std::size_t count, const Settings& settings,
         Instructions instructions)
{
    run_widest(jobs, answers, count, settings, instructions);
}

}  // namespace stickslip::lanes
