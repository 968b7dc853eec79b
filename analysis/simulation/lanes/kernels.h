// One kernel for each instruction set, each in a source file of its own with its own compile flags.
#pragma once
#include "analysis/simulation/lanes/stribeck_job.h"

namespace stickslip::lanes {

struct TickedJob;

void run_baseline(const Job* jobs, Answer* answers, std::size_t count, const Settings& settings);
void run_baseline(const TickedJob* jobs, std::size_t count, bool lags);
void run_baseline(const StribeckJob* jobs, StribeckAnswer* answers, std::size_t count, const Settings& settings);
void run_avx2(const Job* jobs, Answer* answers, std::size_t count, const Settings& settings);
void run_avx2(const TickedJob* jobs, std::size_t count, bool lags);
void run_avx2(const StribeckJob* jobs, StribeckAnswer* answers, std::size_t count, const Settings& settings);
void run_avx512(const Job* jobs, Answer* answers, std::size_t count, const Settings& settings);
void run_avx512(const TickedJob* jobs, std::size_t count, bool lags);
void run_avx512(const StribeckJob* jobs, StribeckAnswer* answers, std::size_t count, const Settings& settings);

/// By the widest of these sets; joints whose drive lags come in batches of their own.
void run(const TickedJob* jobs, std::size_t count, bool lags, Instructions instructions);

}  // namespace stickslip::lanes
