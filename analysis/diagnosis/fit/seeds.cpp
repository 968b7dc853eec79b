#include "analysis/diagnosis/fit/seeds.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace stickslip::gap {
namespace {

constexpr std::size_t most_samples = 6000;  // a record enough for a grid

/// Residual force and what it is plotted over.
struct Residual {
    std::vector<double> force, over;
    double span = 1;
};

std::vector<Residual> residuals(const FitProblem& problem, const std::vector<double>& si, FrequencyGrid grid)
{
    std::vector<Residual> all;
    Innovation innovation;
    for (const auto& c : problem.cases) {
        const Plant plant = flatten(edited(c.joint, problem.candidate, si, c.number));
        const auto command = known_command(plant, c.ticks);
        predict(plant, c.ticks, command, problem.omega, innovation);
        Residual r;
        const std::size_t stride = std::max<std::size_t>(1, c.ticks.size() / most_samples);
        for (std::size_t k = 0; k + stride <= c.ticks.size(); k += stride) {
            double sum = 0, speed = 0;
            std::size_t n = 0;
            for (std::size_t i = k; i < k + stride; ++i)
                if (c.ticks.logged[i] && (c.ticks.judged.empty() || c.ticks.judged[i]))
                    sum += innovation.position[i], speed += innovation.velocity[i], ++n;
            if (!n) continue;
            double e = sum / static_cast<double>(n);
            if (!std::isfinite(e)) e = 0;
            const double v = speed / static_cast<double>(n);
            if (grid == FrequencyGrid::position_flipped) e *= v > 0 ? 1 : v < 0 ? -1 : 0;
            r.force.push_back(e);
            r.over.push_back(grid == FrequencyGrid::time ? c.ticks.time[k] - c.ticks.time[0] : c.ticks.position[k]);
        }
        if (r.force.empty()) continue;
        double mean = 0;
        for (double f : r.force) mean += f / static_cast<double>(r.force.size());
        for (double& f : r.force) f -= mean;
        const auto [low, high] = std::minmax_element(r.over.begin(), r.over.end());
        r.span = std::max(*high - *low, 1e-12);
        all.push_back(std::move(r));
    }
    return all;
}

/// Power at equally spaced frequencies: the part of each record's residual that a least-squares sine explains, summed
/// over records. A sample's sine and cosine turn by the same angle from one frequency to the next.
std::vector<double> powers_of(const std::vector<Residual>& all, double low, double step, std::size_t count)
{
    std::vector<double> total(count, 0);
    for (const auto& r : all) {
        const std::size_t n = r.force.size();
        std::vector<double> sine(n), cosine(n), turn_sine(n), turn_cosine(n);
        double square = 0;
        for (std::size_t i = 0; i < n; ++i) {
            sine[i] = std::sin(low * r.over[i]), cosine[i] = std::cos(low * r.over[i]);
            turn_sine[i] = std::sin(step * r.over[i]), turn_cosine[i] = std::cos(step * r.over[i]);
            square += r.force[i] * r.force[i];
        }
        for (std::size_t f = 0; f < count && square > 0; ++f) {
            double ss = 0, sc = 0, s = 0, c = 0;
            for (std::size_t i = 0; i < n; ++i) {
                const double a = sine[i], b = cosine[i];
                ss += a * a, sc += a * b, s += a * r.force[i], c += b * r.force[i];
                sine[i] = a * turn_cosine[i] + b * turn_sine[i];
                cosine[i] = b * turn_cosine[i] - a * turn_sine[i];
            }
            const double cc = static_cast<double>(n) - ss, determinant = ss * cc - sc * sc;
            constexpr double collinear = 1e-6;  // numerical: of the largest determinant
            if (determinant > collinear * (ss + cc) * (ss + cc))
                total[f] += (s * s * cc - 2 * s * c * sc + c * c * ss) / determinant / square;
        }
    }
    return total;
}

}  // namespace

