// In one file: one search over ways to hold a set point, with the proofs that each way needs.
#include "analysis/design/set_point_design.h"

#include "analysis/joint/gains.h"
#include "analysis/simulation/set_point/regulator.h"
#include "analysis/simulation/set_point/set_point.h"
#include "analysis/simulation/set_point/sliding_loop.h"

#include <algorithm>
#include <stdexcept>

namespace stickslip {
namespace {

struct Levels {
    double kinetic = missing, breakaway = missing;
};

/// The law with its kinetic and its static friction multiplied; static friction does not fall below kinetic.
Friction scaled(Friction friction, double kinetic, double breakaway)
{
    if (auto* level = std::get_if<CoulombViscous>(&friction.law)) {
        level->coulomb *= kinetic;
    } else if (auto* levels = std::get_if<KineticStatic>(&friction.law)) {
        levels->kinetic *= kinetic;
        levels->breakaway = std::max(levels->kinetic, breakaway * levels->breakaway);
    } else if (auto* curve = std::get_if<Stribeck>(&friction.law)) {
        const double at_rest = breakaway * (curve->c0 + curve->c2);
        curve->c0 *= kinetic;
        curve->c2 = std::max(0.0, at_rest - curve->c0);
    } else {
        throw std::invalid_argument(
            "friction.law: a design of a set point varies kinetic and static friction, expected coulomb-viscous, "
            "kinetic-static and stribeck");
    }
    return friction;
}

Levels levels_of(const Friction& friction)
{
    const double n = friction.normal_load;
    if (const auto* law = std::get_if<CoulombViscous>(&friction.law)) return {n * law->coulomb, n * law->coulomb};
    if (const auto* law = std::get_if<KineticStatic>(&friction.law)) return {n * law->kinetic, n * law->breakaway};
    const auto& law = std::get<Stribeck>(friction.law);
    return {n * law.c0, n * (law.c0 + law.c2)};
}

double viscous_of(const Friction& friction)
{
    const double n = friction.normal_load;
    if (const auto* law = std::get_if<CoulombViscous>(&friction.law)) return n * law->viscous;
    if (const auto* law = std::get_if<Stribeck>(&friction.law)) return n * law->c1;
    return 0;
}

class SetPointSearch {
  public:
    SetPointSearch(const Joint& joint, const SetPointRequirements& asked, const ParallelFor& parallel)
        : joint_(joint), asked_(asked), parallel_(parallel)
    {
        const double m = asked.friction_margin;
        for (const double kinetic : {1 - m, 1 + m})
            for (const double breakaway : {1 - m, 1 + m})
                if (const Friction f = scaled(joint.friction, kinetic, breakaway); distinct(f)) corners_.push_back(f);
    }

    SetPointDesign run()
    {
        SetPointDesign design;
        const auto regulator = regulator_of(joint_);
        per_signal_ = regulator.k_p / gains_of(joint_.control).k_p;
        design.k_i_limit = stable_integral_gain(joint_, viscous_of(joint_.friction));
        design.k_i_assumed = !is_set(asked_.k_i) && !(joint_.control.k_i > 0);
        design.k_i_used = is_set(asked_.k_i)   ? asked_.k_i
                          : design.k_i_assumed ? assumed_share * design.k_i_limit
                                               : joint_.control.k_i;
        k_i_ = design.k_i_used;
        design.choices.push_back(proven(SetPointWay::as_described, joint_));
        if (asked_.over_k_i) design.choices.push_back(proven(SetPointWay::no_integral, plain(0)));
        if (!(design.k_i_limit > 0)) return design;  // no way to hold it makes an unstable loop a stable one
        if (asked_.over_dead_zone) design.choices.push_back(with_dead_zone(SetPointWay::dead_zone, plain(k_i_)));
        if (asked_.over_push) design.choices.push_back(with_push());
        if (asked_.over_push && asked_.over_k_i) design.choices.push_back(with_push_alone());
        if (asked_.over_push && asked_.over_dead_zone)
            design.choices.push_back(
                with_dead_zone(SetPointWay::push_and_dead_zone, pushed(k_i_, most_push() / reserve)));
        if (asked_.over_dither) design.choices.push_back(with_dither());
        for (std::size_t i = 0; i < design.choices.size(); ++i) {
            const auto& c = design.choices[i];
            if (c.holds && (design.best < 0 || better(c, design.choices[static_cast<std::size_t>(design.best)])))
                design.best = static_cast<int>(i);
        }
        return design;
    }

