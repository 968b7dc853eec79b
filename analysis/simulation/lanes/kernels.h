// One kernel for each instruction set, each in a source file of its own with its own compile flags.
#pragma once
#include "analysis/simulation/lanes/stribeck_job.h"
#include "analysis/simulation/lanes/watched_job.h"

namespace stickslip::lanes {

struct TickedJob;

/// What joints in sampled loops must share to stand in lanes side by side.
struct TickedKind {
    StateLaw law = StateLaw::slip;
    bool lags = false;  ///< the effort of the drive
    bool operator==(const TickedKind&) const = default;
};

void run_baseline(const Job* jobs, Answer* answers, std::size_t count, const Settings& settings, StateLaw law);
void run_baseline(const TickedJob* jobs, std::size_t count, TickedKind kind);
void run_baseline(const StribeckJob* jobs, StribeckAnswer* answers, std::size_t count, const Settings& settings);
void run_baseline(const WatchedJob* jobs, WatchedAnswer* answers, std::size_t count, const Settings& settings,
                  WatchedLaw law);
void run_avx2(const Job* jobs, Answer* answers, std::size_t count, const Settings& settings, StateLaw law);
void run_avx2(const TickedJob* jobs, std::size_t count, TickedKind kind);
void run_avx2(const StribeckJob* jobs, StribeckAnswer* answers, std::size_t count, const Settings& settings);
void run_avx2(const WatchedJob* jobs, WatchedAnswer* answers, std::size_t count, const Settings& settings,
              WatchedLaw law);
void run_avx512(const Job* jobs, Answer* answers, std::size_t count, const Settings& settings, StateLaw law);
void run_avx512(const TickedJob* jobs, std::size_t count, TickedKind kind);
void run_avx512(const StribeckJob* jobs, StribeckAnswer* answers, std::size_t count, const Settings& settings);
void run_avx512(const WatchedJob* jobs, WatchedAnswer* answers, std::size_t count, const Settings& settings,
                WatchedLaw law);

/// By the widest of these sets.
void run(const TickedJob* jobs, std::size_t count, TickedKind kind, Instructions instructions);

}  // namespace stickslip::lanes
