#include "analysis/simulation/sampled/cycles/turns.h"

#include "analysis/numerics/hermite.h"
#include "analysis/numerics/root.h"
#include "analysis/simulation/flows/near_rest.h"

#include <cmath>

namespace stickslip {
namespace {

constexpr double reversal = 1e-6;          ///< of V_0: slower backward motion is the error of a step that ends at rest
constexpr double rounding = 1e-12;         ///< of V_0: what a rest leaves; laws that creep can be slower than 1e-6
constexpr double crossing_digits = 1e-12;  ///< of a step

}  // namespace

double or_rest(double velocity, double V0)
{
    return std::abs(velocity) < rounding * std::abs(V0) ? 0 : velocity;
}

void TurnWatch::visit(double velocity, double position)
{
    now_.velocity_min = std::min(now_.velocity_min, velocity);
    now_.velocity_max = std::max(now_.velocity_max, velocity);
    now_.position_min = std::min(now_.position_min, position - origin_);
    now_.position_max = std::max(now_.position_max, position - origin_);
}

void TurnWatch::reset(double t)
{
    now_ = {};
    now_.t0 = t;
    begun_ = has_done_ = false;
}

/// The fraction of the step at which the link has this velocity.
double TurnWatch::crossing(const DrivenStep& s, double level, double from, double to) const
{
    DrivenState y;
    const int link = s.joint.link();
    const auto miss = [&](double fraction) {
        s.step.dense(fraction, y.data());
        return s.joint.velocity(y.data(), link) - level;
    };
    return bracketed_root(miss, 0, from - level, 1, to - level, crossing_digits, crossing_digits).value;
}

void TurnWatch::operator()(const DrivenStep& s)
{
    const auto& joint = s.joint;
    const int link = joint.link(), row = joint.bodies() + link;
    const double* y0 = s.step.y0.data();
    const double* y1 = s.step.y1.data();
    const double v0 = joint.velocity(y0, link), v1 = joint.velocity(y1, link), h = s.step.h;
    const double sign = V0_ < 0 ? -1 : 1;
    visit(v0, y0[link]);
    // a turning point of the speed
    DrivenState room, y;
    const double* rate = s.step.last_rate(joint, room);
    const auto xi = hermite_turning(y0[row], y1[row], s.step.first_rate()[row], rate[row], h);
    if (xi) {
        s.step.dense(*xi, y.data());
        visit(joint.velocity(y.data(), link), y[link]);
    }
    const double slow = near_rest * std::abs(V0_);
    const bool slow0 = sign * v0 <= slow, slow1 = sign * v1 <= slow;
    if (slow0 && slow1)
        now_.rest_time += h;
    else if (slow0 != slow1) {
        const double part = crossing(s, sign * slow, v0, v1);
        now_.rest_time += h * (slow0 ? part : 1 - part);
    }
    if (std::min(sign * v0, sign * v1) < -reversal * std::abs(V0_)) now_.reversed = true;
    if ((v0 - V0_) * (v1 - V0_) > 0 || v1 == V0_) return visit(v1, y1[link]);
    const double part = v0 == V0_ ? 0 : crossing(s, V0_, v0, v1);
    s.step.dense(part, y.data());
    pass(s.t + part * h, y[link], sign * (v1 - v0) < 0);
    visit(v1, y1[link]);
}

void TurnWatch::pass(double t, double position, bool downwards)
{
    visit(V0_, position);  // where the position turns
    if (!downwards) return;
    now_.t1 = t;
    if (begun_) done_ = now_, has_done_ = true;
    begun_ = true;
    now_ = {};
    now_.t0 = t;
    visit(V0_, position);
}

bool TurnWatch::take(LoopTurn& turn)
{
    if (!has_done_) return false;
    turn = done_;
    has_done_ = false;
    return true;
}

}  // namespace stickslip
