#include "analysis/diagnosis/fit/fit.h"

#include "analysis/diagnosis/fit/block.h"
#include "analysis/diagnosis/plant/step.h"
#include "analysis/numerics/optimise.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

constexpr double block_time = 0.2;  // s
constexpr double block_scale = 20;  // mse over floor at which a block begins to count less

double bounded(const EffectParameter& p, double x)
{
    if (p.logarithmic) return std::clamp(x, std::log(p.low), std::log(p.high));
    return std::clamp(x, p.low, p.high);
}

Eigen::VectorXd bounded(const Candidate& c, Eigen::VectorXd x)
{
    for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = bounded(c.parameter(static_cast<std::size_t>(i)), x[i]);
    return x;
}

/// Adds one channel's blocks to the objective and lists their mean squares; gives the mean square of all.
double add_blocks(const std::vector<double>& scaled, std::size_t begin, std::size_t count, std::size_t block,
                  double& objective, std::vector<double>& blocks)
{
    double total = 0, robust = 0;
    for (std::size_t b = 0; b < count; b += block) {
        const std::size_t end = std::min(b + block, count);
        double sum = 0;
        for (std::size_t i = b; i < end; ++i) sum += scaled[begin + i] * scaled[begin + i];
        total += sum;
        const double rows = static_cast<double>(end - b);
        blocks.push_back(sum / rows);
        robust += rows * block_scale * std::log1p(blocks.back() / block_scale);
    }
    const double n = static_cast<double>(std::max<std::size_t>(count, 1));
    objective += robust / n;
    return total / n;
}

std::size_t block_rows(const Case& c)
{
    return std::max<std::size_t>(4, static_cast<std::size_t>(block_time / c.row_step));
}

/// Weights of the scaled residuals that make a weighted least-squares step a step on the robust objective.
void block_weights(const std::vector<Case>& cases, const std::vector<double>& scaled, std::vector<double>& weights)
{
    weights.resize(scaled.size());
    std::size_t begin = 0;
    for (const auto& c : cases) {
        const std::size_t rows = c.ticks.rows();
        const std::size_t channels = c.effort_sigma > 0 ? 2 : 1, block = block_rows(c);
        for (std::size_t ch = 0; ch < channels; ++ch, begin += rows)
            for (std::size_t b = 0; b < rows; b += block) {
                const std::size_t end = std::min(b + block, rows);
                double sum = 0;
                for (std::size_t i = b; i < end; ++i) sum += scaled[begin + i] * scaled[begin + i];
                const double w = 1 / (1 + sum / static_cast<double>(end - b) / block_scale) / static_cast<double>(rows);
                for (std::size_t i = b; i < end; ++i) weights[begin + i] = w;
            }
    }
}

}  // namespace

std::vector<double> in_si(const Candidate& candidate, const Eigen::VectorXd& x, const Scales& scales)
{
    std::vector<double> si(static_cast<std::size_t>(x.size()));
    for (std::size_t i = 0; i < si.size(); ++i) {
        const auto& p = candidate.parameter(i);
        const double value = bounded(p, x[static_cast<Eigen::Index>(i)]);
        si[i] = unit_of(p.scale, scales) * (p.logarithmic ? std::exp(value) : value);
    }
    return si;
}

Eigen::VectorXd to_fit(const Candidate& candidate, const std::vector<double>& scaled)
{
    Eigen::VectorXd x(static_cast<Eigen::Index>(scaled.size()));
    for (std::size_t i = 0; i < scaled.size(); ++i) {
        const auto& p = candidate.parameter(i);
        const double value = std::clamp(scaled[i], p.low, p.high);
        x[static_cast<Eigen::Index>(i)] = p.logarithmic ? std::log(value) : value;
    }
    return x;
}

Joint edited(const Joint& joint, const Candidate& candidate, const std::vector<double>& si, std::size_t record)
{
    Joint j = joint;
    auto first = si.begin();
    for (const auto* form : candidate.forms) {
        const auto shared = static_cast<std::ptrdiff_t>(form->parameters.size() - form->own);
        const auto own =
            first + shared + static_cast<std::ptrdiff_t>(form->own * std::min(record, candidate.records - 1));
        std::vector<double> p(first, first + shared);
        p.insert(p.end(), own, own + static_cast<std::ptrdiff_t>(form->own));
        if (form->apply) form->apply(j, p.data());
        first += static_cast<std::ptrdiff_t>(candidate.count_of(*form));
    }
    return j;
}

