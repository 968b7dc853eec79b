#include "analysis/results/diagnosis_stage.h"

#include <iterator>

namespace stickslip {

std::string_view name_of(DiagnosisStage stage)
{
    constexpr std::string_view names[] = {"reading",
                                          "auditing-controller",
                                          "measuring-floor",
                                          "fitting-singles",
                                          "correcting-numbers",
                                          "fitting-pairs",
                                          "climbing-ladder",
                                          "fitting-free-forces",
                                          "predicting-unseen",
                                          "fitting-laws",
                                          "following-motions",
                                          "ranking-laws",
                                          "done"};
    static_assert(std::size(names) == static_cast<std::size_t>(DiagnosisStage::done) + 1);
    return names[static_cast<std::size_t>(stage)];
}

std::vector<std::string> stages_from(DiagnosisStage stage)
{
    std::vector<std::string> names;
    for (int s = static_cast<int>(stage); s <= static_cast<int>(DiagnosisStage::predicting_unseen); ++s)
        names.emplace_back(name_of(static_cast<DiagnosisStage>(s)));
    return names;
}

}  // namespace stickslip
