// In one file: one search for gains, its front and the report of what each requirement costs.
#include "analysis/design/design.h"

#include "analysis/design/check_requirements.h"
#include "analysis/design/judge.h"
#include "analysis/numerics/optimise.h"
#include "analysis/stability/frequency_search.h"
#include "analysis/stability/real_loop.h"
#include "analysis/stability/steady.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

using Place = std::vector<double>;

constexpr int rim_points = 24;
constexpr double tolerance = 1e-6;        ///< of a requirement, in its logarithm
constexpr double offence = 1e3;           ///< what any violation costs the global search, far above ln(cost)
constexpr double most_of_margin = 0.995;  ///< of the largest margin, where the front ends

double worst_of(const Violations& v, int without = -1)
{
    double worst = -infinity;
    for (int i = 0; i < requirement_count; ++i)
        if (i != without) worst = std::max(worst, v[static_cast<std::size_t>(i)]);
    return worst;
}

/// How many gains a search may try, and how often it goes on with what the last round overlooked.
struct Pace {
    int global = 250, local = 100, rounds = 6;
};

/// As search_effort() multiplies them.
Pace pace_of(VerdictCost cost)
{
    const Pace usual = cost == VerdictCost::small         ? Pace{}
                       : cost == VerdictCost::eigenvalues ? Pace{120, 50, 8}
                                                          : Pace{50, 20, 2};
    const auto scaled = [](int evaluations, int least) {
        return std::max(least, static_cast<int>(std::min(1e6, evaluations * search_effort())));
    };
    return {scaled(usual.global, 20), scaled(usual.local, 10), scaled(usual.rounds, 1)};
}

/// Minimises `goal` of a choice while the requirements hold (all but `without`).
class Search {
  public:
    using Goal = std::function<double(const GainChoice&)>;

    Search(Judge& judge, Goal goal, int without = -1)
        : judge_(judge), goal_(std::move(goal)), without_(without), pace_(pace_of(judge.cost()))
    {
    }

    /// From the whole range, or from given places and those judged before; nothing is promised but that the best place
    /// seen is returned, and that nothing nearer than its margin was overlooked where that took few rounds.
    Place run(const std::vector<Place>& starts, bool global)
    {
        Place best = once(starts, global);
        for (int round = 0; round < pace_.rounds && judge_.learns_at(best); ++round) best = once({best}, false);
        return best;
    }

  private:
    Place once(std::vector<Place> starts, bool global)
    {
        const Bounds bounds = judge_.bounds();
        const auto penalty = [&](const GainChoice& c) {
            const double worst = worst_of(judge_.violations(c), without_);
            if (worst > 0 || std::isnan(worst)) return offence * (1 + (std::isnan(worst) ? 100 : worst));
            const double goal = goal_(c);
            return std::isfinite(goal) ? goal : offence;
        };
        const Objective penalised = [&](const Place& t) { return penalty(judge_.at(t)); };
        if (global) starts.push_back(global_minimum(penalised, bounds, pace_.global));
        // feedback of one kind alone lies on the rim of the range, where no search inside ever looks
        for (int i = 0; i <= rim_points; ++i)
            for (const std::size_t held : {0, 1}) {
                Place t = bounds.low;
                t[1 - held] += (bounds.high[1 - held] - bounds.low[1 - held]) * i / rim_points;
                starts.push_back(t);
            }
        if (const auto known = judge_.best_known(penalty); !known.empty()) starts.push_back(known);
        Place best = starts.front();
        for (const auto& s : starts)
            if (penalised(s) < penalised(best)) best = s;
        if (penalised(best) >= offence) best = local_minimum(penalised, bounds, best, 0.1, pace_.local);
        const Objective goal = [&](const Place& t) {
            const double g = goal_(judge_.at(t));
            return std::isfinite(g) ? g : offence;
        };
        std::vector<Objective> constraints;
        for (int i = 0; i < requirement_count; ++i)
            if (i != without_)
                constraints.push_back([this, i](const Place& t) {
                    const double v = judge_.violations(judge_.at(t))[static_cast<std::size_t>(i)];
                    return std::isnan(v) ? 10 : std::max(v, -10.0);
                });
        for (const double step : {0.05, 0.01}) {
            const auto next = constrained_minimum(goal, constraints, bounds, best, step, pace_.local);
            if (penalised(next) <= penalised(best)) best = next;
        }
        // where the cost has a kink, as at a rim, the linear models of COBYLA stall
        const auto next = local_minimum(penalised, bounds, best, 0.02, pace_.local);
        return penalised(next) < penalised(best) ? next : best;
    }

    Judge& judge_;
    Goal goal_;
    int without_;
    Pace pace_;
};

double log_cost(const GainChoice& c)
{
    return std::log(c.cost);
}

