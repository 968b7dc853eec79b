#include "sweep/engine/plan.h"

#include "analysis/joint/parameters.h"
#include "sweep/engine/build.h"
#include "sweep/engine/row_format.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace stickslip {
namespace {

constexpr double chunk_seconds = 0.1;                // what a kill may cost a thread
constexpr std::uint64_t largest_cheap_chunk = 8192;  // its slots and its record stay in a core's cache
constexpr std::uint64_t smallest_cheap_chunk = 256;  // below this the journal's work per chunk shows
constexpr std::uint64_t chunks_for_balance = 64;
constexpr std::uint64_t most_chunks = 1u << 22;

constexpr double dense_chunk_seconds = 0.3, dense_computed_share = 0.05;
constexpr double smallest_dense_chunk = 4096, largest_dense_chunk = 131072;
constexpr double dense_chunks_for_balance = 8;

/// Every field goes in with its length, so that no two plans can spell the same bytes.
class Hash {
  public:
    void add(std::uint64_t number) { XXH3_128bits_update(state_.get(), &number, sizeof number); }
    void add(std::string_view text)
    {
        add(std::uint64_t{text.size()});
        XXH3_128bits_update(state_.get(), text.data(), text.size());
    }
    void add(const std::vector<double>& values)
    {
        add(std::uint64_t{values.size()});
        XXH3_128bits_update(state_.get(), values.data(), values.size() * sizeof(double));
    }
    PlanId id() const
    {
        const XXH128_hash_t digest = XXH3_128bits_digest(state_.get());
        return {digest.high64, digest.low64};
    }

  private:
    struct Free {
        void operator()(XXH3_state_t* s) const { XXH3_freeState(s); }
    };
    static XXH3_state_t* fresh()
    {
        XXH3_state_t* state = XXH3_createState();
        if (!state) throw std::bad_alloc();
        XXH3_128bits_reset(state);
        return state;
    }
    std::unique_ptr<XXH3_state_t, Free> state_{fresh()};
};

void check_axes(const Joint& given, const std::vector<Axis>& axes)
{
    Joint joint = given;
    const auto known = parameters(joint);
    std::vector<const double*> taken;
    for (const Axis& axis : axes) {
        const double* target = find_parameter(joint, axis.path);
        if (!target)
            throw std::invalid_argument(fmt::format("axis \"{}\" is not a parameter of this joint", axis.path));
        if (std::ranges::find(taken, target) != taken.end())
            throw std::invalid_argument(fmt::format("axis \"{}\" is given twice", axis.path));
        taken.push_back(target);
        if (axis.values.empty()) throw std::invalid_argument(fmt::format("axis \"{}\" has no values", axis.path));
        const auto parameter = std::ranges::find(known, target, &Parameter::value);
        for (const double value : axis.values)
            if (!std::isfinite(value) || !parameter->range.holds(value))
                throw std::invalid_argument(
                    fmt::format("axis \"{}\" holds {}, expected {}", axis.path, value, describe(parameter->range)));
    }
}

std::uint64_t count_points(const std::vector<Axis>& axes, bool nonlinear)
{
    double wanted = 1;
    for (const Axis& axis : axes) wanted *= static_cast<double>(axis.values.size());
    if (wanted > static_cast<double>(max_points))
        throw std::invalid_argument(fmt::format("{:.3g} points are too many (about {}), expected at most {:.3g}",
                                                wanted, describe(plan_cost(wanted, nonlinear)),
                                                static_cast<double>(max_points)));
    return static_cast<std::uint64_t>(wanted);  // exact: max_points is far below 2^53
}

}  // namespace

std::string to_text(const PlanId& id)
{
    return fmt::format("{:016x}{:016x}", id.high, id.low);
}

std::uint64_t chunk_size_for(std::uint64_t points, double seconds_per_point)
{
    const double by_cost = std::clamp(chunk_seconds / seconds_per_point, 1.0, static_cast<double>(largest_cheap_chunk));
    const std::uint64_t fair = std::bit_floor(static_cast<std::uint64_t>(by_cost));
    const std::uint64_t shared =
        std::max(std::bit_ceil(points / chunks_for_balance + 1), std::min(fair, smallest_cheap_chunk));
    return std::max(std::min(fair, shared), std::bit_ceil((points + most_chunks - 1) / most_chunks));
}

std::uint64_t dense_chunk_size_for(const std::vector<Axis>& axes, double seconds_per_point)
{
    double points = 1;
    for (const Axis& axis : axes) points *= static_cast<double>(axis.values.size());
    const double by_cost = dense_chunk_seconds / (dense_computed_share * seconds_per_point);
    const double shared = std::min(by_cost, points / dense_chunks_for_balance);
    const auto wanted = static_cast<std::uint64_t>(std::clamp(shared, smallest_dense_chunk, largest_dense_chunk));
    std::uint64_t count = 1;
    for (std::size_t d = axes.size(); d-- > 0;) {
        const std::uint64_t size = axes[d].values.size(), most = std::max<std::uint64_t>(1, wanted / count);
        const std::uint64_t parts = (size + most - 1) / most;
        count *= (size + parts - 1) / parts;
        if (parts > 1) break;
    }
    return std::max(count, std::bit_ceil((static_cast<std::uint64_t>(points) + most_chunks - 1) / most_chunks));
}

PlanId id_of(const Plan& plan)
{
    Hash hash;
    hash.add("stickslip plan 1");
    hash.add(std::uint64_t{plan.axes.size()});
    for (const Axis& axis : plan.axes) {
        hash.add(axis.path);
        hash.add(axis.symbol);
        hash.add(axis.name);
        hash.add(unit_of(axis.quantity, plan.units));
        hash.add(std::uint64_t{axis.log});
        hash.add(axis.values);
    }
    hash.add(std::uint64_t{plan.units.motion == Motion::revolute});
    if (plan.units.command != Command::effort) hash.add(name_of(plan.units.command));
    hash.add(plan.joint);
    hash.add(plan.options);
    hash.add(std::uint64_t{plan.nonlinear});
    hash.add(RowFormat(plan.nonlinear).description());
    hash.add(plan.build);
    hash.add(plan.points);
    hash.add(plan.chunk_size);
    return hash.id();
}

Plan make_plan(const Joint& joint, std::vector<Axis> axes, const PlanOptions& options)
{
    check_axes(joint, axes);
    Plan plan;
    plan.points = count_points(axes, options.nonlinear);
    plan.axes = std::move(axes);
    plan.units = units_of(joint);
    plan.joint = canonical_text(joint);
    plan.options = options.evaluation;
    plan.nonlinear = options.nonlinear;
    plan.build = build_fingerprint();
    plan.chunk_size = options.dense ? dense_chunk_size_for(plan.axes, options.seconds_per_point)
                                    : chunk_size_for(plan.points, options.seconds_per_point);
    plan.title = options.title;
    plan.spec = options.spec;
    plan.command = options.command;
    plan.version = program_version();
    plan.id = id_of(plan);
    return plan;
}

}  // namespace stickslip
