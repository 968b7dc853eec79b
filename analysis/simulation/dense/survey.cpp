#include "analysis/simulation/dense/survey.h"

#include <algorithm>
#include <cmath>

namespace stickslip::dense {
namespace {

/// Points of a map between two that are looked at, at most, whatever the polynomial: what is smaller and touches none
/// of them would not be seen.
constexpr int looked_at_every = 16;
constexpr int fewest_checks = 2;  ///< along an axis

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

/// An even lattice, so that no part of a cell is out of sight, and none of it nodes.
bool Survey::want_checks(const Box& box, const Interpolant& interpolant)
{
    bool lacks = false;
    for_each_index({{0, 0, 0}, {checks(box.size(0)) - 1, checks(box.size(1)) - 1, checks(box.size(2)) - 1}},
                   [&](const Index& part) {
                       Index i;
                       for (int d = 0; d < dimensions; ++d)
                           i[d] = box.low[d] + (2 * part[d] + 1) * box.size(d) / (2 * checks(box.size(d)));
                       for (int d = 0; d < dimensions && interpolant.is_node(i); ++d) i[d] += i[d] < box.high[d];
                       lacks |= want(i);
                   });
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