/// Choices of the search are judged once more with every direction in view.
GainChoice judged_at(Judge& judge, const Place& place)
{
    const auto quick = judge.at(place);
    return judge.thorough(quick.k_p, quick.k_v);
}

double specified(const Requirements& r, int i)
{
    return i == 0 ? r.margin : i == 1 ? r.effort_limit : r.least_velocity;
}

double achieved(const GainChoice& c, int i)
{
    return i == 0 ? c.margin : i == 1 ? c.peak_effort : c.least_velocity;
}

bool is_specified(const Requirements& r, int i)
{
    return i == 0 || (i == 1 ? std::isfinite(r.effort_limit) : is_set(r.least_velocity));
}

/// How a requirement fares, and where it fares best.
struct Fared {
    RequirementReport report;
    GainChoice at;
};

Fared fared(Judge& judge, const GainChoice& best, const Place& place, int i)
{
    const auto& r = judge.requirements();
    const auto index = static_cast<std::size_t>(i);
    RequirementReport report;
    report.name = requirement_names[index];
    report.specified = specified(r, i);
    report.achieved = achieved(best, i);
    report.met = judge.violations(best)[index] <= tolerance;
    const auto offends = [&judge, index](const GainChoice& c) { return judge.violations(c)[index]; };
    auto at = Search(judge, offends, i).run({place}, true);
    report.others_met = worst_of(judge.violations(judge.at(at)), i) <= tolerance;
    if (!report.others_met) {
        at = local_minimum([&](const Place& t) { return offends(judge.at(t)); }, judge.bounds(), place, 0.2,
                           pace_of(judge.cost()).local);
    }
    const auto choice = judged_at(judge, at);
    report.attainable = achieved(choice, i);
    return {report, choice};
}

/// Where nothing is feasible: of the gains that give up one requirement only, those that give up least of it.
GainChoice nearest_feasible(Judge& judge, const std::vector<Fared>& requirements, const GainChoice& otherwise)
{
    const Fared* least = nullptr;
    const auto lacking = [&](const Fared& f) { return worst_of(judge.violations(f.at)); };
    for (const auto& f : requirements)
        if (f.report.others_met && !f.report.met && std::isfinite(f.at.cost))
            if (!least || lacking(f) < lacking(*least)) least = &f;
    return least ? least->at : otherwise;
}

bool meets_all(const Judge& judge, const GainChoice& c)
{
    return worst_of(judge.violations(c)) <= tolerance && std::isfinite(std::log(c.cost));
}

/// Where every direction shows a smaller margin than the search saw: gains of a search for as much more.
Place with_more_margin(Judge& judge, Place best)
{
    constexpr int rounds = 4;
    constexpr double more = 1.2;  // than what was lacking, as the next gains lack something, too
    double asked = judge.requirements().margin;
    for (int round = 0; round < rounds; ++round) {
        const auto choice = judged_at(judge, best);
        const double lacking = judge.requirements().margin - choice.margin;
        if (meets_all(judge, choice) || !(lacking > 0)) break;
        asked += more * lacking;
        Judge stricter = judge.with_margin(asked);
        best = Search(stricter, log_cost).run({best}, false);
    }
    return best;
}

/// The cheapest that meets all requirements, of gains that were judged with every direction in view.
void take_cheapest(const Judge& judge, const std::vector<GainChoice>& known, GainDesign& design)
{
    for (const auto& choice : known)
        if (meets_all(judge, choice) && (!design.feasible || choice.cost < design.best.cost))
            design.best = choice, design.feasible = true;
}

/// Ascending in margin: choices that another one beats in both margin and cost are searched again from its gains, and
/// left out if they stay beaten.
void keep_undominated(std::vector<GainChoice>& front, const std::function<GainChoice(GainChoice, GainChoice)>& again)
{
    std::sort(front.begin(), front.end(), [](const auto& a, const auto& b) { return a.margin < b.margin; });
    for (std::size_t i = front.size(); i-- > 1;) {
        auto &quiet = front[i - 1], &far = front[i];
        if (quiet.cost < far.cost) continue;
        const auto better = again(quiet, far);
        if (better.cost < far.cost && better.margin < far.margin)
            quiet = better;
        else
            front.erase(front.begin() + static_cast<std::ptrdiff_t>(i) - 1);
    }
}

}  // namespace

GainRange gain_range(const Joint& joint, const Requirements& r)
{
    constexpr double decades = 1e3, damping_reach = 30;
    const auto steady = steady_sliding(joint);
    double damping = std::abs(joint.control.k_v), inertia = 0;
    if (steady.reason == Reason::none) {
        const auto linear = linear_joint(joint, steady.slides_at);
        for (int i = 0; i < linear.bodies; ++i) {
            damping += std::abs(linear.friction[i].f_v) + std::abs(kernel_integral(linear.friction[i]));
            inertia += linear.inertia[i];
        }
    }
    GainRange range;
    range.k_p = {is_set(r.k_p_low) ? r.k_p_low : joint.control.k_p / decades,
                 is_set(r.k_p_high) ? r.k_p_high : joint.control.k_p * decades};
    damping += std::sqrt(std::abs(joint.control.k_p) * inertia);
    range.k_v = {r.k_v_low, is_set(r.k_v_high) ? r.k_v_high : damping_reach * damping};
    return range;
}

