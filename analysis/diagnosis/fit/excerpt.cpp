#include "analysis/diagnosis/fit/excerpt.h"

#include "analysis/diagnosis/plant/simulator.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stickslip::gap {
namespace {

constexpr double piece = 1, run_in = 0.3;  // numerical: s; the slowest observer forgets its start in 3/ω = 0.15 s
constexpr std::size_t fewest = 3;          // pieces of a record
constexpr std::size_t around = 4;          // rows on either side that give the velocity at a new start

struct Piece {
    std::size_t begin, end;  ///< ticks that are judged
    double misfit;
};

/// A record in pieces of a second, each with the nominal joint's mean log misfit: one lost step is not all there is.
std::vector<Piece> pieces_of(const Case& c, double omega)
{
    const Ticks& t = c.ticks;
    const auto m = static_cast<std::size_t>(t.ticks_per_row);
    const auto rows = std::max<std::size_t>(20, static_cast<std::size_t>(std::lround(piece / c.row_step)));
    std::vector<double> residuals;
    evaluate({c}, {}, {}, omega, &residuals);
    const auto count = t.rows();
    std::vector<Piece> pieces;
    for (std::size_t row = 0; row + rows / 2 < count; row += rows) {
        const std::size_t last = row + rows + rows / 2 < count ? row + rows : count;
        Piece p{row * m, last == count ? t.size() : last * m, 0};
        for (std::size_t i = row; i < last; ++i)
            for (std::size_t channel = i; channel < residuals.size(); channel += count)
                p.misfit += residuals[channel] * residuals[channel] / static_cast<double>(last - row);
        pieces.push_back(p);
        if (last == count) break;
    }
    return pieces;
}

/// Half of the pieces where the misfit is largest, half evenly from the rest; in the order of time.
std::vector<Piece> chosen(std::vector<Piece> pieces, std::size_t count)
{
    const auto by_time = [](const Piece& a, const Piece& b) { return a.begin < b.begin; };
    const std::size_t worst = count / 2;
    std::stable_sort(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) { return a.misfit > b.misfit; });
    std::sort(pieces.begin() + static_cast<std::ptrdiff_t>(worst), pieces.end(), by_time);
    std::vector<Piece> some(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(worst));
    const double stride = static_cast<double>(pieces.size() - worst) / static_cast<double>(count - worst);
    for (std::size_t i = 0; i < count - worst; ++i)
        some.push_back(pieces[worst + static_cast<std::size_t>(stride * (static_cast<double>(i) + 0.5))]);
    std::sort(some.begin(), some.end(), by_time);
    return some;
}

double velocity_at(const Ticks& t, std::size_t k)
{
    const std::size_t reach = around * static_cast<std::size_t>(t.ticks_per_row);
    const std::size_t a = k < reach ? 0 : k - reach, b = std::min(k + reach, t.size() - 1);
    return (t.position[b] - t.position[a]) / (t.time[b] - t.time[a]);
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from, std::size_t begin, std::size_t end)
{
    if (!from.empty())
        to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(begin),
                  from.begin() + static_cast<std::ptrdiff_t>(end));
}

Ticks cut(const Case& c, const std::vector<Piece>& some)
{
    const Ticks& t = c.ticks;
    Ticks out = t;
    for (auto* column :
         {&out.time, &out.step, &out.reference, &out.reference_rate, &out.position, &out.velocity, &out.command,
          &out.effort, &out.supply, &out.feed_forward, &out.load, &out.load_error, &out.inertia})
        column->clear();
    out.enabled.clear(), out.logged.clear(), out.jumps.clear();
    const auto m = static_cast<std::size_t>(t.ticks_per_row);
    const auto before = m * static_cast<std::size_t>(std::ceil(run_in / c.row_step));
    const auto integral = integral_of(c.joint, t);
    std::size_t done = 0;  // first tick that is not yet in
    for (const auto& p : some) {
        const std::size_t from = std::max(done, p.begin > before ? p.begin - before : 0);
        if (from > done) {
            const Restart start{out.time.size(), velocity_at(t, from), integral.empty() ? 0 : integral[from]};
            if (start.tick == 0)
                out.at_rest = false, out.initial_velocity = start.velocity, out.initial_integral = start.integral;
            else
                out.restarts.push_back(start);
        }
        append(out.time, t.time, from, p.end), append(out.step, t.step, from, p.end);
        append(out.reference, t.reference, from, p.end), append(out.reference_rate, t.reference_rate, from, p.end);
        append(out.position, t.position, from, p.end), append(out.velocity, t.velocity, from, p.end);
        append(out.command, t.command, from, p.end), append(out.effort, t.effort, from, p.end);
        append(out.supply, t.supply, from, p.end), append(out.enabled, t.enabled, from, p.end);
        append(out.feed_forward, t.feed_forward, from, p.end), append(out.load, t.load, from, p.end);
        append(out.load_error, t.load_error, from, p.end);
        append(out.inertia, t.inertia, from, p.end), append(out.logged, t.logged, from, p.end);
        out.judged.insert(out.judged.end(), p.begin - from, 0);
        out.judged.insert(out.judged.end(), p.end - p.begin, 1);
        done = p.end;
    }
    return out;
}

}  // namespace

std::vector<Case> excerpts(const std::vector<Case>& cases, double omega, std::size_t budget, double step_factor)
{
    std::vector<Case> some = cases;
    std::size_t total = 0;
    for (auto& c : some) c.step_factor = step_factor, total += c.ticks.size();
    constexpr double worth_cutting = 0.7;  // numerical: of the work
    const double share = static_cast<double>(budget) / static_cast<double>(total) / (1 + run_in / piece);
    if (share > worth_cutting) return some;
    for (auto& c : some) {
        const auto pieces = pieces_of(c, omega);
        const auto wanted = static_cast<std::size_t>(std::lround(share * static_cast<double>(pieces.size())));
        const std::size_t count = std::max(fewest, wanted);
        if (count < pieces.size()) c.ticks = cut(c, chosen(pieces, count));
    }
    return some;
}

std::vector<Case> uncut(std::vector<Case> cases, double step_factor)
{
    for (auto& c : cases) c.step_factor = step_factor;
    return cases;
}

}  // namespace stickslip::gap
