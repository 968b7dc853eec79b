#include "analysis/design/judge.h"

#include "analysis/boundary/trace/locate.h"
#include "analysis/numerics/root.h"
#include "analysis/stability/effort_limits.h"
#include "analysis/stability/real_response.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/warming.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr int velocity_steps = 12;           ///< a decade, when the least velocity is looked for
constexpr double beyond_requirement = 1.25;  ///< how far a margin is looked for, per specified one
constexpr double near = 0.7;          ///< where verdicts are counts: margins are looked for up to a factor of two
constexpr double rough = 1e-4;        ///< of the distances that a search over directions compares
constexpr double overlooking = 0.99;  ///< a margin that turns out less than that, per the one thought of, was wrong

}  // namespace

Judge::Judge(const Joint& joint, const Requirements& requirements, Curve::Kind theory)
    : joint_(joint), requirements_(requirements), theory_(theory)
{
    coordinates_ = requirements.uncertain.empty() ? friction_coordinates(joint) : requirements.uncertain;
    reach_ = reach_for(requirements.margin);
    range_ = gain_range(joint, requirements);
    damping_unit_ = 1e-4 * range_.k_v.high;
    const auto steady = steady_sliding(joint);
    velocity_ = steady.velocity;
    steady_effort_ = std::abs(steady.friction) + std::abs(joint.load.constant) +
                     std::abs(joint.load.gravity_amplitude) + warming(joint);
    if (loop_kind(joint) != LoopKind::ideal)
        effort_gain_ =
            std::abs(actuation(joint, steady.slides_at, stickslip::steady_effort(joint, steady.slides_at)).gain);
    const bool counts = theory != Curve::Kind::velocity_only && !linear_joint(joint, steady.slides_at).rational();
    cost_ = counts                                ? VerdictCost::counts
            : loop_kind(joint) != LoopKind::ideal ? VerdictCost::eigenvalues
                                                  : VerdictCost::small;
    reach_ = reach_for(requirements.margin);
    if (cost_ != VerdictCost::small) learn_directions();
}

void Judge::learn_directions()
{
    const auto low = bounds().low, high = bounds().high;
    std::vector<std::vector<double>> places{place_of(joint_.control.k_p, joint_.control.k_v)};
    const std::vector<double> shares = cost_ == VerdictCost::counts ? std::vector{0.5} : std::vector{0.25, 0.75};
    for (const double a : shares)
        for (const double b : shares)
            places.push_back({low[0] + a * (high[0] - low[0]), low[1] + b * (high[1] - low[1])});
    for (const auto& place : places) {
        const auto [k_p, k_v] = gains_at(place);
        const auto near = nearest(k_p, k_v, affordable());
        if (near.found) overlooked_.push_back(near.direction);
    }
}

/// Of boundaries to all sides of one pair of gains.
NearestOptions Judge::affordable() const
{
    auto options = affordable_search(joint_);
    if (cost_ == VerdictCost::small) return options;
    options.global = false;
    options.precision = rough;
    return options;
}

double Judge::reach_for(double margin) const
{
    return std::max(cost_ == VerdictCost::counts ? near : default_reach(coordinates_), beyond_requirement * margin);
}

Judge Judge::with_margin(double margin) const
{
    Judge other = *this;
    other.requirements_.margin = margin;
    other.evaluations_ = 0;
    const double reach = reach_for(margin);
    if (reach != reach_) other.reach_ = reach, other.judged_.clear();  // margins are cut off there
    return other;
}

Bounds Judge::bounds() const
{
    return {place_of(range_.k_p.low, range_.k_v.low), place_of(range_.k_p.high, range_.k_v.high)};
}

std::pair<double, double> Judge::gains_at(const std::vector<double>& t) const
{
    return {std::exp(t[0]), damping_unit_ * std::sinh(t[1])};
}

std::vector<double> Judge::place_of(double k_p, double k_v) const
{
    return {std::log(k_p), std::asinh(k_v / damping_unit_)};
}

const GainChoice& Judge::at(const std::vector<double>& t)
{
    const auto known = judged_.find(t);
    if (known != judged_.end()) return up_to_date(known->second);
    const auto [k_p, k_v] = gains_at(t);
    NearestOptions options;
    options.global = false, options.rays = 12, options.local = 0;
    options.starts = overlooked_;
    if (cost_ == VerdictCost::small) {
        if (!direction_.empty()) options.starts.push_back(direction_);
    } else {
        options.along_starts_only = !overlooked_.empty();
        options.precision = rough;
    }
    const auto found = nearest(k_p, k_v, options);
    if (found.found) direction_ = found.direction;
    return (judged_[t] = {judged(k_p, k_v, signed_margin(found), false), overlooked_.size()}).choice;
}

bool Judge::learns_at(const std::vector<double>& t)
{
    const double thought = at(t).margin;
    const auto [k_p, k_v] = gains_at(t);
    const auto sure = nearest(k_p, k_v, affordable());
    if (!sure.found || std::abs(signed_margin(sure)) >= overlooking * std::abs(thought)) return false;
    overlooked_.push_back(sure.direction);
    return true;
}

