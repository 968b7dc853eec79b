// Levenberg-Marquardt over a block of parameters, as named steps.
// In one file: the steps of one descent, and what it knows between them.
#include "analysis/diagnosis/fit/candidate_numbers.h"
#include "analysis/diagnosis/fit/problem.h"
#include "analysis/diagnosis/fit/side_by_side.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace stickslip::gap {
namespace {

// of what is usual, or of a logarithm; over a wide step the teeth of a jagged misfit hardly count
constexpr double slope_step = 1e-4, wide_slope_step = 0.01;  // numerical: of a difference
constexpr double least_usual = 0.1;                          // numerical: in units of the parameter's scale
constexpr int most_halvings = 10;
/// Parameters with a prior hardly move: their slopes are found anew every few steps, and where a step fails.
constexpr int worn_after = 3;
/// The damping, as a part of the diagonal: where it starts and starts again, its least value, and what a step that
/// fails and one that succeeds make of it; numerical: of Levenberg and Marquardt.
constexpr double usual_damping = 1e-3, least_damping = 1e-7, harder = 8, easier = 0.2;
constexpr double ridge = 1e-12;  // numerical: of the largest diagonal entry: what no record shows stays where it is
constexpr double longest_in_logarithm = 1.5;  // numerical: of a step
/// The first trial mostly succeeds; where it fails the more damped ones go side by side.
constexpr int first_trials = 1, other_trials = 4;
constexpr double least_fall = 2e-4;  // numerical: of the objective in one step: less is its end

class Descent {
  public:
    Descent(const FitProblem& problem, Eigen::VectorXd x, Kept kept)
        : problem_(problem), candidate_(problem.candidate), kept_(std::move(kept))
    {
        at_.x = bounded(candidate_, std::move(x));
        at_.information = Eigen::MatrixXd::Zero(size(), size());
    }

    /// Has to come first; gives the objective at the start.
    Fitting<double> begin()
    {
        co_await looked_here(0);
        jacobian_ = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(residuals_.size()), size());
        came_from_ = at_.x;
        for (Eigen::Index i = 0; i < size(); ++i)
            if (parameter(i).vanishes) came_from_[i] = 0;
        best_ = at_;
        co_return at_.evaluation.objective;
    }

    Fitting<LevelFit> run(int iterations)
    {
        for (int iteration = 0; iteration < iterations && size() > 0; ++iteration) {
            co_await found_slopes();
            set_up_equations();
            const double before = at_.evaluation.objective;
            bool better = co_await tried(first_trials);
            if (!better) better = co_await tried(other_trials);
            keep_best();
            const bool done = !better || before - at_.evaluation.objective < least_fall * before;
            if (done && age_ == 0) break;
            if (!better) damping_ = usual_damping;  // worn slopes failed, not the step
            const bool renew = done || age_ + 1 == worn_after || !(candidate_.prior_weight > 0);
            age_ = renew ? 0 : age_ + 1;
        }
        best_.evaluations = at_.evaluations;
        co_return best_;
    }

  private:
    Eigen::Index size() const { return static_cast<Eigen::Index>(candidate_.parameter_count()); }
    const EffectParameter& parameter(Eigen::Index i) const { return candidate_.parameter(static_cast<std::size_t>(i)); }
    bool is_kept(Eigen::Index i) const { return !kept_.empty() && kept_[static_cast<std::size_t>(i)]; }
    Eigen::Map<const Eigen::VectorXd> residuals() const
    {
        return {residuals_.data(), static_cast<Eigen::Index>(residuals_.size())};
    }

    Evaluation evaluated(const std::vector<double>& residuals, const Eigen::VectorXd& x)
    {
        auto found = judged(problem_.cases, residuals);
        found.objective += prior_cost(candidate_, x);
        ++at_.evaluations;
        return found;
    }

