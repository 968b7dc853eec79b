// How much of a diagnosis lies behind, also within a stage.
#pragma once
#include "analysis/base/parallel_for.h"
#include "analysis/diagnosis/plant/helpers.h"
#include "analysis/results/diagnosis_stage.h"

#include <atomic>

namespace stickslip::gap {

/// The part of the work that lies behind when a stage begins.
double begins_at(DiagnosisStage stage);

/// Counts the tasks of a stage. How many rounds of them there will be is not known before: each round takes the same
/// part of what the stage has left, so that what is told grows and never reaches the next stage's.
class StageMeter {
  public:
    /// Both have to outlive it.
    StageMeter(const ParallelFor& run, const StageProgress& tell) : run_(run), tell_(tell), between_rounds_(run) {}

    void begin(DiagnosisStage stage);
    /// One round of tasks. Told from the calling thread only.
    void run(std::size_t n, const std::function<void(std::size_t)>& task);

  private:
    const ParallelFor& run_;
    const StageProgress& tell_;
    const Helpers between_rounds_;
    DiagnosisStage stage_ = DiagnosisStage::reading;
    double done_ = 0, end_ = 0;
    std::atomic<bool> running_{false};
};

}  // namespace stickslip::gap