Plant edited_plant(const Joint& joint, const Candidate& candidate, const std::vector<double>& si, std::size_t record)
{
    Plant plant = flatten(edited(joint, candidate, si, record));
    auto first = si.begin();
    for (const auto* form : candidate.forms) {
        if (form->apply_free) form->apply_free(plant.free, &*first);
        first += static_cast<std::ptrdiff_t>(candidate.count_of(*form));
    }
    return plant;
}

double effort_floor(const Case& c, double omega)
{
    const double drag = push_of(c.joint.actuator, 0, c.joint.actuator.supply_voltage, 0).drag;
    return std::hypot(c.effort_sigma, drag * c.sigma * std::sqrt(velocity_noise_amplification(omega, c.row_step)));
}

double prior_cost(const Candidate& candidate, const Eigen::VectorXd& x)
{
    double cost = 0;
    for (Eigen::Index i = 0; i < x.size() && candidate.prior_weight > 0; ++i)
        if (const double sd = candidate.sd_of(static_cast<std::size_t>(i)); sd > 0)
            cost += candidate.prior_weight * (x[i] / sd) * (x[i] / sd);
    return cost;
}

namespace {

/// Appends the scaled residuals of one record: position rows, then effort rows.
void append_residuals(const Case& c, const Candidate& candidate, const std::vector<double>& si, double omega,
                      std::vector<double>& scaled)
{
    Innovation innovation;
    Plant plant = edited_plant(c.joint, candidate, si, c.number);
    plant.step_factor = c.step_factor;
    predict(plant, c.ticks, known_command(plant, c.ticks), omega, innovation);
    const double per_floor = 1 / (c.sigma * std::sqrt(noise_amplification(omega, c.row_step)));
    constexpr double far = 1e6;  // a diverged prediction is bad, not infinitely bad
    for (std::size_t k = 0; k < c.ticks.size(); ++k)
        if (c.ticks.logged[k]) {
            const double e = innovation.position[k] * per_floor;
            scaled.push_back(!c.judged(k) ? 0 : std::isfinite(e) ? std::clamp(e, -far, far) : far);
        }
    if (!(c.effort_sigma > 0)) return;
    const double per_effort = 1 / effort_floor(c, omega);
    for (std::size_t k = 0; k < c.ticks.size(); ++k)
        if (c.ticks.logged[k]) {
            const double e = innovation.effort[k] * per_effort;
            scaled.push_back(c.judged(k) && std::isfinite(e) ? std::clamp(e, -far, far) : 0);
        }
}

/// Whose value this parameter is: the number of a record, or no_record where all share it.
constexpr std::size_t no_record = static_cast<std::size_t>(-1);
std::size_t record_of(const Candidate& candidate, std::size_t parameter)
{
    for (const auto* f : candidate.forms) {
        const std::size_t shared = f->parameters.size() - f->own;
        if (parameter < candidate.count_of(*f)) return parameter < shared ? no_record : (parameter - shared) / f->own;
        parameter -= candidate.count_of(*f);
    }
    return no_record;
}

/// The residuals once a parameter has moved: a record's own one changes no other record, which is not simulated again.
void moved_residuals(const std::vector<Case>& cases, const Candidate& candidate, const std::vector<double>& si,
                     double omega, std::size_t parameter, const std::vector<double>& here, std::vector<double>& there)
{
    const std::size_t own = record_of(candidate, parameter);
    there.clear();
    for (const auto& c : cases) {
        if (own == no_record || own == std::min(c.number, candidate.records - 1)) {
            append_residuals(c, candidate, si, omega, there);
            continue;
        }
        const std::size_t rows = c.ticks.rows() * (c.effort_sigma > 0 ? 2 : 1);
        const auto from = here.begin() + static_cast<std::ptrdiff_t>(there.size());
        there.insert(there.end(), from, from + static_cast<std::ptrdiff_t>(rows));
    }
}

}  // namespace