    /// By how much a parameter is moved to find its slope at x.
    double step_of(const Eigen::VectorXd& x, Eigen::Index i) const
    {
        double step = candidate_.is_rough(static_cast<std::size_t>(i)) ? wide_slope_step : slope_step;
        if (!parameter(i).logarithmic) step *= std::max(least_usual, std::abs(parameter(i).prior));
        Eigen::VectorXd shifted = x;
        shifted[i] += step;
        return bounded(candidate_, shifted)[i] != shifted[i] ? -step : step;
    }
    Place moved(const Eigen::VectorXd& x, Eigen::Index i) const
    {
        Eigen::VectorXd shifted = x;
        // the same two roundings whichever way it goes
        const double step = step_of(x, i);
        shifted[i] += std::abs(step);
        if (step < 0) shifted[i] += 2 * step;
        return {problem_.si(shifted), problem_.omega, static_cast<std::size_t>(i)};
    }
    /// The parameters whose slopes are found at this age of the equations.
    std::vector<Eigen::Index> due(int age) const
    {
        std::vector<Eigen::Index> all;
        for (Eigen::Index i = 0; i < size(); ++i) {
            if (is_kept(i)) continue;
            if (age == 0 || !(candidate_.sd_of(static_cast<std::size_t>(i)) > 0)) all.push_back(i);
        }
        return all;
    }
    /// Looks at some places and, along with the first, at what its slopes of this age need; nothing: no slopes.
    Asked question(const std::vector<Eigen::VectorXd>& at, std::optional<int> age) const
    {
        Asked asked{{&problem_.cases, &candidate_, {}, at.size(), true}};
        for (const auto& x : at) asked.places.push_back({problem_.si(x), problem_.omega});
        if (!age) return asked;
        // what is one record's own needs the residuals of the others first
        for (const auto i : due(*age))
            if (problem_.cases.size() == 1 || !record_of(candidate_, static_cast<std::size_t>(i)))
                asked.places.push_back(moved(at[0], i));
        return asked;
    }
    /// Takes over what is known at a place, and with a parameter moved.
    void know(Asked& asked, std::size_t place)
    {
        residuals_.swap(asked.answers[place]);
        ahead_.assign(static_cast<std::size_t>(size()), {});
        for (std::size_t k = asked.needed; k < asked.places.size(); ++k)
            if (place == 0) ahead_[asked.places[k].moved].swap(asked.answers[k]);
    }
    Fitting<bool> looked_here(int age)
    {
        Asked here = question({at_.x}, age);
        co_await here;
        know(here, 0);
        at_.evaluation = evaluated(residuals_, at_.x);
        co_return true;
    }

    Fitting<bool> found_slopes()
    {
        for (; halvings_ <= most_halvings; ++halvings_) {
            const Eigen::Index lost = co_await slopes_here();
            if (lost == size() || halvings_ == most_halvings) break;
            // friction that has been taken away altogether has no slope that leads back: half way, and all slopes anew
            at_.x[lost] = 0.5 * (at_.x[lost] + came_from_[lost]);
            co_await looked_here(age_);
        }
        co_return true;
    }

    /// Finds the slopes that are due by differences; gives the first parameter that has lost all of its effect on the
    /// way here, or their number.
    Fitting<Eigen::Index> slopes_here()
    {
        const auto wanted = due(age_);
        Asked asked{{&problem_.cases, &candidate_, {}, 0, true, &residuals_}};
        for (const auto i : wanted)
            if (ahead_[static_cast<std::size_t>(i)].empty()) asked.places.push_back(moved(at_.x, i));
        asked.needed = asked.places.size();
        co_await asked;
        for (std::size_t k = 0; k < asked.places.size(); ++k) ahead_[asked.places[k].moved].swap(asked.answers[k]);
        const auto r = residuals();
        Eigen::Index lost = size();
        for (const auto i : wanted) {
            const auto& there = ahead_[static_cast<std::size_t>(i)];
            jacobian_.col(i) = (Eigen::Map<const Eigen::VectorXd>(there.data(), r.size()) - r) / step_of(at_.x, i);
            if (lost == size() && parameter(i).vanishes && came_from_[i] != at_.x[i] && jacobian_.col(i).isZero(0))
                lost = i;
        }
        at_.evaluations += static_cast<int>(wanted.size());
        co_return lost;
    }

    void set_up_equations()
    {
        const auto r = residuals();
        block_weights(problem_.cases, residuals_, weights_);
        const Eigen::Map<const Eigen::VectorXd> w(weights_.data(), r.size());
        const Eigen::MatrixXd weighted = w.asDiagonal() * jacobian_;
        normal_ = jacobian_.transpose() * weighted;
        at_.information = normal_;
        gradient_ = weighted.transpose() * r;
        for (Eigen::Index i = 0; i < size() && candidate_.prior_weight > 0; ++i)
            if (const double sd = candidate_.sd_of(static_cast<std::size_t>(i)); sd > 0 && !is_kept(i)) {
                const double row = candidate_.prior_weight * static_cast<double>(problem_.cases.size()) / (sd * sd);
                normal_(i, i) += row;
                gradient_[i] += row * (at_.x[i] - prior_mean(candidate_, static_cast<std::size_t>(i)));
            }
    }

