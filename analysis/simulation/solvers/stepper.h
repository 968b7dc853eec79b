// One integration of a flow, step by step, stopping exactly at events. Two solvers stand behind it.
#pragma once
#include "analysis/simulation/flows/flow.h"

#include <functional>
#include <memory>

namespace stickslip {

enum class Solver { cvode, rodas5p };

inline constexpr int max_events = 2 + 3;  ///< two of the speed, one a body

/// Functions of the state whose zeros stop a step.
struct Events {
    int count = 0;
    std::function<void(const FlowVector& y, double* values)> values;
};

enum class StepEnd { step, event, time, failure };

/// What ended a step; `event` says which function crossed zero and in which direction.
struct StepReport {
    StepEnd end = StepEnd::step;
    int event = -1;
    int direction = 0;
};

/// Integrates ẏ = F(y) from start() on. Not safe to share between threads; any number may run side by side.
class Stepper {
  public:
    virtual ~Stepper() = default;
    virtual void start(const Flow& flow, double t, const FlowVector& y, const Events& events) = 0;
    /// One step of the solver's own size, ending at the latest at t_end, or earlier at an event.
    virtual StepReport step(double t_end) = 0;
    virtual double time() const = 0;
    virtual const FlowVector& state() const = 0;
    /// State at a time within the last step.
    virtual FlowVector at(double t) const = 0;
};

/// SUNDIALS CVODE, variable-order BDF with the flow's Jacobian and CVODE's own root-finding.
std::unique_ptr<Stepper> cvode_stepper(double rtol);

/// Rodas5P with the flow's Jacobian: one-step, hence without trouble at restarts, and the fallback where CVODE fails.
std::unique_ptr<Stepper> rodas5p_stepper(double rtol);

inline std::unique_ptr<Stepper> stepper(Solver solver, double rtol)
{
    return solver == Solver::cvode ? cvode_stepper(rtol) : rodas5p_stepper(rtol);
}

}  // namespace stickslip
