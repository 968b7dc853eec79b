#include "analysis/simulation/set_point/presliding.h"

#include "analysis/simulation/solvers/stepper.h"

namespace stickslip {
namespace {

constexpr double rtol = 1e-9;
constexpr long most_steps = 2'000'000;
constexpr int most_halves = 3000;
constexpr double same = 1e-8;       ///< relative change of the amplitude from half to half that counts as none
constexpr double patience = 8;      ///< times the longest stop that ends in a slip
constexpr double slip_share = 0.01; ///< of the highest speed
constexpr double far = 1e3;

enum PreslidingEvent { across = 0, turns = 1, presliding_events };

/// What was seen between two crossings of the set point.
struct Half {
    double amplitude = 0, duration = 0, slip = 0;
};

class Walk {
  public:
    Walk(const Regulator& regulator, const Friction& friction, double start)
        : start_(start),
          flow_(regulator, friction, start, start * std::sqrt(regulator.k_p / regulator.inertia)),
          solver_(rodas5p_stepper(rtol))
    {
        events_.count = presliding_events;
        events_.values = [this](const FlowVector& y, double* values) {
            values[across] = y[0] / start_;
            values[turns] = flow_.speed_measure(y);
        };
        FlowVector y = FlowVector::Zero(flow_.size());
        y[0] = -start;
        y[2] = -regulator.k_p * regulator.error(-start);
        solver_->start(flow_, 0, y, events_);
    }

    enum class Ended { crossed, waits, runaway, failure };

    /// To the next crossing of the set point, or until `longest` has passed.
    Ended half(double longest, Half& seen)
    {
        const double begun = solver_->time();
        seen = {};
        double fastest = 0, before = begun;
        speeds_.clear();
        for (;;) {
            if (++steps_ > most_steps) return Ended::failure;
            const auto report = solver_->step(begun + longest);
            const auto& y = solver_->state();
            if (report.end == StepEnd::failure || !y.allFinite()) return Ended::failure;
            seen.amplitude = std::max(seen.amplitude, std::abs(y[0]));
            if (seen.amplitude > far * start_) return Ended::runaway;
            fastest = std::max(fastest, std::abs(y[1]));
            speeds_.push_back({std::abs(y[1]), solver_->time() - before});
            before = solver_->time();
            if (report.end == StepEnd::time) return Ended::waits;
            if (report.end == StepEnd::event && report.event == across) break;
        }
        seen.duration = solver_->time() - begun;
        for (const auto& [speed, time] : speeds_)
            if (speed > slip_share * fastest) seen.slip += time;
        return Ended::crossed;
    }

  private:
    double start_;
    RegulatorFlow flow_;
    Events events_;
    std::unique_ptr<Stepper> solver_;
    std::vector<std::pair<double, double>> speeds_;
    long steps_ = 0;
};

}  // namespace

Presliding follow_presliding(const Regulator& regulator, const Friction& friction, double start, double effort,
                             double give)
{
    Presliding result;
    Walk walk(regulator, friction, start);
    double before = start, change = missing;
    for (int i = 0; i < most_halves; ++i) {
        Half half;
        // the stop at a distance a lasts until k_i a t has carried the effort from one breakaway to the other
        const double longest = patience * (2 * effort + regulator.k_p * before) / (regulator.k_i * before);
        switch (walk.half(longest, half)) {
            case Walk::Ended::waits:
                return result.end = Presliding::End::settles, result;
            case Walk::Ended::runaway:
                return result.end = Presliding::End::runaway, result;
            case Walk::Ended::failure:
                return result;
            case Walk::Ended::crossed:
                break;
        }
        const double now = half.amplitude - before;
        if (i > 1 && std::abs(now) > 1e2 * same * before) result.multiplier = now / change;
        change = now;
        before = half.amplitude;
        if (before < give) return result.end = Presliding::End::settles, result;
        if (i < 2 || std::abs(change) > same * before) continue;
        result.end = Presliding::End::cycle;
        result.amplitude = half.amplitude;
        result.slip_time = half.slip;
        result.stick_time = half.duration - half.slip;
        return result;
    }
    return result;
}

}  // namespace stickslip