    Eigen::VectorXd damped_step(double by) const
    {
        Eigen::MatrixXd damped = normal_;
        damped.diagonal() += by * normal_.diagonal();
        damped.diagonal().array() += ridge * std::max(ridge, normal_.diagonal().maxCoeff());
        Eigen::VectorXd step = damped.ldlt().solve(-gradient_);
        for (Eigen::Index i = 0; i < size(); ++i) {
            const double longest = parameter(i).logarithmic ? longest_in_logarithm : std::max(1.0, std::abs(at_.x[i]));
            step[i] = std::isfinite(step[i]) ? std::clamp(step[i], -longest, longest) : 0;
        }
        return bounded(candidate_, at_.x + step);
    }

    /// The age that the equations come to if a step succeeds and is not the last.
    int next_age() const { return age_ + 1 == worn_after || !(candidate_.prior_weight > 0) ? 0 : age_ + 1; }
    /// Whether the equations say that a step to here is the last.
    bool seems_last(const Eigen::VectorXd& next) const
    {
        const Eigen::VectorXd step = next - at_.x;
        const double fall = -step.dot(2 * gradient_ + normal_ * step) / static_cast<double>(problem_.cases.size());
        return fall < least_fall * at_.evaluation.objective;
    }

    /// Takes the first of `count` steps, each damped more, that lowers the objective.
    Fitting<bool> tried(int count)
    {
        std::vector<Eigen::VectorXd> next;
        for (double by = damping_; static_cast<int>(next.size()) < count; by = std::max(usual_damping, by) * harder)
            next.push_back(damped_step(by));
        // slopes found along with a step are those of the next, unless it fails or is the last
        const bool along = count == 1 && !seems_last(next[0]);
        Asked there = question(next, along ? std::optional(next_age()) : std::nullopt);
        co_await there;
        for (std::size_t k = 0; k < next.size(); ++k) {
            auto trial = evaluated(there.answers[k], next[k]);
            if (!(trial.objective < at_.evaluation.objective)) {
                damping_ = std::max(usual_damping, damping_) * harder;
                continue;
            }
            came_from_ = at_.x;
            at_.x = next[k];
            at_.evaluation = std::move(trial);
            know(there, k);
            damping_ = std::max(least_damping, damping_ * easier);
            co_return true;
        }
        co_return false;
    }

    void keep_best()
    {
        if (at_.evaluation.objective <= best_.evaluation.objective) best_ = at_;
    }

    const FitProblem problem_;
    const Candidate& candidate_;
    const Kept kept_;
    LevelFit at_, best_;
    std::vector<double> residuals_, weights_;
    std::vector<std::vector<double>> ahead_;  ///< of each parameter, what is left here with it moved; empty: not known
    Eigen::VectorXd came_from_;               ///< where the last step came from; at first, where the effect is absent
    Eigen::MatrixXd jacobian_, normal_;
    Eigen::VectorXd gradient_;
    double damping_ = usual_damping;
    int halvings_ = 0;
    int age_ = 0;  ///< steps since all slopes were found
};

/// On the other side of the nearest whole unit; nothing where the number is far from one.
std::optional<double> across_a_jump(double x)
{
    // behind a jump by more than a clock's rounding; further off, slopes have led away from it
    constexpr double just_behind = 0.02, near = 0.25;  // numerical: rows
    const double whole = std::round(x);
    if (x == whole || std::abs(x - whole) > near) return {};
    return x > whole ? whole : whole + just_behind;
}

}  // namespace

Fitting<LevelFit> descending(FitProblem problem, Eigen::VectorXd x, int iterations, Kept kept)
{
    Descent first(problem, std::move(x), kept);
    co_await first.begin();
    LevelFit fit = co_await first.run(iterations);
    for (std::size_t i = 0; i < problem.candidate.parameter_count() && iterations > 1; ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        if (!problem.candidate.parameter(i).jumps || (!kept.empty() && kept[i])) continue;
        const auto other = across_a_jump(fit.x[at]);
        if (!other) continue;
        // slopes do not lead across: from there the others go on beside it
        Kept beside = kept.empty() ? Kept(problem.candidate.parameter_count(), 0) : kept;
        beside[i] = 1;
        Eigen::VectorXd there = fit.x;
        there[at] = *other;
        Descent descent(problem, there, beside);
        const double objective = co_await descent.begin();
        ++fit.evaluations;
        if (!(objective < fit.evaluation.objective)) continue;
        const int before = fit.evaluations;
        fit = co_await descent.run(iterations);
        fit.evaluations += before;
    }
    co_return fit;
}

LevelFit descend(const FitProblem& problem, Eigen::VectorXd x, int iterations, const Kept& kept)
{
    return alone(descending(problem, std::move(x), iterations, kept));
}

}  // namespace stickslip::gap
