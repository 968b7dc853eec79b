// The stages of a diagnosis, by codes.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip {

/// Of records up to `predicting_unseen`, in their order; of tables of outcomes the three after it.
enum class DiagnosisStage {
    reading,
    auditing_controller,
    measuring_floor,
    fitting_singles,
    correcting_numbers,
    fitting_pairs,
    climbing_ladder,
    fitting_free_forces,
    predicting_unseen,
    fitting_laws,
    following_motions,
    ranking_laws,
    done,
};

/// The code: "fitting-singles".
std::string_view name_of(DiagnosisStage stage);

/// The codes of this stage of a diagnosis of records and of those that would have come after it.
std::vector<std::string> stages_from(DiagnosisStage stage);

/// Told what begins, and the part of the work that is done.
using StageProgress = std::function<void(DiagnosisStage stage, double done)>;

}  // namespace stickslip
