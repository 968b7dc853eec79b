// Joints put to the lanes that watch turn by turn: the bits of their answers, and what CVODE says of the same.
#pragma once
#include <array>
#include <catch2/catch.hpp>
#include <cstring>
#include <vector>

#include "analysis/simulation/lanes/watched_batch.h"
#include "analysis/stability/steady.h"
#include "tests/analysis/simulation/lanes/lanes_comparison.h"

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

/// An answer has the same bits alone, and whichever jobs stand before it.
inline void check_that_jobs_are_alone(const std::vector<lanes::WatchedJob>& jobs)
{
    const auto set = lanes::best_instructions();
    const auto forwards = answers_of(jobs, set);
    const std::vector<lanes::WatchedJob> backwards(jobs.rbegin(), jobs.rend());
    const auto reversed = answers_of(backwards, set);
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        CHECK(same_bits(forwards[i], reversed[jobs.size() - 1 - i]));
        if (i % 7 == 0) CHECK(same_bits(forwards[i], answers_of({jobs[i]}, set)[0]));
    }
}

/// Disturbances of stated size, put to the rows of a sweep and to CVODE.
struct StatedComparison {
    double effort = 1;  ///< that of CVODE
    int by_lanes = 0, asked = 0;

    void operator()(const Joint& joint, const Disturbance& disturbance)
    {
        for (const auto& c : compare_with_cvode({&joint, 1}, false, disturbance, effort)) {
            CAPTURE(static_cast<int>(disturbance.kind), disturbance.size, c.row.overshoot, c.truth.overshoot);
            CHECK(c.same_outcome());
            // the reference's first turn is over at once where a motion falls from V_0, and its peak is the start;
            // lanes leave a motion to the linear theory at 1e-6 of steady sliding
            const double start = disturbance.size / std::abs(steady_sliding(joint).deflection);
            const double apart = std::abs(c.row.overshoot - c.truth.overshoot);
            CHECK((c.overshoot < 1e-4 || apart < 1e-8 || c.truth.overshoot == Approx(start)));
            CHECK(c.row.overshoot > c.truth.overshoot - 1e-8);
            CHECK(c.period < 1e-5);
            CHECK(c.amplitude < 1e-4);
            by_lanes += c.row.path == DecisionPath::lanes, ++asked;
        }
    }
};

}  // namespace stickslip
