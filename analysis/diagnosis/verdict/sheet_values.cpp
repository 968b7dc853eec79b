#include "analysis/diagnosis/verdict/sheet_values.h"

#include "analysis/diagnosis/policy/page_and_plan.h"
#include "analysis/diagnosis/verdict/data_sheet.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stickslip::gap {
namespace {

double mean(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// In every record, which may have numbers of its own.
std::vector<double> values_of(const SheetNumber& number, const Prepared& p, const Candidate& candidate,
                              const Eigen::VectorXd& x)
{
    const auto si = in_si(candidate, x, p.scales);
    std::vector<double> values;
    for (const auto& c : p.cases) {
        Joint joint = edited(c.joint, candidate, si, c.number), documented = c.joint;
        values.push_back(number.of(joint) / (number.per_documented ? number.of(documented) : 1));
    }
    return values;
}

double mean_of(const SheetNumber& number, const Prepared& p, const Candidate& candidate, const Eigen::VectorXd& x)
{
    return mean(values_of(number, p, candidate, x));
}

/// Of the mean, by the scatter between records: what they share is known no better, however exactly each is.
double error_of_mean(const std::vector<double>& values)
{
    if (values.size() < 2) return 0;
    const double n = static_cast<double>(values.size()), middle = mean(values);
    double squares = 0;
    for (const double v : values) squares += (v - middle) * (v - middle);
    return std::sqrt(squares / (n - 1) / n);
}

/// Its change by each fitted number.
Eigen::VectorXd slope_of(const SheetNumber& number, const Prepared& p, const Candidate& c, const Eigen::VectorXd& x)
{
    constexpr double small = 1e-4;  // numerical: of the unit in which a parameter is fitted
    Eigen::VectorXd slope(x.size());
    for (Eigen::Index k = 0; k < x.size(); ++k) {
        Eigen::VectorXd more = x, less = x;
        more[k] += small, less[k] -= small;
        slope[k] = (mean_of(number, p, c, more) - mean_of(number, p, c, less)) / (2 * small);
    }
    return slope;
}

/// Standard error of what has this slope; NaN where that of a fitted number that it depends on is not known.
double error_along(const Eigen::VectorXd& slope, const Eigen::MatrixXd& covariance)
{
    double variance = 0;
    for (Eigen::Index k = 0; k < slope.size(); ++k)
        for (Eigen::Index l = 0; l < slope.size(); ++l) {
            if (slope[k] == 0 || slope[l] == 0) continue;
            if (!std::isfinite(covariance(k, l))) return not_set;
            variance += slope[k] * covariance(k, l) * slope[l];
        }
    return std::sqrt(std::max(0.0, variance));
}

}  // namespace

std::vector<SheetValue> sheet_values(const Prepared& p, const Attribution& a, const Quality& quality,
                                     std::size_t corrections)
{
    const Candidate& c = a.candidate;
    const Eigen::VectorXd& x = a.x[ladder_level];
    std::vector<SheetValue> values;
    for (const auto& number : data_sheet()) {
        bool changed = false, by_direction = false, read_off = false;
        for (std::size_t i = corrections; i < c.effects.size(); ++i) {
            by_direction |= c.effects[i]->name == "asymmetric-friction";
            if (!is_about(number, *c.effects[i], *c.forms[i])) continue;
            changed = true, read_off |= c.effects[i]->read_off;
        }
        const bool both_ways = number.effect == "coulomb-level" || number.effect == "viscous";
        if (!changed || (by_direction && both_ways)) continue;
        SheetValue v{std::string(number.key), mean_of(number, p, c, x), {}, {}};
        if (!std::isfinite(v.value)) continue;  // a cascade has no k_p of its own
        if (number.quantity != Quantity::number)
            v.unit = std::string(unit_of(number.quantity, units_of(p.documented[0])));
        if (read_off) {
            v.interval = {v.value, v.value};
            v.pinned = true;
        } else if (quality.covariance.rows() == x.size()) {
            const Eigen::VectorXd slope = slope_of(number, p, c, x);
            if (slope.isZero()) continue;  // this form leaves it as it is documented
            const double of_fit = error_along(slope, quality.covariance),
                         of_records = error_of_mean(values_of(number, p, c, x));
            const double error = policy::two_sided_95 * std::hypot(of_fit, of_records);
            if (std::isfinite(error)) {
                v.interval = {v.value - error, v.value + error};
                v.pinned = error < std::abs(v.value);
            }
        }
        values.push_back(std::move(v));
    }
    return values;
}

std::vector<SheetValue> sheet_values_of_findings(const Prepared& p)
{
    std::vector<SheetValue> values;
    const Units units = units_of(p.documented[0]);
    Joint documented = p.documented[0], found = p.cases[0].joint;
    for (const auto& finding : p.audit.findings) {
        const auto changed = [&](const SheetNumber& number) {
            const double now = number.of(found);
            return number.effect == finding.effect && std::isfinite(now) && now != number.of(documented) &&
                   std::ranges::count(values, number.key, &SheetValue::key) == 0;
        };
        const auto number = std::ranges::find_if(data_sheet(), changed);
        const bool known = number != data_sheet().end() && !number->per_documented;
        SheetValue v;
        v.key = known ? std::string(number->key) : finding.parameter;
        v.value = known ? number->of(found) : finding.value;
        const double error = policy::two_sided_95 * finding.stderr_ * std::abs(v.value / finding.value);
        v.interval = {v.value - error, v.value + error};
        v.pinned = error < std::abs(v.value);
        const Quantity quantity = known ? number->quantity : finding.quantity;
        if (quantity != Quantity::number) v.unit = std::string(unit_of(quantity, units));
        values.push_back(std::move(v));
    }
    return values;
}

bool has_sheet_value(const Effect& effect, const EffectForm& form)
{
    return std::ranges::any_of(data_sheet(), [&](const SheetNumber& number) { return is_about(number, effect, form); });
}

}  // namespace stickslip::gap
