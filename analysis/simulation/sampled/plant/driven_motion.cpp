#include "analysis/simulation/sampled/plant/driven_motion.h"

#include "analysis/simulation/solvers/rodas5p.h"

#include <cmath>

namespace stickslip {

/// One step of at most this length that the tolerance accepts.
bool DrivenMotion::step_to(double left)
{
    // beside the kink of a level at rest errors do not fall with the step until it is shorter than the kink's layer
    constexpr int most_tries = 60, patient_tries = 12;
    constexpr double shrink = 0.9, shrink_faster = 0.1;
    step_.y0 = y;
    if (options_.fixed_step > 0) {
        step_.h = left / std::ceil(left / options_.fixed_step * (1 - 1e-12));
        ++steps;
        return step_.take(joint);
    }
    double h = wish_ > 0 ? wish_ : 0.05 * left;
    for (int i = 0; i < most_tries; ++i) {
        const bool last = h >= left * (1 - 1e-9);
        step_.h = last ? left : h > 0.5 * left ? 0.5 * left : h;
        ++steps;
        const double error = step_.take(joint) ? step_.error(joint, options_.rtol) : infinity;
        const double factor = step_factor(error);
        if (error <= 1) {
            const double next = step_.h * factor;
            wish_ =
                last && next < wish_ ? std::min(wish_, std::max(next, wish_ * 0.5)) : std::max(next, last ? wish_ : 0);
            return true;
        }
        h = step_.h * std::min(factor, i < patient_tries ? shrink : shrink_faster);
        wish_ = h;
    }
    return false;
}

/// A body that breaks away starts where its own switch is zero: a step that ends beyond the zero again would hide it,
/// and is shortened until it does not. A body that does so in the shortest stays: what drives it has turned.
bool DrivenMotion::keep_launches(double left)
{
    std::array<double, 2 * max_bodies> after{};
    const auto hidden = [&] {
        joint.switch_values(step_.y1.data(), after.data());
        for (int i = 0; i < joint.bodies(); ++i)
            if (before_[i] == 0 && after[i] < 0 && joint.modes[i] != DrivenJoint::Mode::stuck) return i;
        return -1;
    };
    constexpr int halvings = 40;
    for (int tries = 0; tries < halvings; ++tries) {
        if (hidden() < 0) return true;
        step_.h *= 0.5;
        ++steps;
        if (!step_.take(joint)) return false;
    }
    for (int i = hidden(); i >= 0; i = hidden()) {
        joint.hold(i);
        joint.switch_values(y.data(), before_.data());
        step_.forget();
        if (!step_to(left)) return false;
    }
    return true;
}

/// The switch that changes its sign first within the step, −1 for none.
int DrivenMotion::first_switch(double& fraction) const
{
    std::array<double, 2 * max_bodies> after{}, inside{};
    DrivenState y_inside;
    joint.switch_values(step_.y1.data(), after.data());
    int first = -1;
    constexpr double same_instant = 1e-9;  // of a step
    constexpr double left_behind = 1e-6;   // of a step, after which a flank that it began on no longer counts
    for (int i = 0; i < joint.switches(); ++i) {
        double low = 0, high = 1, f_low = before_[i], f_high = after[i];
        if (i == passed_) {
            low = left_behind;
            step_.dense(low, y_inside.data());
            joint.switch_values(y_inside.data(), inside.data());
            f_low = inside[i];
        }
        if (f_low * f_high > 0 || f_low == 0 || f_high == 0) {
            const bool lands = f_high == 0 && f_low != 0;
            if (!lands) continue;
        }
        int kept = 0;
        for (int k = 0; k < 60 && high - low > 1e-13; ++k) {  // Illinois on the dense output
            const double middle =
                f_high == f_low ? 0.5 * (low + high) : (low * f_high - high * f_low) / (f_high - f_low);
            step_.dense(middle, y_inside.data());
            joint.switch_values(y_inside.data(), inside.data());
            const double f = inside[i];
            if (f == 0) {
                low = high = middle;
                break;
            }
            if ((f > 0) == (f_high > 0)) {
                high = middle, f_high = f;
                if (kept == -1) f_low /= 2;
                kept = -1;
            } else {
                low = middle, f_low = f;
                if (kept == 1) f_high /= 2;
                kept = 1;
            }
        }
        const double found = high;
        // at a flank forces jump: a body that gives way there does so because of it
        const double sooner = i >= joint.bodies() ? fraction + same_instant : fraction;
        if (first >= 0 && found >= sooner) continue;
        first = i, fraction = found;
    }
    return first;
}

/// Repeats the step with lengths close to the crossing that the dense output shows, so that the state there has the
/// order of the method.
void DrivenMotion::land_on(int which, double fraction)
{
    if (fraction >= 1) return;
    std::array<double, 2 * max_bodies> values{};
    double h = fraction * step_.h, h_old = 0, f_old = before_[which];
    for (int k = 0; k < 4 && h > 0; ++k) {
        step_.h = h;
        ++steps;
        if (!step_.take(joint)) return;
        joint.switch_values(step_.y1.data(), values.data());
        const double f = values[which];
        if (f == f_old || f == 0) break;
        const double next = h - f * (h - h_old) / (f - f_old);
        if (!(next > 0) || std::abs(next - h) < 1e-14 * h) break;
        h_old = h, f_old = f, h = next;
    }
}

}  // namespace stickslip
