#include "analysis/simulation/sampled/closed_loop/loop_controller.h"

namespace stickslip {

LoopController::LoopController(const Joint& joint, double frame, double gear)
    : control_(joint.control),
      load_(joint.load),
      gains_(gains_of(joint.control)),
      gain_of_integral_(control_.structure == Structure::cascade ? velocity_integral_gain(control_) : control_.k_i),
      frame_(frame),
      gear_(gear)
{
    state.window.resize(static_cast<std::size_t>(std::max(1.0, control_.velocity_estimate.average)));
    state.output = not_set;  // nothing was commanded yet
}

double LoopController::begin(double output, double velocity, double step)
{
    const auto& c = control_;
    last_rate_ = frame_ != 0 ? frame_ : velocity;
    state.velocity = state.before = velocity;
    const auto steady = steady_output(c, output - ahead(0, last_rate_, step), last_rate_, velocity);
    if (!is_set(steady.error)) return not_set;
    if (integrates()) hold(steady.held / gain_of_integral_);
    state.reading = -steady.error;
    state.output = output;
    state.error = outside_dead_zone(steady.error);
    state.fresh = false;
    fill_window(velocity, step);
    return state.reading;
}

void LoopController::begin_holding(double reading, double output, double step)
{
    const auto& c = control_;
    arrive(reading, 0, step);
    last_rate_ = 0;
    const double seen = outside_dead_zone(-reading), wanted = c.position_gain * seen;
    const bool cascade = c.structure == Structure::cascade;
    const double held_otherwise =
        (cascade ? c.velocity_gain * wanted : c.k_p * seen) + c.feed_forward.push(0, 0, seen) + ahead(0, 0, step);
    state.integral = (output - held_otherwise) / gain_of_integral_;
    state.error = cascade ? wanted : seen;
    state.output = output;
}

/// Counts the integral from the first steady value that it is given.
void LoopController::hold(double integral)
{
    if (!holds_) held_ = integral, holds_ = true;
    state.integral = integral - held_;
}

void LoopController::arrive(double reading, double velocity, double step)
{
    state.reading = reading;
    state.velocity = state.before = velocity;
    state.fresh = false;
    fill_window(velocity, step);
}

/// With where it was before, in a frame that may move at another velocity.
void LoopController::fill_window(double velocity, double step)
{
    auto& w = state.window;
    for (std::size_t i = 0; i < w.size(); ++i)
        w[i] = state.reading + (frame_ - velocity) * step * static_cast<double>(w.size() - i);
}

void LoopController::read(double reading, double step, double exact)
{
    const auto& estimate = control_.velocity_estimate;
    auto& w = state.window;
    state.reading = reading;
    const bool first = state.fresh;
    if (first) std::fill(w.begin(), w.end(), reading);
    state.fresh = false;
    // ȳ_k − ȳ_{k−1} of the mean over n readings is (y_k − y_{k−n})/n
    const double rise = (reading - w.front()) / static_cast<double>(w.size());
    std::copy(w.begin() + 1, w.end(), w.begin());
    w.back() = reading;
    if (continuous()) {
        const double before = first ? exact : state.before;
        const double share = step / (2 * estimate.tau + step);
        state.velocity = estimate.tau > 0 ? state.velocity + share * (exact + before - 2 * state.velocity) : exact;
        state.before = exact;
    } else if (estimate.form == EstimateForm::exact) {
        state.velocity = exact;
    } else if (!first) {
        state.velocity += step / (estimate.tau + step) * (frame_ + rise / step - state.velocity);
    }
}

double LoopController::rate_error(double rate) const
{
    return velocity_error(control_, rate, state.velocity);
}

double LoopController::outside_dead_zone(double error) const
{
    return error - std::clamp(error, -control_.dead_zone, control_.dead_zone);
}

/// What depends on the reference alone.
double LoopController::ahead(double reference, double rate, double step)
{
    const auto& f = control_.feed_forward;
    double sum = 0;
    if (f.acceleration != 0 && is_set(last_rate_)) sum += f.acceleration * (rate - last_rate_) / step;
    last_rate_ = rate;
    if (f.gravity) sum += load_.gravity_amplitude * std::sin((reference + path_) / gear_ + load_.gravity_phase) / gear_;
    return sum;
}

/// By the rectangle that ends at this tick; of a continuous loop by the trapezium.
void LoopController::integrate(double input, double error, double step)
{
    const auto& c = control_;
    const bool drives_on =
        (saturated_high_ && gain_of_integral_ * input > 0) || (saturated_low_ && gain_of_integral_ * input < 0);
    const bool held = (c.anti_windup == AntiWindup::clamp && (saturated_high_ || saturated_low_)) ||
                      (c.anti_windup == AntiWindup::conditional && drives_on);
    const double mean = continuous() ? 0.5 * (input + state.error) : input;
    state.error = input;
    if (!held && std::abs(error) <= c.integral_band) state.integral += step * mean;
    if (c.anti_windup == AntiWindup::back_calculation)
        state.integral += step / c.tracking_time * cut_ / gain_of_integral_;
    const double most = c.integral_limit / std::abs(gain_of_integral_);
    state.integral = std::clamp(state.integral, -most - held_, most - held_);
}

double LoopController::command(double reference, double rate, double step, double added)
{
    const auto& c = control_;
    const double error = reference - state.reading, seen = outside_dead_zone(error);
    double output;
    if (c.structure == Structure::cascade) {
        const double wanted = c.position_gain * seen + rate_error(rate);
        if (integrates()) integrate(wanted, error, step);
        output = c.velocity_gain * wanted;
    } else {
        if (integrates()) integrate(seen, error, step);
        output = c.k_p * seen + (c.k_v != 0 ? c.k_v * rate_error(rate) : 0);
    }
    if (integrates()) output += gain_of_integral_ * integral();
    const double push = c.feed_forward.push(rate, state.velocity, seen);
    const bool jumps = c.feed_forward.jumps();
    output += ahead(reference, rate, step) + added + (jumps ? 0 : push);
    if (continuous()) {
        const double now = output;
        if (is_set(state.output)) output += 0.5 * (now - state.output);
        state.output = now;
    }
    const double known = c.dither.at(time_) + (jumps ? push : 0);  // of this moment, or without a slope to go on by
    logged_ = std::clamp((continuous() ? state.output : output) + known, -c.effort_limit, c.effort_limit);
    output += known;
    const double limited = std::clamp(output, -c.effort_limit, c.effort_limit);
    saturated_high_ = output > c.effort_limit, saturated_low_ = output < -c.effort_limit;
    wanted_ = output, cut_ = limited - output;
    return limited;
}

}  // namespace stickslip