Evaluation evaluate(const std::vector<Case>& cases, const Candidate& candidate, const std::vector<double>& si,
                    double omega, std::vector<double>* residuals)
{
    Evaluation result;
    std::vector<double> own;
    std::vector<double>& scaled = residuals ? *residuals : own;
    scaled.clear();
    for (const auto& c : cases) {
        const std::size_t block = block_rows(c), begin = scaled.size();
        append_residuals(c, candidate, si, omega, scaled);
        const std::size_t rows = (scaled.size() - begin) / (c.effort_sigma > 0 ? 2 : 1);
        Misfit misfit;
        misfit.position = add_blocks(scaled, begin, rows, block, result.objective, misfit.position_blocks);
        if (c.effort_sigma > 0)
            misfit.effort = add_blocks(scaled, begin + rows, rows, block, result.objective, misfit.effort_blocks);
        result.records.push_back(misfit);
    }
    result.objective /= static_cast<double>(cases.size());
    return result;
}

LevelFit descend(const std::vector<Case>& cases, const Candidate& candidate, const Scales& scales, Eigen::VectorXd x,
                 double omega, int iterations)
{
    return descend_block(cases, candidate, scales, std::move(x), omega, iterations, {});
}

LevelFit descend_block(const std::vector<Case>& cases, const Candidate& candidate, const Scales& scales,
                       Eigen::VectorXd x, double omega, int iterations, const Kept& kept)
{
    LevelFit fit;
    const auto n = static_cast<Eigen::Index>(candidate.parameter_count());
    fit.x = bounded(candidate, std::move(x));
    fit.information = Eigen::MatrixXd::Zero(n, n);
    std::vector<double> here, there, weights;
    const auto evaluated = [&](const Eigen::VectorXd& at, std::vector<double>& residuals) {
        auto found = evaluate(cases, candidate, in_si(candidate, at, scales), omega, &residuals);
        found.objective += prior_cost(candidate, at);
        ++fit.evaluations;
        return found;
    };
    fit.evaluation = evaluated(fit.x, here);
    double damping = 1e-3;
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(here.size()), n);
    LevelFit best = fit;
    Eigen::VectorXd last = fit.x;  // where the step came from; at first, where the effect is absent
    for (Eigen::Index i = 0; i < n; ++i)
        if (candidate.parameter(static_cast<std::size_t>(i)).vanishes) last[i] = 0;
    constexpr int most_halvings = 10;
    int halvings = 0;
    // numbers with a prior hardly move: their slopes are found anew every few steps, and where a step fails
    constexpr int worn_after = 3;
    int age = 0;
    for (int iteration = 0; iteration < iterations && n > 0; ++iteration) {
        const Eigen::Map<const Eigen::VectorXd> r(here.data(), static_cast<Eigen::Index>(here.size()));
        const auto slope = [&](Eigen::Index i) -> Eigen::VectorXd {
            Eigen::VectorXd shifted = fit.x;
            double step = 1e-4 * std::max(0.1, std::abs(candidate.parameter(static_cast<std::size_t>(i)).prior));
            if (candidate.parameter(static_cast<std::size_t>(i)).logarithmic) step = 1e-4;
            shifted[i] += step;
            if (bounded(candidate, shifted)[i] != shifted[i]) shifted[i] -= 2 * step, step = -step;
            moved_residuals(cases, candidate, in_si(candidate, shifted, scales), omega, static_cast<std::size_t>(i),
                            here, there);
            ++fit.evaluations;
            return (Eigen::Map<const Eigen::VectorXd>(there.data(), r.size()) - r) / step;
        };
        for (Eigen::Index i = 0; i < n; ++i) {
            if (!kept.empty() && kept[static_cast<std::size_t>(i)]) continue;
            if (age > 0 && candidate.sd_of(static_cast<std::size_t>(i)) > 0) continue;
            jacobian.col(i) = slope(i);
            const bool lost = candidate.parameter(static_cast<std::size_t>(i)).vanishes && last[i] != fit.x[i] &&
                              jacobian.col(i).isZero(0);
            if (!lost || halvings == most_halvings) continue;
            // friction that has been taken away altogether has no slope that leads back: half way, and all slopes anew
            fit.x[i] = 0.5 * (fit.x[i] + last[i]);
            fit.evaluation = evaluated(fit.x, here);
            ++halvings;
            i = -1;
        }
        block_weights(cases, here, weights);
        const Eigen::Map<const Eigen::VectorXd> w(weights.data(), r.size());
        const Eigen::MatrixXd weighted = w.asDiagonal() * jacobian;
        Eigen::MatrixXd normal = jacobian.transpose() * weighted;
        Eigen::VectorXd gradient = weighted.transpose() * r;
        for (Eigen::Index i = 0; i < n && candidate.prior_weight > 0; ++i)
            if (const double sd = candidate.sd_of(static_cast<std::size_t>(i)); sd > 0) {
                const double row = candidate.prior_weight * static_cast<double>(cases.size()) / (sd * sd);
                normal(i, i) += row, gradient[i] += row * fit.x[i];
            }
        fit.information = normal;
        bool better = false;
        const double before = fit.evaluation.objective;
        for (int attempt = 0; attempt < 5 && !better; ++attempt) {
            Eigen::MatrixXd damped = normal;
            damped.diagonal() += damping * normal.diagonal();
            damped.diagonal().array() += 1e-12 * std::max(1e-12, normal.diagonal().maxCoeff());
            Eigen::VectorXd step = damped.ldlt().solve(-gradient);
            for (Eigen::Index i = 0; i < n; ++i) {
                const bool logarithmic = candidate.parameter(static_cast<std::size_t>(i)).logarithmic;
                const double longest = logarithmic ? 1.5 : std::max(1.0, std::abs(fit.x[i]));
                step[i] = std::isfinite(step[i]) ? std::clamp(step[i], -longest, longest) : 0;
            }
            const Eigen::VectorXd next = bounded(candidate, fit.x + step);
            const auto trial = evaluated(next, there);
            if (trial.objective < fit.evaluation.objective) {
                better = true;
                last = fit.x;
                fit.x = next;
                fit.evaluation = trial;
                here.swap(there);
                damping = std::max(1e-7, damping * 0.2);
            } else {
                damping = std::max(1e-3, damping) * 8;
            }
        }
        if (fit.evaluation.objective <= best.evaluation.objective)
            best.x = fit.x, best.evaluation = fit.evaluation, best.information = fit.information;
        const bool done = !better || before - fit.evaluation.objective < 2e-4 * before;
        if (done && age == 0) break;
        if (!better) damping = 1e-3;  // worn slopes failed, not the step
        age = done || age + 1 == worn_after ? 0 : candidate.prior_weight > 0 ? age + 1 : 0;
    }
    best.evaluations = fit.evaluations;
    return best;
}

