#include "analysis/diagnosis/outcomes/share.h"

#include "analysis/diagnosis/policy/outcomes_and_rigs.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <set>

namespace stickslip::gap {
namespace {

/// 95 % interval of a ratio of sums over rows, the rows drawn anew with a fixed seed.
ConfidenceInterval bootstrap(std::size_t rows, const std::function<double(const std::vector<std::size_t>&)>& statistic)
{
    constexpr int draws = 400;
    std::mt19937 random(1991);
    std::vector<double> values;
    std::vector<std::size_t> drawn(rows);
    for (int d = 0; d < draws; ++d) {
        for (auto& i : drawn) i = random() % rows;
        const double v = statistic(drawn);
        if (std::isfinite(v)) values.push_back(v);
    }
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    return {values[values.size() / 40], values[values.size() - 1 - values.size() / 40]};
}

double row_cost(const Outcomes& o, const LawFit& f, std::size_t i)
{
    return -std::log(o.table.rows[i].stick_slip ? f.probability[i] : 1 - f.probability[i]);
}
bool row_wrong(const Outcomes& o, const LawFit& f, std::size_t i)
{
    return (f.probability[i] > policy::likelier_than_not) != o.table.rows[i].stick_slip;
}

}  // namespace

bool distinguished(const LawFit& better, const LawFit& other)
{
    return other.total() < better.total() - policy::clear_margin;
}

Cause cause_of(const OutcomeAnswer& a, const LawFit& fit, const LawFit* other_kind)
{
    const auto& o = a.outcomes;
    Cause c;
    c.names = {std::string(fit.rival->effect)};
    c.form = fit.rival->law;
    c.probability = fit.posterior;
    c.signatures = {"law:" + std::string(fit.rival->law)};
    c.misfit = -fit.total() / static_cast<double>(o.size());
    for (std::size_t k = 0; k < fit.rival->numbers.size(); ++k) {
        const auto& n = fit.rival->numbers[k];
        c.parameters.push_back({c.names[0] + "." + std::string(n.name), fit.values[k], fit.standard_error[k],
                                std::string(unit_of(n.quantity, Units(a.diagnosis.motion)))});
        const double share = (fit.x[k] - n.low) / (n.high - n.low);
        if (share < policy::beside_bound_of_law || share > 1 - policy::beside_bound_of_law) c.plausible = false;
    }
    const auto gain = [&](const std::vector<std::size_t>& rows) {
        double mine = 0, nominal = 0;
        for (std::size_t i : rows) mine += row_cost(o, fit, i), nominal += row_cost(o, a.nominal, i);
        return 1 - mine / nominal;
    };
    std::vector<std::size_t> all(o.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    c.heldout_gain = gain(all);
    c.heldout_gain_interval = bootstrap(o.size(), gain);
    c.signature = other_kind && distinguished(fit, *other_kind);
    return c;
}

namespace {

/// RMS of the logarithms by which a law misses the amplitudes of the rows; not set where it gives none.
double amplitude_error(const Outcomes& o, const LawFit& f)
{
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < o.size(); ++i)
        if (f.amplitude[i] > 0) {
            const double e = std::log(f.amplitude[i] / o.table.rows[i].amplitude);
            sum += e * e, count += 1;
        }
    return count > 0 ? std::sqrt(sum / count) : not_set;
}

/// Where along setting k the documented law is wrong: in thirds of the values that the rows have.
void add_thirds_of(std::size_t k, const OutcomeAnswer& a, double floor, std::vector<Share>& regimes)
{
    const auto& o = a.outcomes;
    std::set<double> values;
    for (const auto& row : o.table.rows) values.insert(row.settings[k]);
    if (values.size() < 3) return;
    const std::vector<double> sorted(values.begin(), values.end());
    const double low = sorted[sorted.size() / 3], high = sorted[2 * sorted.size() / 3];
    const std::string key = o.table.paths[k].substr(o.table.paths[k].rfind('.') + 1);
    const auto part_of = [&](double v) { return v < low ? 0 : v < high ? 1 : 2; };
    const char* names[] = {"low ", "middle ", "high "};
    for (int part = 0; part < 3; ++part) {
        const auto share = [&](const std::vector<std::size_t>& rows) {
            double here = 0, all = 0;
            for (std::size_t i : rows) {
                const double c = row_cost(o, a.nominal, i);
                all += c;
                if (part_of(o.table.rows[i].settings[k]) == part) here += c;
            }
            return here / all;
        };
        std::vector<std::size_t> all(o.size());
        double wrong = 0, count = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i] = i;
            if (part_of(o.table.rows[i].settings[k]) != part) continue;
            wrong += row_wrong(o, a.nominal, i), count += 1;
        }
        regimes.push_back({names[part] + key, share(all), bootstrap(o.size(), share), count > 0 ? wrong / count : 0,
                           floor, "share of its rows"});
    }
}

double explained(double before, double after, double least)
{
    const double whole = before * before - least * least;
    return whole > 0 ? (before * before - after * after) / whole : 0.0;
}

}  // namespace

void locate(OutcomeAnswer& a)
{
    const auto& o = a.outcomes;
    const auto n = static_cast<double>(o.size());
    Diagnosis& d = a.diagnosis;
    const double floor = std::max<double>(policy::wrong_rows, a.contradictions / n);
    double outcome_cost = -a.nominal.held_out, amplitude_cost = -a.nominal.amplitude_held_out;
    const double both = outcome_cost + amplitude_cost;
    d.signals.push_back({"outcome", outcome_cost / both, {}, a.nominal.misjudged / n, floor, "share of rows"});
    const double amplitude_before = amplitude_error(o, a.nominal);
    if (amplitude_cost > 0)
        d.signals.push_back(
            {"amplitude", amplitude_cost / both, {}, amplitude_before, policy::amplitude_spread, "of its logarithm"});
    for (std::size_t k = 0; k < o.table.paths.size(); ++k) add_thirds_of(k, a, floor, d.regimes);
    const LawFit& winner = d.verdict == Verdict::gap ? a.laws.front() : a.nominal;
    const double before = a.nominal.misjudged / n, after = winner.misjudged / n;
    d.gap.push_back({"outcome", "share of rows", before, after, floor, explained(before, after, floor)});
    if (std::isfinite(amplitude_before)) {
        const double left = amplitude_error(o, winner);
        d.gap.push_back({"amplitude", "RMS of its logarithm", amplitude_before, left, policy::amplitude_spread,
                         explained(amplitude_before, left, policy::amplitude_spread)});
    }
    d.overall = {before / floor, after / floor, 1, explained(before, after, floor), {}};
    d.overall.interval = bootstrap(o.size(), [&](const std::vector<std::size_t>& rows) {
        double b = 0, w = 0;
        for (std::size_t i : rows) b += row_wrong(o, a.nominal, i), w += row_wrong(o, winner, i);
        return explained(b / n, w / n, floor);
    });
    d.remainder.share = before > 0 ? std::min(1.0, after / before) : 0;
}

}  // namespace stickslip::gap
