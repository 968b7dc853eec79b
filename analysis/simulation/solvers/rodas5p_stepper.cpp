#include "analysis/simulation/solvers/rodas5p.h"
#include "analysis/simulation/solvers/stepper.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

class Rodas5PStepper final : public Stepper {
  public:
    explicit Rodas5PStepper(double rtol) : rtol_(rtol) {}

    void start(const Flow& flow, double t, const FlowVector& y, const Events& events) override
    {
        flow_ = &flow;
        events_ = &events;
        scale_ = flow.scale();
        t_ = t_before_ = t;
        step_.y = step_.y1 = y;
        h_ = std::max(first_step(flow, y), 1e-12 * std::abs(t));  // time itself must still resolve it
        if (events.count) events.values(y, value_.data());
    }

    StepReport step(double t_end) override
    {
        step_.y = step_.y1;
        t_before_ = t_;
        double h = h_;
        for (;;) {
            const bool last = t_ + h >= t_end;
            step_.h = last ? t_end - t_ : h;
            if (!(std::abs(step_.h) > 1e-15 * std::abs(t_))) return {last ? StepEnd::time : StepEnd::failure};
            rodas5p_step(*flow_, step_);
            const double error = scaled_error(step_, scale_, rtol_);
            const double factor = step_factor(error);
            if (error <= 1) {
                if (!last || factor < 1) h_ = step_.h * factor;
                return finish(last ? StepEnd::time : StepEnd::step);
            }
            h = step_.h * std::min(factor, 0.9);
        }
    }

    double time() const override { return t_; }
    const FlowVector& state() const override { return step_.y1; }
    FlowVector at(double t) const override { return step_.dense((t - t_before_) / (t_ - t_before_)); }

  private:
    /// Ends the step at its end or at the first event within it.
    StepReport finish(StepEnd end)
    {
        const double full = step_.h;
        std::array<double, max_events> after{};
        if (events_->count) events_->values(step_.y1, after.data());
        int event = -1;
        double earliest = 1;
        for (int i = 0; i < events_->count; ++i) {
            if (value_[i] * after[i] > 0 || value_[i] == 0 || value_[i] == after[i]) continue;
            const double fraction = crossing(i, after[i]);
            if (event >= 0 && fraction >= earliest) continue;
            event = i;
            earliest = fraction;
        }
        if (event < 0) {
            t_ = t_before_ + full;
            value_ = after;
            return {end};
        }
        const int direction = after[event] > value_[event] ? 1 : -1;
        land_on(event, earliest * full);
        t_ = t_before_ + step_.h;
        const auto before = value_;
        events_->values(step_.y1, value_.data());
        for (int i = 0; i < events_->count; ++i)
            if (i != event && value_[i] == 0) value_[i] = before[i];
        value_[event] = direction * tiny_;  // on the far side, whatever the last bit says
        return {StepEnd::event, event, direction};
    }

    double event_value(int i, const FlowVector& y) const
    {
        std::array<double, max_events> values{};
        events_->values(y, values.data());
        return values[i];
    }

    /// Zero of event i within the step, on the dense output (Illinois).
    double crossing(int i, double end) const
    {
        double left = 0, right = 1, f_left = value_[i], f_right = end;
        int kept = 0;  // the end that the last round kept
        for (int k = 0; k < 60 && right - left > 1e-12; ++k) {
            const double middle = (left * f_right - right * f_left) / (f_right - f_left);
            const double f = event_value(i, step_.dense(middle));
            if (f == 0) return middle;
            if ((f > 0) == (f_right > 0)) {
                right = middle, f_right = f;
                if (kept == -1) f_left /= 2;
                kept = -1;
            } else {
                left = middle, f_left = f;
                if (kept == 1) f_right /= 2;
                kept = 1;
            }
        }
        return 0.5 * (left + right);
    }

    /// Repeats the step with lengths close to the dense output's crossing, so that the state at the event has the full
    /// order of the method.
    void land_on(int i, double h)
    {
        double h_old = 0, f_old = value_[i];
        for (int k = 0; k < 4; ++k) {
            step_.h = h;
            rodas5p_step(*flow_, step_);
            const double f = event_value(i, step_.y1);
            if (f == f_old || std::abs(f) < 1e-15) break;
            const double next = h - f * (h - h_old) / (f - f_old);
            h_old = h, f_old = f;
            if (!(next > 0) || std::abs(next - h) < 1e-14 * h) break;
            h = next;
        }
    }

    static constexpr double tiny_ = 1e-300;
    double rtol_;
    const Flow* flow_ = nullptr;
    const Events* events_ = nullptr;
    FlowVector scale_;
    RodasStep step_;
    double t_ = 0, t_before_ = 0, h_ = 0;
    std::array<double, max_events> value_{};
};

}  // namespace

std::unique_ptr<Stepper> rodas5p_stepper(double rtol)
{
    return std::make_unique<Rodas5PStepper>(rtol);
}

}  // namespace stickslip