LevelFit search_rough(const std::vector<Case>& cases, const Candidate& candidate, const Scales& scales,
                      Eigen::VectorXd x, double omega, int evaluations, double first_step)
{
    return search_block(cases, candidate, scales, std::move(x), omega, evaluations, first_step, {});
}

LevelFit search_block(const std::vector<Case>& cases, const Candidate& candidate, const Scales& scales,
                      Eigen::VectorXd x, double omega, int evaluations, double first_step, const Kept& kept)
{
    LevelFit fit;
    const auto n = static_cast<Eigen::Index>(candidate.parameter_count());
    fit.x = bounded(candidate, std::move(x));
    std::vector<Eigen::Index> free;
    for (Eigen::Index i = 0; i < n; ++i)
        if (kept.empty() || !kept[static_cast<std::size_t>(i)]) free.push_back(i);
    int count = 0;
    Eigen::VectorXd at = fit.x;
    const auto objective = [&](const std::vector<double>& values) {
        ++count;
        for (std::size_t k = 0; k < free.size(); ++k) at[free[k]] = values[k];
        return evaluate(cases, candidate, in_si(candidate, at, scales), omega).objective + prior_cost(candidate, at);
    };
    Minimisation rough{SearchMethod::simplex, {}, {}, evaluations};
    rough.ftol_rel = 1e-4;
    std::vector<double> start;
    for (const auto i : free) {
        const auto& p = candidate.parameter(static_cast<std::size_t>(i));
        rough.bounds.low.push_back(p.logarithmic ? std::log(p.low) : p.low);
        rough.bounds.high.push_back(p.logarithmic ? std::log(p.high) : p.high);
        rough.first_step.push_back(first_step * (p.logarithmic ? 1 : std::max(0.1, std::abs(p.prior))));
        start.push_back(fit.x[i]);
    }
    start = minimum(rough, objective, std::move(start));
    for (std::size_t k = 0; k < free.size(); ++k) fit.x[free[k]] = start[k];
    fit.evaluation = evaluate(cases, candidate, in_si(candidate, fit.x, scales), omega);
    fit.evaluation.objective += prior_cost(candidate, fit.x);
    fit.information = Eigen::MatrixXd::Zero(n, n);
    fit.evaluations = count + 1;
    return fit;
}

}  // namespace stickslip::gap
