// What the thresholds of the policy were compared with since the last call, as JSON.
#pragma once
#include "analysis/diagnosis/policy/entries.h"  // made by trace_policy.py

#include <nlohmann/json.hpp>

#include <vector>

namespace stickslip::evidence {

inline nlohmann::ordered_json comparisons()
{
    using Json = nlohmann::ordered_json;
    const auto json = [](const Compared::Side& side) {
        const auto end = side.nearest.begin() + static_cast<std::ptrdiff_t>(side.stored);
        return Json{{"count", side.count},
                    {"close", side.close},
                    {"nearest", std::vector(side.nearest.begin(), end)},
                    {"furthest", side.furthest}};
    };
    Json all = Json::object();
    for (const auto& entry : gap::policy::entries) {
        auto& c = *entry.compared;
        if (c.below.count + c.above.count > 0) all[entry.name] = {{"below", json(c.below)}, {"above", json(c.above)}};
        c = {entry.name, {}, {}};
    }
    return all;
}

}  // namespace stickslip::evidence