const GainChoice& Judge::up_to_date(Judged& known)
{
    auto& choice = known.choice;
    NearestOptions along;
    along.rays = 12, along.along_starts_only = true;
    for (; known.looked_along < overlooked_.size(); ++known.looked_along) {
        along.starts = {overlooked_[known.looked_along]};
        const double margin = signed_margin(nearest(choice.k_p, choice.k_v, along));
        if (std::abs(margin) < std::abs(choice.margin)) choice.margin = margin;  // its side, and all else, stays
    }
    return choice;
}

std::vector<double> Judge::best_known(const std::function<double(const GainChoice&)>& value)
{
    for (;;) {
        auto best = judged_.end();
        double least = infinity;
        for (auto it = judged_.begin(); it != judged_.end(); ++it)
            if (const double v = value(it->second.choice); v < least) least = v, best = it;
        if (best == judged_.end()) return {};
        // what more directions are looked along only falls: who is best without them and stays it, is
        const bool was_up_to_date = best->second.looked_along == overlooked_.size();
        up_to_date(best->second);
        if (was_up_to_date) return best->first;
    }
}

GainChoice Judge::thorough(double k_p, double k_v)
{
    const auto options = cost_ == VerdictCost::small ? NearestOptions{} : affordable();
    return judged(k_p, k_v, signed_margin(nearest(k_p, k_v, options)), true);
}

double Judge::least_velocity(Joint joint) const
{
    joint.control.force_rate = not_set;
    const double lowest = lowest_velocity_searched(requirements_, velocity_);
    const auto measure = [&](double V) {
        joint.control.V0 = V;
        return instability(joint, theory_);
    };
    double a = velocity_, fa = measure(a);
    if (!(fa < 0)) return a;
    const int steps = std::max(4, static_cast<int>(std::ceil(velocity_steps * std::log10(velocity_ / lowest))));
    for (int i = 1; i <= steps; ++i) {
        const double b = velocity_ * std::pow(lowest / velocity_, static_cast<double>(i) / steps), fb = measure(b);
        if (std::isnan(fb)) return a;
        if (fb >= 0) return bracketed_root(measure, a, fa, b, fb, 1e-9).value;
        a = b, fa = fb;
    }
    return lowest;
}

NearestBoundary Judge::nearest(double k_p, double k_v, NearestOptions options) const
{
    Joint joint = joint_;
    joint.control.k_p = k_p, joint.control.k_v = k_v;
    options.theory = theory_;
    options.reach = reach_;
    ++evaluations_;
    return nearest_boundary(joint, coordinates_, options);
}

GainChoice Judge::judged(double k_p, double k_v, double margin, bool thoroughly) const
{
    GainChoice choice;
    choice.k_p = k_p, choice.k_v = k_v, choice.margin = margin;
    Joint joint = joint_;
    joint.control.k_p = k_p, joint.control.k_v = k_v;
    const bool asked = thoroughly || requirements_.objective == DesignObjective::motion;
    const bool memory = theory_ != Curve::Kind::velocity_only;
    if (loop_kind(joint) == LoopKind::ideal) {
        auto linear = linear_joint(joint, sliding_velocity(joint));
        if (!memory) linear = velocity_only(linear);
        choice.effort_noise = effort_noise(linear, requirements_.noise);
        if (asked && choice.margin > 0) choice.motion_noise = motion_noise(linear, requirements_.noise);
    } else if (choice.margin > 0) {
        const auto theory = memory ? Theory::state_variable : Theory::velocity_only;
        const auto response = LoopResponse::of(joint, theory, LoopResponse::Input::command);
        if (response) {
            const bool limited = std::isfinite(requirements_.effort_limit);
            const auto of = thoroughly || (asked && limited) ? NoiseOf::both
                            : asked                          ? NoiseOf::motion
                                                             : NoiseOf::effort;
            const auto noise = loop_noise(joint, *response, requirements_.noise, of);
            choice.motion_noise = noise.motion;
            choice.effort_noise = noise.effort * effort_gain_;
        }
    }
    choice.peak_effort = steady_effort_ + requirements_.noise_multiple * choice.effort_noise;
    choice.steady_deflection = steady_sliding(joint).deflection;
    if (thoroughly || is_set(requirements_.least_velocity)) choice.least_velocity = least_velocity(joint);
    const double noise = requirements_.objective == DesignObjective::motion ? choice.motion_noise : choice.effort_noise;
    choice.cost = noise * (1 + k_p / requirements_.stiffness_scale);
    return choice;
}

Violations Judge::violations(const GainChoice& c) const
{
    Violations v;
    v[0] = std::isnan(c.margin) ? 2 * reach_ : requirements_.margin - c.margin;
    v[1] = std::isfinite(requirements_.effort_limit) ? std::log(c.peak_effort / requirements_.effort_limit) : -infinity;
    v[2] = is_set(requirements_.least_velocity) ? std::log(c.least_velocity / requirements_.least_velocity) : -infinity;
    // stable throughout: the search for the least velocity ends below the requirement
    if (c.margin < 0 && is_set(requirements_.least_velocity))
        v[2] = std::log(velocity_ / requirements_.least_velocity) - c.margin;
    return v;
}

}  // namespace stickslip
