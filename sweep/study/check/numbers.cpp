#include "sweep/study/check/numbers.h"

#include "analysis/joint/parameters.h"

#include <cmath>

namespace stickslip {

std::map<std::string, double> numbers_of(const Spec& spec)
{
    Joint joint = spec.joint;
    for (std::size_t i = 0; i < spec.axes.size() && i < spec.design.size(); ++i)
        if (const auto& [path, value] = spec.design[i]; find_parameter(joint, path)) number_at(joint, path) = value;
    std::map<std::string, double> numbers;
    for (const auto& p : parameters(joint))
        if (std::isfinite(*p.value)) numbers[p.path] = *p.value;
    return numbers;
}

std::vector<ChangedNumber> changed_numbers(const std::map<std::string, double>& before,
                                           const std::map<std::string, double>& after)
{
    std::vector<ChangedNumber> changed;
    for (const auto& [path, value] : before) {
        const auto now = after.find(path);
        if (now == after.end())
            changed.push_back({path, value, not_set});
        else if (now->second != value)
            changed.push_back({path, value, now->second});
    }
    // a key that the program which wrote the baseline did not know stands at its default, and nobody has set it
    Joint untouched;
    const auto is_default = [&](const std::string& path, double value) {
        const double* number = find_parameter(untouched, path);
        return number && *number == value;
    };
    for (const auto& [path, value] : after)
        if (!before.count(path) && !is_default(path, value)) changed.push_back({path, not_set, value});
    return changed;
}

}  // namespace stickslip
