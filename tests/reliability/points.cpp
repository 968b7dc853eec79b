// Random valid joints through the evaluation of a sweep, extreme values among them: no exception, no infinity, no
// missing number without a reason. Usage: reliability_points [--points N] [--nonlinear N] [--seed S] JOINT... The
// joints given are templates: every number of them is drawn anew within its range.
#include "analysis/joint/parameters.h"
#include "analysis/loop/loop_use.h"
#include "analysis/results/text.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/study/evaluate_points.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace stickslip;

/// Where arithmetic breaks: zero, the smallest denormal, the ends of the normal numbers and what squares beyond them.
constexpr double extremes[] = {0, 5e-324, 1e-300, 1e-200, 1e-100, 1e100, 1e200, 1e300, 1.7e308};
constexpr double spread_decades = 2;  // of ordinary numbers, to either side of the template

/// A joint with every number drawn anew; one in ten has an extreme value somewhere.
Joint drawn(const Joint& pattern, std::mt19937_64& random)
{
    Joint joint = pattern;
    std::uniform_real_distribution<double> decades(-spread_decades, spread_decades);
    auto leaves = parameters(joint);
    for (const Parameter& leaf : leaves) {
        if (!std::isfinite(*leaf.value) || *leaf.value == 0) continue;
        const double value = *leaf.value * std::pow(10, decades(random));
        if (leaf.range.holds(value)) *leaf.value = value;
    }
    if (random() % 10 == 0) {
        const Parameter& leaf = leaves[random() % leaves.size()];
        const double value = extremes[random() % std::size(extremes)];
        if (leaf.range.holds(value)) *leaf.value = value;
    }
    return joint;
}

/// What a row promises and does not keep, in words; empty where it keeps all.
std::string fault_of(const Joint& joint, const PointResult& row, bool nonlinear)
{
    // maps of a real loop leave out the least velocity gain: each would be a search of its own
    const bool tells_k_v = loop_kind(joint) == LoopKind::ideal;
    for (const Column& column : columns())
        if (column.number && (nonlinear || !column.nonlinear) && std::isinf(row.*column.number))
            return std::string(column.name) + " is infinite";
    if (row.reason == Reason::none) {
        if (row.region == Region::undecided) return "undecided without a reason";
        if (std::isnan(row.spectral_abscissa)) return "no spectral abscissa and no reason";
        // no velocity gain may be enough for a joint of several bodies, but then the present one is not either
        if (tells_k_v && std::isnan(row.k_v_min) && row.velocity_only_stable == 1)
            return "stable, yet no velocity gain is enough";
    }
    if (!nonlinear) return {};
    const bool open = row.outcome == Outcome::undecided || row.outcome == Outcome::solver_failure;
    if (open && row.reason == Reason::none) return "no outcome and no reason";
    if (row.outcome == Outcome::not_asked && row.reason == Reason::none) return "no outcome";
    if (row.outcome == Outcome::limit_cycle && std::isnan(row.amplitude)) return "a limit cycle without an amplitude";
    return {};
}

struct Count {
    std::uint64_t points = 0, invalid = 0, faults = 0;
    std::map<std::string, std::uint64_t> reasons;
    std::map<std::string, std::uint64_t> kinds;
};

void check_point(const std::string& name, const Joint& joint, bool nonlinear, Count& count)
{
    NonlinearSpec spec;
    spec.enabled = nonlinear;
    PointResult row;
    std::string fault;
    try {
        PointCursor cursor(joint, {});
        evaluator(spec, {})(cursor, {&row, 1});
        fault = fault_of(joint, row, nonlinear);
    } catch (const std::exception& e) {
        fault = std::string("exception: ") + e.what();
    }
    ++count.points;
    ++count.reasons[std::string(code_name("reason", static_cast<std::uint8_t>(row.reason)))];
    if (fault.empty()) return;
    ++count.faults;
    // the first of each kind in full, so that it can be replayed with `stickslip evaluate`
    if (++count.kinds[name + ": " + fault] == 1)
        std::printf("FAULT in a joint like %s: %s\n%s", name.c_str(), fault.c_str(), joint_text(joint).c_str());
}

bool check_points(const std::vector<std::pair<std::string, Joint>>& patterns, std::uint64_t points, bool nonlinear,
                  std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    Count count;
    for (std::uint64_t k = 0; count.points < points; ++k) {
        const auto& [name, pattern] = patterns[k % patterns.size()];
        const Joint joint = drawn(pattern, random);
        if (check(joint).empty())
            check_point(name, joint, nonlinear, count);
        else
            ++count.invalid;
    }
    std::printf("%s points checked: %llu (seed %llu, %zu kinds of joint, %llu drawn joints refused), faults: %llu\n",
                nonlinear ? "nonlinear" : "linear", static_cast<unsigned long long>(count.points),
                static_cast<unsigned long long>(seed), patterns.size(), static_cast<unsigned long long>(count.invalid),
                static_cast<unsigned long long>(count.faults));
    for (const auto& [reason, number] : count.reasons)
        std::printf("  reason %s: %llu\n", reason.c_str(), static_cast<unsigned long long>(number));
    for (const auto& [kind, number] : count.kinds)
        std::printf("  FAULT %s: %llu\n", kind.c_str(), static_cast<unsigned long long>(number));
    return count.faults == 0;
}

}  // namespace

int main(int argc, char** argv)
{
    std::uint64_t points = 100'000, nonlinear = 0, seed = 20261121;
    std::vector<std::pair<std::string, Joint>> patterns;
    try {
        for (int i = 1; i < argc; ++i) {
            const bool more = i + 1 < argc;
            if (more && !std::strcmp(argv[i], "--points"))
                points = std::stoull(argv[++i]);
            else if (more && !std::strcmp(argv[i], "--nonlinear"))
                nonlinear = std::stoull(argv[++i]);
            else if (more && !std::strcmp(argv[i], "--seed"))
                seed = std::stoull(argv[++i]);
            else
                patterns.emplace_back(std::filesystem::path(argv[i]).stem(), read_joint(argv[i]));
        }
    } catch (const std::exception& e) {
        return std::fprintf(stderr, "%s\n", e.what()), 2;
    }
    if (patterns.empty()) return std::fprintf(stderr, "no joint is given\n"), 2;
    const bool linear_sound = check_points(patterns, points, false, seed);
    const bool nonlinear_sound = nonlinear == 0 || check_points(patterns, nonlinear, true, seed);
    return linear_sound && nonlinear_sound ? 0 : 1;
}
