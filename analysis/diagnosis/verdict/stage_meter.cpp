#include "analysis/diagnosis/verdict/stage_meter.h"

#include <algorithm>
#include <array>
#include <exception>
#include <mutex>

namespace stickslip::gap {
namespace {

struct Usual {
    DiagnosisStage stage;
    double begins_at;  ///< as diagnoses of a few records have it that need a ladder
    double rounds;     ///< of tasks
};

constexpr std::array<Usual, 10> usual{{
    {DiagnosisStage::reading, 0, 1},
    {DiagnosisStage::auditing_controller, 0.02, 1},
    {DiagnosisStage::measuring_floor, 0.03, 1},
    {DiagnosisStage::fitting_singles, 0.05, 3},
    {DiagnosisStage::correcting_numbers, 0.2, 8},
    {DiagnosisStage::fitting_pairs, 0.3, 8},
    {DiagnosisStage::climbing_ladder, 0.4, 20},
    {DiagnosisStage::fitting_free_forces, 0.85, 2},
    {DiagnosisStage::predicting_unseen, 0.9, 4},
    {DiagnosisStage::done, 1, 1},
}};

const Usual& usual_of(DiagnosisStage stage)
{
    return *std::ranges::find(usual, stage, &Usual::stage);
}

/// A round in which threads that have no task left help with the predictions of the others. What a task throws is
/// thrown when all have ended: what is shared may be interrupted, and the threads of a caller need not carry that.
void run_helped(const ParallelFor& run, std::size_t n, const std::function<void(std::size_t)>& task)
{
    Unbegun unbegun{n};
    std::exception_ptr thrown;
    std::mutex throwing;
    run(n, [&](std::size_t i) {
        --unbegun;
        const Helpers helpers(run, &unbegun);
        try {
            task(i);
        } catch (...) {
            const std::lock_guard lock(throwing);
            if (!thrown) thrown = std::current_exception();
        }
    });
    if (thrown) std::rethrow_exception(thrown);
}

/// Tells threads apart; what they are is none of this floor's business.
const void* this_thread()
{
    static thread_local char own;
    return &own;
}

}  // namespace

double begins_at(DiagnosisStage stage)
{
    return usual_of(stage).begins_at;
}

void StageMeter::begin(DiagnosisStage stage)
{
    stage_ = stage;
    // a stage that an earlier one has come back to does not take back what was told
    done_ = std::max(done_, begins_at(stage));
    const auto next = std::ranges::find_if(usual, [&](const Usual& u) { return u.begins_at > begins_at(stage); });
    end_ = std::max(done_, next == usual.end() ? 1 : next->begins_at);
    tell_(stage_, done_);
}

void StageMeter::run(std::size_t n, const std::function<void(std::size_t)>& task)
{
    if (running_.exchange(true)) return run_helped(run_, n, task);  // a task's own tasks
    struct End {
        std::atomic<bool>& running;
        ~End() { running = false; }
    } end{running_};
    const double from = done_, to = from + (end_ - from) / usual_of(stage_).rounds;
    const void* caller = this_thread();
    std::atomic<std::size_t> finished{0};
    run_helped(run_, n, [&](std::size_t i) {
        task(i);
        ++finished;
        if (this_thread() != caller) return;
        done_ = std::max(done_, from + (to - from) * static_cast<double>(finished) / static_cast<double>(n));
        tell_(stage_, done_);
    });
    done_ = to;
    tell_(stage_, done_);
}

}  // namespace stickslip::gap