  private:
    static constexpr double assumed_share = 0.1;  ///< of Routh's limit
    static constexpr double reserve = 1.05;       ///< below the static friction, beyond the least dead zone

    bool distinct(const Friction& f) const
    {
        const auto now = levels_of(f);
        return std::none_of(corners_.begin(), corners_.end(), [&](const Friction& other) {
            const auto l = levels_of(other);
            return l.kinetic == now.kinetic && l.breakaway == now.breakaway;
        });
    }

    /// Of two that hold: the smaller error; among equals the one that integrates, which removes what a load leaves.
    static bool better(const SetPointChoice& a, const SetPointChoice& b)
    {
        if (a.rest_error != b.rest_error) return a.rest_error < b.rest_error;
        return a.k_i > 0 && !(b.k_i > 0);
    }

    /// Nothing but gains; a push that looks at the reference is silent at a set point and stays.
    Joint plain(double k_i) const
    {
        Joint j = joint_;
        j.control.k_i = k_i;
        j.control.dead_zone = 0;
        if (j.control.feed_forward.fed_back()) j.control.feed_forward.coulomb = 0;
        j.control.dither.amplitude = 0;
        return j;
    }

    Joint pushed(double k_i, double effort) const
    {
        Joint j = plain(k_i);
        auto& f = j.control.feed_forward;
        f.coulomb = effort / per_signal_;
        f.coulomb_from = CoulombFrom::error;
        f.coulomb_width = 0;
        if (is_set(asked_.push_speed)) f.coulomb_speed = asked_.push_speed;
        return j;
    }

    double least_push() const
    {
        double drop = 0;
        for (const auto& f : corners_) drop = std::max(drop, levels_of(f).breakaway - levels_of(f).kinetic);
        return drop;
    }

    double most_push() const
    {
        double least = infinity;
        for (const auto& f : corners_) least = std::min(least, levels_of(f).breakaway);
        return least;
    }

    /// The least kinetic friction: a dither beyond it may keep the joint moving.
    double most_dither() const
    {
        double least = infinity;
        for (const auto& f : corners_) least = std::min(least, levels_of(f).kinetic);
        return least;
    }

    bool hunts_somewhere(const Joint& joint) const
    {
        return std::any_of(corners_.begin(), corners_.end(), [&](const Friction& f) {
            Joint j = joint;
            j.friction = f;
            const auto s = set_point(j, quick_set_point);
            return s.hunting != Hunting::no || s.diverges();
        });
    }

    SetPointChoice proven(SetPointWay way, const Joint& joint) const
    {
        SetPointChoice c;
        c.way = way;
        c.k_i = joint.control.k_i;
        c.dead_zone = joint.control.dead_zone;
        if (const auto& f = joint.control.feed_forward; f.by_error())
            c.push = f.coulomb, c.push_speed = f.coulomb_speed;
        if (const auto& d = joint.control.dither; d.amplitude > 0)
            c.dither = d.amplitude, c.dither_frequency = d.frequency;
        c.proofs.resize(corners_.size());
        parallel_(corners_.size(), [&](std::size_t i) {
            Joint j = joint;
            j.friction = corners_[i];
            const auto levels = levels_of(j.friction);
            c.proofs[i] = {levels.kinetic, levels.breakaway, set_point(j, {asked_.starts_per_decade})};
        });
        c.holds = true, c.rest_error = 0;
        for (const auto& p : c.proofs) {
            const bool rests = p.answer.hunting == Hunting::no && !p.answer.diverges();
            c.holds = c.holds && rests;
            c.rest_error = std::max(c.rest_error, p.answer.rest_error);
        }
        if (!c.holds) c.rest_error = missing;
        return c;
    }

    SetPointChoice with_push() const
    {
        const double low = least_push(), high = most_push();
        if (!(low < high)) {
            SetPointChoice none;
            none.way = SetPointWay::push;
            none.low = low, none.high = high;
            return none;
        }
        // no drop to overcome: any push is enough, half of the most is far from both ends
        const double effort = low > 0 ? std::sqrt(low * high) : 0.5 * high;
        auto c = proven(SetPointWay::push, pushed(k_i_, effort));
        c.low = low, c.high = high;
        return c;
    }

    SetPointChoice with_push_alone() const
    {
        auto c = proven(SetPointWay::push_without_integral, pushed(0, most_push() / reserve));
        c.low = 0, c.high = most_push();
        return c;
    }

