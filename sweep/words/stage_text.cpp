#include "sweep/words/stage_text.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace stickslip {

std::string_view stage_text(DiagnosisStage stage)
{
    constexpr std::string_view texts[] = {"reading",
                                          "auditing the controller",
                                          "measuring the floor",
                                          "fitting single effects",
                                          "correcting the nuisance parameters of the joint",
                                          "fitting pairs",
                                          "climbing the ladder",
                                          "fitting unmodelled forces",
                                          "predicting held-out data",
                                          "fitting friction laws",
                                          "following motions from rest",
                                          "ranking the laws",
                                          "done"};
    static_assert(std::size(texts) == static_cast<std::size_t>(DiagnosisStage::done) + 1);
    return texts[static_cast<std::size_t>(stage)];
}

std::string stages_text(const std::vector<std::string>& codes)
{
    const auto in_words = [](std::string_view code) {
        for (int s = 0; s <= static_cast<int>(DiagnosisStage::done); ++s)
            if (const auto stage = static_cast<DiagnosisStage>(s); name_of(stage) == code) return stage_text(stage);
        return code;
    };
    std::string text;
    for (std::size_t i = 0; i < codes.size(); ++i) {
        text += i == 0 ? "" : i == 1 ? ", and before " : ", ";
        text += in_words(codes[i]);
    }
    return codes.size() > 1 ? text + " where needed" : text;
}

std::string time_left_text(double done, double seconds)
{
    constexpr double least_done = 0.1, minute = 60, as_minutes = 100;
    if (!(done >= least_done && done < 1)) return "";
    const double left = seconds * (1 - done) / done;
    if (left < as_minutes) return fmt::format("about {:.0f} s left", std::ceil(left));
    return fmt::format("about {:.0f} min left", left / minute);
}

}  // namespace stickslip
