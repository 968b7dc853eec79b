#include "analysis/diagnosis/plan/power.h"

#include "analysis/diagnosis/audit/audit.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/fit/fit.h"
#include "analysis/diagnosis/plant/simulator.h"
#include "analysis/diagnosis/policy/audit.h"
#include "analysis/diagnosis/policy/page_and_plan.h"
#include "analysis/diagnosis/policy/search.h"
#include "analysis/joint/gains.h"
#include "analysis/results/cannot_answer.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

constexpr std::size_t fewest_periods = 100;  // of the loop, in a motion

/// What an effect has to change in the surprises, root mean square in prediction floors, for the diagnosis to see it:
/// over many rows that is less than the noise of one.
double seen()
{
    return std::sqrt(policy::visible_excess);
}

/// The record that the joint as documented would leave, with the noise of its sensors.
Record simulated(const Joint& joint, const PlannedMotion& motion)
{
    Record r;
    r.name = "planned";
    r.time = motion.time;
    r.reference_position = motion.position;
    r.position.assign(motion.time.size(), motion.position.front());
    const Trace run = simulate_closed_loop(flatten(joint), on_clock(r, joint), 1);
    r.position = run.position;
    r.velocity = run.velocity;
    (joint.actuator.kind == ActuatorKind::dc_motor ? r.drive : r.effort_command) = run.command;
    if (joint.sensor.effort_noise > 0) r.effort_measured = run.effort;
    return r;
}

/// One form of an effect whose size is one of its parameters; the others are as is usual.
struct Sized {
    Candidate candidate;
    std::size_t parameter = 0;
    bool factor = false;  ///< the size is what a factor differs from 1 by
    bool less_is_more = false;

    const EffectParameter& of() const { return candidate.parameter(parameter); }
    /// The parameters in SI at a part u of the way from nothing to the most.
    std::vector<double> at(double u, const Scales& scales) const
    {
        std::vector<double> scaled;
        const double size = value(less_is_more ? 1 - u : u);
        for (std::size_t i = 0; i < candidate.parameter_count(); ++i)
            scaled.push_back(i == parameter ? size : beside(candidate.parameter(i), size));
        return in_si(candidate, to_fit(candidate, scaled), scales);
    }
    /// What another parameter is meanwhile: a second change is none, a second level keeps its share, all else is as
    /// usual.
    double beside(const EffectParameter& p, double size) const
    {
        if (!p.logarithmic && p.low < 0) return 0;
        if (is_set(p.meanwhile)) return p.meanwhile;
        if (p.logarithmic && p.scale == of().scale) return p.prior / of().prior * size;
        return p.prior;
    }
    double value(double u) const
    {
        const EffectParameter& p = of();
        constexpr double least = 1e-6;  // numerical: of the scan
        if (factor) return 1 + (p.high - 1) * std::pow(least, 1 - u);
        const double low = p.logarithmic ? p.low : least * p.high;
        return low * std::pow(p.high / low, u);
    }
    double size(double u, const Scales& scales) const
    {
        const double si = at(u, scales)[parameter];
        return factor ? si - 1 : si;
    }
};

/// Which parameter is the size: the first that is a change, a factor, or a quantity that may be small.
Sized sized(const Effect& effect, const EffectForm& form)
{
    Sized s{{{&effect}, {&form}, 1}};
    for (std::size_t i = 0; i < form.parameters.size(); ++i)
        if (form.parameters[i].size) s.parameter = i;
    const EffectParameter& p = s.of();
    // only of a factor on something that may be more or less: a softer transmission is less, all the way down
    s.factor = p.factor && !effect.of_transmission;
    return s;
}

class Planned {
  public:
    Planned(const Joint& joint, const PlannedMotion& planned)
    {
        std::vector<Note> notes;
        cases_.push_back(prepare(simulated(joint, planned), joint, notes));
        scales = scales_of(cases_);
        for (const double omega : levels) {
            nominal_.emplace_back();
            evaluate(cases_, {}, {}, omega, &nominal_.back());
        }
    }
    /// What the effect changes in the surprises of every observer bandwidth, in prediction floors.
    std::vector<std::vector<double>> change(const Sized& s, double u) const
    {
        std::vector<std::vector<double>> all;
        for (std::size_t level = 0; level < levels.size(); ++level) {
            std::vector<double> with;
            evaluate(cases_, s.candidate, s.at(u, scales), levels[level], &with);
            for (std::size_t i = 0; i < with.size(); ++i) with[i] -= nominal_[level][i];
            all.push_back(std::move(with));
        }
        return all;
    }
    /// Its largest root mean square over position or effort at any level.
    double strength(const Sized& s, double u) const
    {
        double most = 0;
        const std::size_t rows = cases_[0].ticks.rows();
        for (const auto& one : change(s, u))
            for (std::size_t from = 0; from < one.size(); from += rows) {
                double sum = 0;
                const std::size_t to = std::min(from + rows, one.size());
                for (std::size_t i = from; i < to; ++i) sum += one[i] * one[i];
                most = std::max(most, std::sqrt(sum / static_cast<double>(to - from)));
            }
        return most;
    }
    Scales scales;

