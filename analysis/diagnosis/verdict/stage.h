// The stages of a diagnosis, in their order, and what a progress line calls them.
#pragma once
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip::gap {

enum class Stage {
    reading,
    auditing_controller,
    measuring_floor,
    fitting_singles,
    correcting_numbers,
    fitting_pairs,
    climbing_ladder,
    fitting_free_forces,
    predicting_unseen,
    done,
};

constexpr std::string_view name_of(Stage stage)
{
    constexpr std::string_view names[] = {"reading",
                                          "auditing the controller",
                                          "measuring the floor",
                                          "fitting single effects",
                                          "correcting the nuisance parameters of the joint",
                                          "fitting pairs",
                                          "climbing the ladder",
                                          "fitting unmodelled forces",
                                          "predicting held-out data",
                                          "done"};
    static_assert(std::size(names) == static_cast<std::size_t>(Stage::done) + 1);
    return names[static_cast<std::size_t>(stage)];
}

/// This stage and those that would have come after it.
inline std::vector<std::string> stages_from(Stage stage)
{
    std::vector<std::string> names;
    for (Stage s = stage; s != Stage::done; s = static_cast<Stage>(static_cast<int>(s) + 1))
        names.emplace_back(name_of(s));
    return names;
}

/// Told what begins, and the part of the work that is done.
using StageProgress = std::function<void(Stage stage, double done)>;

}  // namespace stickslip::gap