    SetPointChoice with_dither() const
    {
        Joint j = plain(0);
        j.control.dither.amplitude = most_dither() / reserve / std::abs(per_signal_);
        auto c = proven(SetPointWay::dither_without_integral, j);
        c.low = 0, c.high = most_dither();
        return c;
    }

    /// The least dead zone: from wide ones down to the first that hunts, then between.
    SetPointChoice with_dead_zone(SetPointWay way, Joint joint) const
    {
        constexpr double widest = 30, narrower = 0.5, close = 1e-3;
        constexpr int most = 40, widenings = 8;
        constexpr double wider = 1.1;
        double natural = 0;
        for (const auto& f : corners_) {
            Joint j = plain(k_i_);
            j.friction = f;
            const auto s = set_point(j, quick_set_point);
            natural = std::max(natural, is_set(s.amplitude) ? s.amplitude : 0);
        }
        SetPointChoice c;
        c.way = way;
        if (!(natural > 0)) {  // nothing hunts, and no dead zone is needed
            c = proven(way, joint);
            c.low = 0;
            return c;
        }
        const auto hunts = [&](double zone) { return joint.control.dead_zone = zone, hunts_somewhere(joint); };
        double wide = widest * natural;
        if (hunts(wide)) return c;
        double narrow = narrower * wide;
        int steps = 0;
        for (; steps < most && !hunts(narrow); ++steps) wide = narrow, narrow *= narrower;
        if (steps == most) narrow = 0;
        while (narrow > 0 && wide - narrow > close * wide) {
            const double middle = std::sqrt(wide * narrow);
            (hunts(middle) ? narrow : wide) = middle;
        }
        joint.control.dead_zone = reserve * wide;
        c = proven(way, joint);
        c.low = wide;
        // a proof looks at more starts than the search, and may find a cycle that it passed by
        for (int i = 0; i < widenings && !c.holds; ++i) {
            wide = joint.control.dead_zone;
            joint.control.dead_zone = wider * wide;
            c = proven(way, joint);
            c.low = wide;
        }
        return c;
    }

    const Joint joint_;
    const SetPointRequirements asked_;
    const ParallelFor& parallel_;
    std::vector<Friction> corners_;
    double k_i_ = missing, per_signal_ = 1;
};

void check_set_point_joint(const Joint& joint, const SetPointRequirements& asked)
{
    const auto refuse = [](const char* text) { throw std::invalid_argument(text); };
    if (joint.mechanism.model != Model::single_mass)
        refuse("joint.model: a design of a set point is of one mass, expected \"single-mass\"");
    if (joint.control.kind == ControlKind::force)
        refuse("control.kind: a force loop has no position set point, expected \"position\"");
    if (joint.control.structure == Structure::cascade)
        refuse(
            "control.structure: a design of a set point turns k_i, a cascade has none alone; describe it by its sum of "
            "gains with control.structure = \"pid\"");
    if (!(joint.control.k_p > 0)) refuse("control.k_p: a set point needs a position gain, expected numbers > 0");
    if (!(asked.friction_margin >= 0 && asked.friction_margin < 1))
        refuse("friction_margin: expected shares from 0 to below 1");
    if (is_set(asked.k_i) && !(asked.k_i > 0)) refuse("k_i: expected numbers > 0");
}

}  // namespace

Joint with_choice(Joint joint, const SetPointChoice& choice)
{
    if (choice.way == SetPointWay::as_described) return joint;
    auto& c = joint.control;
    c.k_i = choice.k_i;
    c.dead_zone = choice.dead_zone;
    if (choice.push != 0) {
        c.feed_forward.coulomb = choice.push;
        c.feed_forward.coulomb_from = CoulombFrom::error;
        c.feed_forward.coulomb_speed = choice.push_speed;
        c.feed_forward.coulomb_width = 0;
    } else if (c.feed_forward.fed_back()) {
        c.feed_forward.coulomb = 0;
    }
    c.dither.amplitude = choice.dither;
    if (choice.dither > 0) c.dither.frequency = choice.dither_frequency;
    return joint;
}

SetPointDesign design_set_point(const Joint& joint, const SetPointRequirements& requirements,
                                const ParallelFor& parallel)
{
    check_set_point_joint(joint, requirements);
    return SetPointSearch(joint, requirements, parallel).run();
}

}  // namespace stickslip