std::vector<double> grid_peaks(const FitProblem& problem, const std::vector<double>& si, FrequencyGrid grid,
                               std::size_t count)
{
    const auto all = residuals(problem, si, grid);
    if (all.empty()) return {};
    double span = 0;
    for (const auto& r : all) span = std::max(span, r.span);
    // half the resolution of the longest record; up to 1200 bins
    const double bin = (grid == FrequencyGrid::time ? 2.0 : 2.5) / span;  // numerical: 1/resolution
    const double low = (grid == FrequencyGrid::time ? 4.0 : 3.0) / span;  // numerical: half a wave
    const double highest = grid == FrequencyGrid::time
                               ? std::min(600.0, 0.5 * std::numbers::pi / problem.cases[0].row_step)
                               : 2000 / problem.scales.position;
    const std::size_t bins = std::min<std::size_t>(grid == FrequencyGrid::time ? 1500 : 500,
                                                   static_cast<std::size_t>((highest - low) / bin) + 1);
    const auto powers = powers_of(all, low, bin, bins);
    std::vector<std::size_t> peaks;
    for (std::size_t i = 0; i < bins; ++i)
        if ((i == 0 || powers[i] >= powers[i - 1]) && (i + 1 == bins || powers[i] > powers[i + 1])) peaks.push_back(i);
    std::sort(peaks.begin(), peaks.end(), [&](auto a, auto b) { return powers[a] > powers[b]; });
    std::vector<double> found;
    for (std::size_t i = 0; i < peaks.size() && found.size() < count; ++i) {
        // refine between the neighbouring bins
        double best = low + bin * static_cast<double>(peaks[i]), least = powers[peaks[i]];
        constexpr double finer = 0.2;  // numerical: of a bin
        constexpr std::size_t either_side = 4;
        const double from = best - finer * either_side * bin;
        const auto near = powers_of(all, from, finer * bin, 2 * either_side + 1);
        for (std::size_t j = 0; j < near.size(); ++j) {
            const double f = from + finer * bin * static_cast<double>(j);
            if (f > 0 && near[j] > least) least = near[j], best = f;
        }
        found.push_back(best);
    }
    return found;
}

std::vector<Eigen::VectorXd> starts(const std::vector<Case>& cases, const Scales& scales, const Candidate& single,
                                    const Candidate& base, const std::vector<double>& si)
{
    const EffectForm& form = *single.forms.front();
    const auto in_every_record = [&](std::vector<double> seed) {
        const std::vector<double> own(seed.end() - static_cast<std::ptrdiff_t>(form.own), seed.end());
        for (std::size_t r = 1; r < single.records; ++r) seed.insert(seed.end(), own.begin(), own.end());
        return to_fit(single, seed);
    };
    const FitProblem fastest{cases, base, scales, levels[0]};
    std::vector<Eigen::VectorXd> all;
    for (std::size_t i = 0; i < form.parameters.size(); ++i)
        if (const auto& p = form.parameters[i]; p.grid != FrequencyGrid::none) {
            // a weak force is hidden from a fast observer by the noise, one that changes fast from a slow one
            auto peaks = grid_peaks(fastest, si, p.grid, 3);
            constexpr double same = 0.02;  // numerical: starts that are one
            for (double f : grid_peaks(fastest.with_bandwidth(levels[1]), si, p.grid, 2))
                if (std::ranges::none_of(peaks, [&](double other) { return std::abs(f - other) < same * other; }))
                    peaks.push_back(f);
            for (double f : peaks) {
                auto seed = form.seeds.front();
                // peaks are those of the seen position, whichever body the wave belongs to
                seed[i] = f / unit_of(p.grid == FrequencyGrid::time ? p.scale : Scale::wave_number, scales);
                all.push_back(in_every_record(seed));
            }
            return all;
        }
    for (const auto& seed : form.seeds) all.push_back(in_every_record(seed));
    return all;
}

}  // namespace stickslip::gap
