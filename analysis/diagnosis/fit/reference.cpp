#include "analysis/diagnosis/fit/reference.h"

#include "analysis/diagnosis/plant/controller.h"
#include "analysis/diagnosis/policy/audit.h"
#include "analysis/diagnosis/policy/search.h"
#include "analysis/numerics/reference_rate.h"

#include <cmath>

namespace stickslip::gap {
namespace {

/// What the logged terms of the controller say of k_p r + k_v ṙ, tick by tick.
struct Seen {
    std::vector<double> sum;    ///< NaN between rows, and while a limit held
    std::vector<double> least;  ///< while a limit held: the sum was this or further out; else NaN
    std::vector<int> limited;   ///< sign of the command while a limit held, else 0
};

Seen see(const Case& c, double limit)
{
    const Ticks& t = c.ticks;
    const Control& control = c.joint.control;
    const std::size_t n = t.size(), m = static_cast<std::size_t>(t.ticks_per_row);
    const auto side = [&](std::size_t k) {
        if (!is_set(t.command[k]) || std::abs(t.command[k]) <= policy::below_limit * limit) return 0;
        return t.command[k] > 0 ? 1 : -1;
    };
    Seen seen{std::vector<double>(n, not_set), std::vector<double>(n, not_set), std::vector<int>(n, 0)};
    Controller controller(control);
    for (std::size_t k = 0; k < n; ++k) {
        const double exact = is_set(t.velocity[k]) ? t.velocity[k] : 0;
        controller.read(t.position[k], k == 0 ? t.step[0] : t.step[k - 1], exact);
        if (t.has_velocity && !t.rebuilt && is_set(t.velocity[k])) controller.believe(t.velocity[k]);
        const double fed_back = control.k_p * t.position[k] + control.k_v * controller.velocity();
        // between two rows at one limit the command was at it, too
        const std::size_t row = k - k % m, next = std::min(row + m, n - 1);
        seen.limited[k] = t.logged[k] || side(row) == side(next) ? side(row) : 0;
        if (seen.limited[k] != 0)
            seen.least[k] = seen.limited[k] * limit + fed_back;
        else if (t.logged[k] && is_set(t.command[k]))
            seen.sum[k] = t.command[k] - t.added(k) + fed_back;
    }
    return seen;
}

/// The sum at every row. A jump into a limit leads to what the sum is once the limit lets go; a smooth way into a limit
/// goes on straight to there.
std::vector<double> sum_at_rows(const Seen& seen, std::size_t m)
{
    std::vector<double> row;
    for (std::size_t k = 0; k < seen.sum.size(); k += m) row.push_back(seen.sum[k]);
    for (std::size_t a = 0; a < row.size(); ++a) {
        if (is_set(row[a])) continue;
        std::size_t b = a;
        while (b < row.size() && !is_set(row[b])) ++b;
        if (a == 0 && b == row.size()) return {};
        const double left = row[a == 0 ? b : a - 1], right = row[b == row.size() ? a - 1 : b];
        const double before = a > 1 ? std::abs(left - row[a - 2]) : 0, least = seen.least[a * m];
        const bool jumped = is_set(least) && seen.limited[a * m] * (least - left) > policy::jump_into_limit * before &&
                            b < row.size() && a > 0;
        for (std::size_t i = a; i < b; ++i) {
            const double part = static_cast<double>(i + 1 - a) / static_cast<double>(b + 1 - a);
            row[i] = jumped ? right : left + part * (right - left);
        }
        a = b;
    }
    return row;
}

void follow(Ticks& t, const Control& control, const std::vector<double>& sum)
{
    const bool follows_rate = control.reference_velocity && control.k_v != 0;
    t.reference[0] = sum[0] / control.k_p;
    t.reference_rate[0] = 0;
    for (std::size_t k = 1; k < t.size(); ++k) {
        if (!follows_rate) {
            t.reference[k] = sum[k] / control.k_p;
            t.reference_rate[k] = 0;
            continue;
        }
        // trapezoidal rule on k_v ṙ = sum − k_p r
        const double half = 0.5 * t.step[k - 1];
        t.reference[k] = (t.reference[k - 1] + half * (t.reference_rate[k - 1] + sum[k] / control.k_v)) /
                         (1 + half * control.k_p / control.k_v);
        t.reference_rate[k] = (sum[k] - control.k_p * t.reference[k]) / control.k_v;
    }
}

}  // namespace

bool rebuild_reference(Case& c, double limit)
{
    Ticks& t = c.ticks;
    const Control& control = c.joint.control;
    if (t.has_reference || t.source != CommandSource::logged || t.size() < 2 || control.k_p == 0 ||
        control.kind != ControlKind::position || !is_plain(control) || t.unseen_between())
        return false;
    const auto m = static_cast<std::size_t>(t.ticks_per_row);
    const Seen seen = see(c, limit);
    const auto row = sum_at_rows(seen, m);
    if (row.empty()) return false;
    t.jumps.clear();
    for (std::size_t at : jumps_of(row)) t.jumps.push_back(at * m);
    std::vector<double> sum(t.size());
    auto jump = t.jumps.begin();
    for (std::size_t k = 0; k < t.size(); ++k) {
        while (jump != t.jumps.end() && *jump + m <= k) ++jump;
        const double left = row[k / m], right = row[std::min(k / m + 1, row.size() - 1)];
        const bool jumps = jump != t.jumps.end() && *jump < k;
        sum[k] = jumps ? left : left + static_cast<double>(k % m) / static_cast<double>(m) * (right - left);
        if (seen.limited[k] > 0) sum[k] = std::max(sum[k], seen.least[k]);
        if (seen.limited[k] < 0) sum[k] = std::min(sum[k], seen.least[k]);
    }
    follow(t, control, sum);
    t.has_reference = t.reference_rebuilt = true;
    return true;
}

}  // namespace stickslip::gap
