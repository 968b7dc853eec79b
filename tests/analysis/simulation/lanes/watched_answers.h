// Joints put to the lanes that watch turn by turn, and whether two of their answers are the same to the bit.
#pragma once
#include <array>
#include <cstring>
#include <vector>

#include "analysis/simulation/lanes/watched_batch.h"

namespace stickslip {

/// Of the joints that these lanes take.
inline std::vector<lanes::WatchedJob> jobs_of(const std::vector<Joint>& joints)
{
    std::vector<lanes::WatchedJob> jobs;
    for (const auto& joint : joints)
        if (const auto s = lanes::watched_scaled(joint)) jobs.push_back(lanes::job(s->groups, true));
    return jobs;
}

inline std::vector<lanes::WatchedAnswer> answers_of(const std::vector<lanes::WatchedJob>& jobs, lanes::Instructions set)
{
    std::vector<lanes::WatchedAnswer> answers(jobs.size());
    lanes::run(jobs.data(), answers.data(), jobs.size(), {}, set);
    return answers;
}

inline bool same_bits(const lanes::WatchedAnswer& a, const lanes::WatchedAnswer& b)
{
    const auto numbers = [](const lanes::WatchedAnswer& c) {
        return std::array{c.w_min, c.w_max, c.x_min, c.x_max, c.period, c.rest_time};
    };
    const auto of_a = numbers(a), of_b = numbers(b);
    return a.ending == b.ending && a.cycle == b.cycle && a.turns == b.turns &&
           std::memcmp(&of_a, &of_b, sizeof of_a) == 0;
}

}  // namespace stickslip
