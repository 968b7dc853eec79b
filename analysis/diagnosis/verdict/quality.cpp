#include "analysis/diagnosis/verdict/quality.h"

#include "analysis/diagnosis/ladder/plausible.h"
#include "analysis/diagnosis/policy/verdict.h"
#include "analysis/diagnosis/search/search.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

/// Covariance and standard errors from the information at the middle level and the priors of corrections.
void find_errors(const std::vector<Case>& cases, const Attribution& a, const Scales& scales, Quality& q)
{
    const auto n = static_cast<Eigen::Index>(a.candidate.parameter_count());
    q.standard_error.assign(static_cast<std::size_t>(n), not_set);
    const auto si = in_si(a.candidate, a.x[1], scales);
    if (a.information.rows() != n || n == 0 || !(a.information.diagonal().maxCoeff() > 0)) return;
    // weights are one over the rows of a record: undo that, and scale with what is left
    const double per_record = rows_of(cases) / static_cast<double>(cases.size());
    double left = 0;
    for (const auto& m : a.evaluation[1].records) left = std::max(left, m.position);
    Eigen::MatrixXd information = a.information * (per_record / std::max(1.0, left));
    // along what the records leave open a number is known as well as its document says
    for (Eigen::Index i = 0; i < n; ++i)
        if (const double sd = a.candidate.sd_of(static_cast<std::size_t>(i)); sd > 0)
            information(i, i) += 1 / (sd * sd);
    q.covariance = information.completeOrthogonalDecomposition().pseudoInverse();
    for (Eigen::Index i = 0; i < n; ++i) {
        // nothing depends on it, on a friction corrected to nothing, say: the others keep their errors
        if (!(a.information(i, i) > 0)) q.covariance(i, i) = infinity;
        const auto& p = a.candidate.parameter(static_cast<std::size_t>(i));
        const double error = std::sqrt(std::max(0.0, q.covariance(i, i)));
        // wider than its bounds: these records cannot distinguish it from another parameter
        const double widest = p.logarithmic ? std::log(p.high / p.low) : p.high - p.low;
        if (!(error < widest)) continue;
        q.standard_error[static_cast<std::size_t>(i)] =
            p.logarithmic ? error * si[static_cast<std::size_t>(i)] : error * unit_of(p.scale, scales);
    }
}

/// The pattern that the effect takes out of the residual, against the residual itself, second by second.
bool signature_found(const std::vector<Case>& cases, const Attribution& a, const Scales& scales)
{
    const auto si = in_si(a.candidate, a.x[1], scales);
    int acts = 0, found = 0;
    Innovation before, after;
    for (const auto& c : cases) {
        const Plant one = flatten(c.joint), two = flatten(edited(c.joint, a.candidate, si, c.number));
        predict(one, c.ticks, known_command(one, c.ticks), levels[1], before);
        predict(two, c.ticks, known_command(two, c.ticks), levels[1], after);
        const auto block = static_cast<std::size_t>(std::max(10.0, 1 / c.row_step));
        for (std::size_t b = 0; b + block <= c.ticks.size(); b += block) {
            double mm = 0, rr = 0, mr = 0;
            for (std::size_t k = b; k < b + block; ++k) {
                if (!c.ticks.logged[k]) continue;
                double r = before.position[k] / c.sigma, m = r - after.position[k] / c.sigma;
                if (c.effort_sigma > 0 && std::isfinite(before.effort[k])) {
                    const double er = before.effort[k] / c.effort_sigma, em = er - after.effort[k] / c.effort_sigma;
                    mm += em * em, rr += er * er, mr += em * er;
                }
                mm += m * m, rr += r * r, mr += m * r;
            }
            if (mm < policy::acting_square * static_cast<double>(block)) continue;  // does not act here
            ++acts;
            found += mr > policy::signature_correlation * std::sqrt(mm * rr);
        }
    }
    return acts > 0 ? static_cast<double>(found) >= policy::most_seconds * static_cast<double>(acts)
                    : a.explained > policy::mostly_explained;
}

}  // namespace

bool plausible_numbers(const Attribution& a)
{
    for (Eigen::Index i = 0; i < a.x[1].size(); ++i) {
        const auto& p = a.candidate.parameter(static_cast<std::size_t>(i));
        const double value = p.logarithmic ? std::exp(a.x[1][i]) : a.x[1][i];
        const bool far = !p.logarithmic && p.prior > 0 && std::abs(value) > policy::implausible_size * p.prior;
        if (at_bound(p, value) || far) return false;
    }
    return true;
}

Quality quality_of(const std::vector<Case>& cases, const Attribution& a, const Scales& scales)
{
    Quality q;
    find_errors(cases, a, scales, q);
    q.plausible = plausible_numbers(a);
    q.signature = signature_found(cases, a, scales);
    return q;
}

}  // namespace stickslip::gap
