#include "analysis/simulation/sampled/loop_controller.h"

namespace stickslip {

LoopController::LoopController(const Control& control, double frame) : control_(control), frame_(frame)
{
    state.window.resize(static_cast<std::size_t>(std::max(1.0, control.velocity_estimate.average)));
}

void LoopController::begin(double reading, double output)
{
    std::fill(state.window.begin(), state.window.end(), reading);
    state.reading = reading;
    state.velocity = state.before = frame_;
    state.output = output;
    state.fresh = false;
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
    } else if (estimate.form == EstimateForm::exact)
        state.velocity = exact;
    else if (!first)
        state.velocity += step / (estimate.tau + step) * (frame_ + rise / step - state.velocity);
}

double LoopController::command(double reference, double rate, double added)
{
    const auto& c = control_;
    const double rate_error = (c.reference_velocity ? rate : 0) - state.velocity;
    double output = c.k_p * (reference - state.reading) + (c.k_v != 0 ? c.k_v * rate_error : 0) + added;
    if (continuous()) {
        const double now = output;
        output += 0.5 * (now - state.output);
        state.output = now;
    }
    return std::clamp(output, -c.effort_limit, c.effort_limit);
}

double LoopController::steady_reading(double output) const
{
    const auto& c = control_;
    const double lost = c.reference_velocity ? 0 : c.k_v * frame_;
    return -(output + lost) / c.k_p;
}

}  // namespace stickslip