namespace {

/// Feasible gains from the margin that the least cost has by itself up to the largest, each margin specified in turn.
void add_front(Judge& judge, const Requirements& r, const Place& best, const Place& own, double largest,
               const ParallelFor& parallel, GainDesign& design)
{
    const double free = judged_at(judge, Search(judge, log_cost, 0).run({best}, true)).margin;
    const double least = std::clamp(std::isnan(free) ? 0 : free, 1e-3 * largest, largest);
    std::vector<GainChoice> front(static_cast<std::size_t>(r.front_points));
    std::vector<int> counts(front.size());
    if (largest > 0)
        parallel(front.size(), [&](std::size_t i) {
            const double margin =
                least + (largest - least) * static_cast<double>(i) / (static_cast<double>(front.size()) - 1);
            Judge own_judge = judge.with_margin(margin);
            const auto at = Search(own_judge, log_cost).run({best, own}, false);
            const auto choice = judged_at(own_judge, at);
            if (worst_of(own_judge.violations(choice)) <= 1e-3) front[i] = choice;
            counts[i] = own_judge.evaluations();
        });
    for (std::size_t i = 0; i < front.size(); ++i) {
        if (is_set(front[i].cost)) design.front.push_back(front[i]);
        design.evaluations += counts[i];
    }
    keep_undominated(design.front, [&](const GainChoice& quiet, const GainChoice& far) {
        Judge own_judge = judge.with_margin(quiet.margin);
        const auto at = Search(own_judge, log_cost).run({own_judge.place_of(far.k_p, far.k_v)}, false);
        const auto choice = judged_at(own_judge, at);
        design.evaluations += own_judge.evaluations();
        return worst_of(own_judge.violations(choice)) <= 1e-3 ? choice : quiet;
    });
}

}  // namespace

GainDesign design_gains(const Joint& joint, const Requirements& r, const ParallelFor& parallel,
                        const DesignListener& listener)
{
    check_sense(joint, r);
    const auto tell = [&](DesignStage stage) {
        if (listener) listener(stage);
    };
    tell(DesignStage::best);
    GainDesign design;
    if (possible_sliding(joint).reason != Reason::none) return design;
    design.decided = true;
    Judge judge(joint, r, Curve::Kind::state_variable);
    design.margin_reach = judge.reach();
    design.steady_effort = judge.steady_effort();
    const auto range = gain_range(joint, r);
    const auto own = judge.place_of(std::clamp(joint.control.k_p, range.k_p.low, range.k_p.high),
                                    std::clamp(joint.control.k_v, range.k_v.low, range.k_v.high));
    design.as_joint = judge.thorough(joint.control.k_p, joint.control.k_v);
    const auto best = with_more_margin(judge, Search(judge, log_cost).run({own}, true));
    design.best = judged_at(judge, best);
    design.feasible = meets_all(judge, design.best);
    std::vector<Fared> requirements;
    tell(DesignStage::requirements);
    for (int i = 0; i < requirement_count; ++i)
        if (is_specified(r, i)) requirements.push_back(fared(judge, design.best, best, i));
    const double largest = requirements[0].report.others_met ? most_of_margin * requirements[0].report.attainable : 0;
    design.evaluations = judge.evaluations();
    tell(DesignStage::front);
    add_front(judge, r, best, own, largest, parallel, design);
    std::vector<GainChoice> known = design.front;
    for (const auto& f : requirements) known.push_back(f.at);
    take_cheapest(judge, known, design);
    if (!design.feasible) design.best = nearest_feasible(judge, requirements, design.best);
    for (auto& d : requirements) {
        const auto i =
            std::find(requirement_names.begin(), requirement_names.end(), d.report.name) - requirement_names.begin();
        d.report.achieved = achieved(design.best, static_cast<int>(i));
        d.report.met = judge.violations(design.best)[static_cast<std::size_t>(i)] <= tolerance;
        design.requirements.push_back(d.report);
    }

    tell(DesignStage::velocity_only);
    Judge simple(joint, r, Curve::Kind::velocity_only);
    const auto thought = Search(simple, log_cost).run({own}, true);
    design.velocity_only_found = worst_of(simple.violations(simple.at(thought))) <= tolerance;
    design.velocity_only = judge.thorough(simple.at(thought).k_p, simple.at(thought).k_v);
    design.evaluations += simple.evaluations();
    return design;
}

}  // namespace stickslip
