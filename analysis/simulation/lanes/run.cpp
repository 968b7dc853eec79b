#include "analysis/simulation/lanes/instructions.h"
#include "analysis/simulation/lanes/kernels.h"

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <string>

namespace stickslip::lanes {
namespace {

constexpr Instructions all_sets[] = {Instructions::baseline, Instructions::avx2, Instructions::avx512};
std::atomic<Instructions> widest_allowed = Instructions::avx512;

Instructions widest_of_processor()
{
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) return Instructions::avx512;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return Instructions::avx2;
#endif
    return Instructions::baseline;
}

}  // namespace

std::string_view name_of(Instructions set)
{
    return set == Instructions::avx512 ? "avx512" : set == Instructions::avx2 ? "avx2" : "baseline";
}

void use_instructions(std::string_view name)
{
    std::string known;
    for (const auto set : all_sets) {
        if (set > widest_of_processor()) break;
        known += (known.empty() ? "" : ", ") + std::string(name_of(set));
        if (name_of(set) != name) continue;
        widest_allowed = set;
        return;
    }
    throw std::invalid_argument("got \"" + std::string(name) + "\", this processor has " + known);
}

Instructions best_instructions()
{
    return std::min(widest_of_processor(), widest_allowed.load());
}

namespace {

template <class... Arguments>
void run_widest(Instructions instructions, Arguments&&... arguments)
{
    switch (instructions) {
        case Instructions::avx512:
            return run_avx512(arguments...);
        case Instructions::avx2:
            return run_avx2(arguments...);
        case Instructions::baseline:
            return run_baseline(arguments...);
    }
}

constexpr long patient_step_limit = 1'000'000;  ///< beyond what Settings::work allows

/// Jobs of one law after another.
template <class Job, class Answer>
void run_by_law(const Job* jobs, Answer* answers, std::size_t count, const Settings& settings,
                Instructions instructions)
{
    std::size_t first = 0;
    for (std::size_t last = 1; last <= count; ++last) {
        const auto law = jobs[first].groups.law;
        if (last < count && jobs[last].groups.law == law) continue;
        run_widest(instructions, jobs + first, answers + first, last - first, settings, law);
        first = last;
    }
}

}  // namespace

void run(const Job* jobs, Answer* answers, std::size_t count, const Settings& settings, Instructions instructions)
{
    run_by_law(jobs, answers, count, settings, instructions);
}

/// Such motions are followed for as long as the reference follows them, by steps that are not counted between turns.
void run(const WatchedJob* jobs, WatchedAnswer* answers, std::size_t count, const Settings& settings,
         Instructions instructions)
{
    Settings patient = settings;
    patient.step_limit = patient_step_limit;
    run_by_law(jobs, answers, count, patient, instructions);
}

void run(const StribeckJob* jobs, StribeckAnswer* answers, std::size_t count, const Settings& settings,
         Instructions instructions)
{
    if (count > 0) run_widest(instructions, jobs, answers, count, settings);
}

void run(const TickedJob* jobs, std::size_t count, TickedKind kind, Instructions instructions)
{
    run_widest(instructions, jobs, count, kind);
}

}  // namespace stickslip::lanes
