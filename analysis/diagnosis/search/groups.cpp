// Which candidates are fitted side by side.
#include "analysis/diagnosis/search/search.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace stickslip::gap {

double cost_of(const Candidate& candidate)
{
    constexpr double cost_of_two_masses = 10, cost_of_teeth = 3;  // numerical: of work, for groups alike in time
    const double numbers = static_cast<double>(candidate.parameter_count() + 1);
    return numbers * (two_mass_edit(candidate) ? cost_of_two_masses : 1) * (jagged(candidate) ? cost_of_teeth : 1);
}

std::vector<std::vector<std::size_t>> in_groups(std::span<const double> costs, std::size_t most)
{
    const double sum = std::accumulate(costs.begin(), costs.end(), 0.0);
    const double limit = static_cast<double>(most) * sum / static_cast<double>(std::max<std::size_t>(costs.size(), 1));
    struct Group {
        std::vector<std::size_t> members;
        double cost;
    };
    std::vector<Group> groups;
    for (std::size_t i = 0; i < costs.size(); ++i) {
        if (groups.empty() || groups.back().members.size() == most || groups.back().cost + costs[i] > limit)
            groups.push_back({{}, 0});
        groups.back().members.push_back(i), groups.back().cost += costs[i];
    }
    std::ranges::stable_sort(groups, std::greater{}, &Group::cost);
    std::vector<std::vector<std::size_t>> found;
    for (auto& group : groups) found.push_back(std::move(group.members));
    return found;
}

}  // namespace stickslip::gap
