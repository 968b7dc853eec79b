#include "analysis/diagnosis/records/even_clock.h"

#include "analysis/diagnosis/policy/records.h"
#include "analysis/diagnosis/records/ticks.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

constexpr std::size_t least_rows = 100;  // fewer do not tell scatter from wandering
constexpr double already_even = 1e-4;    // numerical: of a row, RMS: digits of a log
constexpr double farthest = 0.45;        // numerical: of a row: half a row away is the next one

/// Mean square by which readings are off the cubic through their two neighbours on either side.
double roughness(const std::vector<double>& time, const std::vector<double>& readings)
{
    double sum = 0;
    for (std::size_t k = 2; k + 2 < time.size(); ++k) {
        const std::size_t at[]{k - 2, k - 1, k + 1, k + 2};
        double off = readings[k];
        for (const std::size_t i : at) {
            double weight = 1;  // Lagrange's
            for (const std::size_t j : at)
                if (j != i) weight *= (time[k] - time[j]) / (time[i] - time[j]);
            off -= weight * readings[i];
        }
        sum += off * off;
    }
    return sum / static_cast<double>(time.size());
}

}  // namespace

std::optional<std::vector<double>> even_times(const std::vector<double>& stamps, const std::vector<double>& readings,
                                              double period)
{
    if (stamps.size() < least_rows || !(period > 0)) return std::nullopt;
    const double step = median_step(stamps), row = std::max(1.0, std::round(step / period)) * period;
    if (std::abs(step - row) > policy::whole_row * row) return std::nullopt;
    std::vector<double> off;
    for (const double t : stamps) {
        const double rows = (t - stamps[0]) / row;
        off.push_back(rows - std::round(rows));
    }
    std::nth_element(off.begin(), off.begin() + off.size() / 2, off.end());
    const double first = off[off.size() / 2];  // the first stamp scatters, too
    std::vector<double> even;
    double squares = 0, differences = 0, before = 0;
    for (std::size_t k = 0; k < stamps.size(); ++k) {
        const double rows = (stamps[k] - stamps[0]) / row - first, deviation = rows - std::round(rows);
        const double time = stamps[0] + row * (first + std::round(rows));
        if (std::abs(deviation) > farthest || (k > 0 && !(time > even.back() + 0.5 * row))) return std::nullopt;
        squares += deviation * deviation;
        if (k > 0) differences += (deviation - before) * (deviation - before);
        before = deviation;
        even.push_back(time);
    }
    const double rms = std::sqrt(squares / static_cast<double>(stamps.size()));
    if (rms < already_even || differences < policy::scattered_stamps * squares) return std::nullopt;
    if (rms > policy::jitter_unquestioned && !(roughness(even, readings) < roughness(stamps, readings)))
        return std::nullopt;
    return even;
}

}  // namespace stickslip::gap