  private:
    std::vector<Case> cases_;
    std::vector<std::vector<double>> nominal_;
};

struct Found {
    EffectPower power;
    std::vector<double> change;  ///< at the least size; empty where none shows
};

Found least_size(const Planned& motion, Sized s, Motion of)
{
    Found f;
    f.power.name = s.candidate.effects[0]->name;
    f.power.parameter = s.of().name;
    f.power.unit = unit_of(s.of().quantity, Units(of));
    const double little = motion.strength(s, 0), much = motion.strength(s, 1);
    s.less_is_more = little > much;
    if (std::max(little, much) < seen()) return f;
    double low = 0, high = 1;
    constexpr int halvings = 18;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (motion.strength(s, middle) < seen() ? low : high) = middle;
    }
    f.power.least_size = s.size(high, motion.scales);
    for (const auto& level : motion.change(s, high)) f.change.insert(f.change.end(), level.begin(), level.end());
    return f;
}

/// What the audit of the controller names, without any fit.
void audited(const Joint& joint, std::vector<EffectPower>& effects)
{
    const double tick = joint.control.period, tau = joint.control.velocity_estimate.tau;
    const bool damped = gains_of(joint.control).k_v != 0;
    for (auto& e : effects) {
        if (e.name == "gain-k_p") e.least_size = policy::flagged_gain;
        if (damped && e.name == "gain-k_v") e.least_size = policy::flagged_gain;
        // g = T/(τ + T) differs by as much
        if (damped && e.name == "velocity-filter")
            e.least_size = tau + (tau + tick) * policy::flagged_gain / (1 - policy::flagged_gain);
        if (e.name == "quantisation")
            e.least_size = std::max(1.3 * joint.sensor.encoder_quantum, 0.5 * joint.sensor.position_noise);
    }
}

double correlation(const std::vector<double>& a, const std::vector<double>& b)
{
    double ab = 0, aa = 0, bb = 0;
    for (std::size_t i = 0; i < a.size(); ++i) ab += a[i] * b[i], aa += a[i] * a[i], bb += b[i] * b[i];
    return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

}  // namespace

Power power_of(const Joint& joint, const PlannedMotion& planned, const ParallelFor& parallel)
{
    if (!is_set(joint.control.period)) throw CannotAnswer(CannotAnswer::Why::no_period, "");
    if (!is_set(gains_of(joint.control).k_p)) throw CannotAnswer(CannotAnswer::Why::no_position_gain, "");
    if (joint.sensor.position_noise == 0 && joint.sensor.encoder_quantum == 0)
        throw CannotAnswer(CannotAnswer::Why::no_noise, "");
    if (planned.time.size() < fewest_periods)
        throw CannotAnswer(CannotAnswer::Why::short_motion, "", "", {static_cast<double>(fewest_periods)});
    const Planned motion(joint, planned);
    std::vector<Sized> all;
    for (const auto& e : effects())
        for (const auto& form : e.forms) {
            const Sized s = sized(e, form);
            if (!s.candidate.applies(joint)) continue;
            all.push_back(s);
            break;
        }
    std::vector<Found> found(all.size());
    parallel(all.size(), [&](std::size_t i) { found[i] = least_size(motion, all[i], joint.mechanism.motion); });
    Power power;
    for (const auto& f : found) power.effects.push_back(f.power);
    audited(joint, power.effects);
    // two effects are compared where each stands out of the noise by as much as one that could be shown
    const double alike = std::sqrt(1 - 1 / (policy::shown * policy::shown));
    for (std::size_t i = 0; i < found.size(); ++i)
        for (std::size_t j = i + 1; j < found.size(); ++j)
            if (!found[i].change.empty() && !found[j].change.empty() &&
                std::abs(correlation(found[i].change, found[j].change)) > alike)
                power.inseparable.emplace_back(found[i].power.name, found[j].power.name);
    return power;
}

}  // namespace stickslip::gap
