#include "analysis/simulation/dense/survey.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace stickslip::dense {
namespace {

/// Points of a map between two that are looked at, at most, whatever the polynomial: what is smaller and touches none
/// of them would not be seen.
constexpr int looked_at_every = 16;
constexpr int fewest_checks = 2;  ///< along an axis

/// An even lattice, so that no part of a cell is out of sight, and along each axis between the nodes where there is a
/// point between: on a line of nodes the other axes alone would be checked.
std::vector<int> check_indices(const LineNodes& line, int low, int high)
{
    const int points = high - low + 1, count = checks(points);
    std::vector<int> indices;
    for (int j = 0; j < count; ++j) {
        const int even = low + (2 * j + 1) * points / (2 * count);
        int best = even;
        for (int i = low; i <= high && line.is_node(even); ++i)
            if (!line.is_node(i) && (line.is_node(best) || std::abs(i - even) < std::abs(best - even))) best = i;
        indices.push_back(best);
    }
    return indices;
}

}  // namespace

int checks(int points)
{
    return points < 3 ? 1 : std::max(fewest_checks, (points + looked_at_every - 1) / looked_at_every);
}

Survey::Survey(const Grid& grid, std::span<const Place> places, std::span<PointResult> rows, const ComputeRows& compute)
    : grid_(grid), places_(places), rows_(rows), compute_(compute), state_(rows.size(), State::open)
{
    for (const auto& row : rows) region_.push_back(row.region);
}

bool Survey::want(const Index& i)
{
    const std::size_t point = grid_.number(i);
    if (state_[point] == State::open) {
        state_[point] = State::wanted;
        wanted_.push_back(point);
    }
    return state_[point] == State::wanted;
}

bool Survey::want_nodes(const Interpolant& nodes)
{
    bool lacks = false;
    nodes.for_each_node([&](const Index& i) { lacks |= want(i); });
    return lacks;
}

bool Survey::want_checks(const Box& box, const Interpolant& interpolant)
{
    std::array<std::vector<int>, dimensions> at;
    for (int d = 0; d < dimensions; ++d) at[d] = check_indices(interpolant.line(d), box.low[d], box.high[d]);
    bool lacks = false;
    for (const int a : at[0])
        for (const int b : at[1])
            for (const int c : at[2]) lacks |= want({a, b, c});
    return lacks;
}

const PointResult& Survey::interpolate(std::size_t point, const Sheet& sheet, std::span<const double> quantity,
                                       double error)
{
    sheet.give(quantity, places_[point], rows_[point]);
    rows_[point].interpolation_error = error;
    state_[point] = State::interpolated;
    return rows_[point];
}

void Survey::open_again(std::size_t point)
{
    rows_[point].region = region_[point];
    state_[point] = State::open;
}

void Survey::compute_wanted()
{
    std::sort(wanted_.begin(), wanted_.end());
    compute_(wanted_);
    for (const auto point : wanted_) state_[point] = State::computed;
    wanted_.clear();
}

Axes Survey::linear_borders(const Box& box) const
{
    Axes found{};
    for_each_index(box, [&](const Index& i) {
        const auto& row = rows_[grid_.number(i)];
        for (int d = 0; d < dimensions; ++d) {
            if (found[d] || i[d] == box.high[d]) continue;
            Index next = i;
            ++next[d];
            found[d] = rows_[grid_.number(next)].state_variable_stable != row.state_variable_stable;
        }
    });
    return found;
}

Axes Survey::kind_borders(const Interpolant& nodes) const
{
    Axes found{};
    nodes.for_each_node([&](const Index& i) {
        const Kind kind = kind_of(rows_[grid_.number(i)]);
        for (int d = 0; d < dimensions; ++d) {
            const auto& along = nodes.line(d).index;
            const auto after = std::upper_bound(along.begin(), along.end(), i[d]);
            if (found[d] || after == along.end()) continue;
            Index next = i;
            next[d] = *after;
            found[d] = !(kind_of(rows_[grid_.number(next)]) == kind);
        }
    });
    return found == Axes{} ? Axes{true, true, true} : found;
}

bool Survey::one_kind(const Box& box, const Kind& kind) const
{
    bool one = true;
    for_each_index(box, [&](const Index& i) {
        const std::size_t point = grid_.number(i);
        if (state_[point] == State::computed) one = one && kind_of(rows_[point]) == kind;
    });
    return one;
}

Interpolant Survey::fit(const Cell& cell, const Sheet& sheet) const
{
    Interpolant interpolant(grid_, cell.box, cell.level, sheet.quantities());
    interpolant.fill([&](const Index& i, std::span<double> quantity) {
        const std::size_t point = grid_.number(i);
        sheet.take(rows_[point], places_[point], quantity);
    });
    return interpolant;
}

bool Survey::smooth_growth(const Cell& cell, double bound) const
{
    Interpolant growth(grid_, cell.box, cell.level, 1);
    double largest = 0, miss = 0;
    growth.fill([&](const Index& i, std::span<double> value) {
        value[0] = rows_[grid_.number(i)].spectral_abscissa;
        largest = std::max(largest, std::abs(value[0]));
    });
    growth.for_each_point([&](const Index& i, std::span<const double> value) {
        miss = std::max(miss, std::abs(value[0] - rows_[grid_.number(i)].spectral_abscissa));
    });
    return miss <= bound * largest;
}

double Survey::error_of(const Box& box, const Interpolant& interpolant, const Sheet& sheet) const
{
    double error = 0;
    std::vector<double> quantity(sheet.quantities());
    for_each_index(box, [&](const Index& i) {
        const std::size_t point = grid_.number(i);
        if (state_[point] != State::computed || interpolant.is_node(i)) return;
        interpolant.at(i, quantity);
        PointResult row = rows_[point];
        sheet.give(quantity, places_[point], row);
        error = std::max(error, difference(row, rows_[point], places_[point]));
    });
    return error;
}

}  // namespace stickslip::dense
