#include "analysis/simulation/dense/cells.h"

#include <algorithm>
#include <cmath>

namespace stickslip::dense {
namespace {

/// The share of the bound that a cell's checks may use: between them the polynomial may miss by more.
constexpr double checked_share = 1.0 / 5;
/// Share of a cell's points from which it is computed whole: nodes and checks would be most of it.
constexpr double whole_share = 0.6;
constexpr int first_level = 2, last_level = 4;  ///< 5 to 17 nodes along an axis
constexpr int fewest_points = 3;                ///< along an axis that may still be cut
/// A miss of the coarse polynomial from which more nodes help rather than halves, where the checks have failed.
constexpr double resolved = 0.1;

/// The level to begin with among so many points.
int level_for(int points)
{
    int level = first_level;
    while (level > 0 && !resolves(points, level)) --level;
    return level;
}

double miss_of(const Interpolant& interpolant)
{
    return std::max({interpolant.coarse_miss(0), interpolant.coarse_miss(1), interpolant.coarse_miss(2)});
}

}  // namespace

Cells::Cells(Survey& survey, double bound) : survey_(survey), bound_(bound), owner_(survey.grid().points()) {}

void Cells::run()
{
    Cell whole;
    for (int d = 0; d < dimensions; ++d) {
        whole.box.high[d] = survey_.grid().size(d) - 1;
        whole.level[d] = level_for(survey_.grid().size(d));
    }
    cells_.push_back(whole);
    pending_.push_back(0);
    do {
        while (!pending_.empty()) {
            std::vector<std::size_t> waiting;
            while (!pending_.empty()) {
                const std::size_t number = pending_.back();
                pending_.pop_back();
                if (look(number) == Look::waits) waiting.push_back(number);
            }
            survey_.compute_wanted();
            pending_ = std::move(waiting);
        }
    } while (doubt_borders());
}

/// One look at a cell: what it lacks is wanted and it waits, or it is cut, or its rows are filled.
Cells::Look Cells::look(std::size_t number)
{
    const Cell cell = cells_[number];
    const Axes sides = survey_.linear_borders(cell.box);
    if (sides != Axes{}) return split(number, sides);
    if (!pays(cell)) return compute_all(number);
    const Interpolant nodes(survey_.grid(), cell.box, cell.level, 0);
    if (survey_.want_nodes(nodes)) return Look::waits;
    const std::size_t corner = survey_.grid().number(cell.box.low);
    const Kind kind = kind_of(survey_.row(corner));
    if (!survey_.one_kind(cell.box, kind)) return split(number, survey_.kind_borders(nodes));
    if (!kind.regular) return compute_all(number);

    const auto [sheet, interpolant] = best_fit(cell, kind);
    const double tolerated = checked_share * bound_;
    if (miss_of(interpolant) > std::sqrt(tolerated)) return refine(number, interpolant, false);
    if (survey_.want_checks(cell.box, interpolant)) return Look::waits;
    const double error = survey_.error_of(cell.box, interpolant, sheet);
    if (!(error <= tolerated)) return refine(number, interpolant, true);
    if (sheet.follows_growth(survey_.place(corner)) && !survey_.smooth_growth(cell, bound_))
        return split(number, {true, true, true});
    return accept(number, interpolant, sheet, kind, error);
}

/// In the form that the nodes like better.
std::pair<Sheet, Interpolant> Cells::best_fit(const Cell& cell, const Kind& kind) const
{
    const Sheet plain(kind, Form::plain), rooted(kind, Form::square_root);
    Interpolant by_plain = survey_.fit(cell, plain);
    if (!kind.grows || !kind.cycles()) return {plain, std::move(by_plain)};
    Interpolant by_rooted = survey_.fit(cell, rooted);
    if (miss_of(by_rooted) < miss_of(by_plain)) return {rooted, std::move(by_rooted)};
    return {plain, std::move(by_plain)};
}

/// More nodes along the axes that lack them most, where they promise the accuracy; else halves. `missed`: the checks
/// have failed although the nodes looked well.
Cells::Look Cells::refine(std::size_t number, const Interpolant& interpolant, bool missed)
{
    Cell& cell = cells_[number];
    const double tolerated = checked_share * bound_, largest = miss_of(interpolant);
    Axes lacking{};
    bool raised = false;
    for (int d = 0; d < dimensions; ++d) {
        const double miss = interpolant.coarse_miss(d);
        const bool lacks = missed ? 2 * miss >= largest : miss > std::sqrt(tolerated);
        lacking[d] = lacks && cell.box.size(d) > fewest_points;
        // half the nodes miss by the square root, so that twice as many miss by the fourth power of the coarse miss
        const bool promising = missed ? largest < resolved : miss < std::sqrt(std::sqrt(tolerated));
        if (!lacking[d] || !promising || cell.level[d] == last_level || !resolves(cell.box.size(d), cell.level[d] + 1))
            continue;
        ++cell.level[d];
        raised = true;
    }
    if (!raised) return split(number, lacking);
    pending_.push_back(number);
    return Look::closed;
}

Cells::Look Cells::accept(std::size_t number, const Interpolant& interpolant, const Sheet& sheet, const Kind& kind,
                          double error)
{
    bool sure = true;
    interpolant.for_each_point([&](const Index& i, std::span<const double> quantity) {
        const std::size_t point = survey_.grid().number(i);
        if (survey_.state(point) != Survey::State::open) return;
        const auto& row = survey_.interpolate(point, sheet, quantity, error);
        sure = sure && surely(kind, row, survey_.place(point), bound_);
        owner_[point] = static_cast<std::uint32_t>(number);
    });
    cells_[number].closed = true;
    if (sure) return Look::closed;
    open_again(number);
    return split(number, {true, true, true});
}

/// Halves along those axes, or along the others where these have no points left between; too small: all is computed.
Cells::Look Cells::split(std::size_t number, Axes axes)
{
    const Cell cell = cells_[number];
    const auto may = [&](int d) { return cell.box.size(d) > fewest_points; };
    const auto any = [&] { return (axes[0] && may(0)) || (axes[1] && may(1)) || (axes[2] && may(2)); };
    if (!any()) axes = {true, true, true};
    if (!any()) return compute_all(number);
    cells_[number].closed = true;
    Cell child = cell;
    std::array<int, dimensions> parts{};
    for (int d = 0; d < dimensions; ++d) parts[d] = axes[d] && may(d) ? 2 : 1;
    for_each_index({{0, 0, 0}, {parts[0] - 1, parts[1] - 1, parts[2] - 1}}, [&](const Index& part) {
        for (int d = 0; d < dimensions; ++d) {
            const int low = cell.box.low[d], high = cell.box.high[d], middle = (low + high) / 2;
            child.box.low[d] = part[d] == 1 ? middle : low;
            child.box.high[d] = parts[d] == 2 && part[d] == 0 ? middle : high;
            child.level[d] = level_for(child.box.size(d));
        }
        pending_.push_back(cells_.size());
        cells_.push_back(child);
    });
    return Look::closed;
}

Cells::Look Cells::compute_all(std::size_t number)
{
    for_each_index(cells_[number].box, [&](const Index& i) { survey_.want(i); });
    cells_[number].closed = true;
    return Look::closed;
}

/// Whether nodes and checks are fewer than the points that they stand for.
bool Cells::pays(const Cell& cell) const
{
    double nodes = 1, looked_at = 1;
    for (int d = 0; d < dimensions; ++d) {
        nodes *= std::min(cell.box.size(d), (1 << cell.level[d]) + 1);
        looked_at *= checks(cell.box.size(d));
    }
    return nodes + looked_at < whole_share * static_cast<double>(cell.box.points());
}

/// Wherever neighbours have different verdicts both are computed. False if all of them are.
bool Cells::doubt_borders()
{
    const Grid& grid = survey_.grid();
    const Box whole{{0, 0, 0}, {grid.size(0) - 1, grid.size(1) - 1, grid.size(2) - 1}};
    for_each_index(whole, [&](const Index& i) {
        const std::size_t point = grid.number(i);
        if (survey_.state(point) != Survey::State::interpolated) return;
        const auto verdict = verdict_of(survey_.row(point));
        bool differs = false;
        for_each_index(around(grid, i), [&](const Index& other) {
            differs = differs || verdict_of(survey_.row(grid.number(other))) != verdict;
        });
        if (differs) doubted_.emplace_back(point, survey_.row(point));
    });
    if (doubted_.empty()) return false;
    for (const auto& [point, row] : doubted_) {
        survey_.open_again(point);
        survey_.want(grid.index(point));
    }
    survey_.compute_wanted();
    open_contradicted();
    return true;
}

/// Cells whose rows are not what was computed in their place.
void Cells::open_contradicted()
{
    for (const auto& [point, row] : doubted_) {
        const auto& computed = survey_.row(point);
        const std::uint32_t number = owner_[point];
        const bool same =
            verdict_of(row) == verdict_of(computed) && difference(row, computed, survey_.place(point)) <= bound_;
        if (same || !cells_[number].closed) continue;
        open_again(number);
        cells_[number].closed = false;
        pending_.push_back(number);
    }
    doubted_.clear();
}

void Cells::open_again(std::size_t number)
{
    for_each_index(cells_[number].box, [&](const Index& i) {
        const std::size_t point = survey_.grid().number(i);
        if (survey_.state(point) == Survey::State::interpolated && owner_[point] == number) survey_.open_again(point);
    });
}

}  // namespace stickslip::dense
