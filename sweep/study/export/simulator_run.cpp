#include "sweep/study/export/simulator_run.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// A column of the record between its rows.
class Signal {
  public:
    Signal(const std::vector<double>& time, const std::vector<double>& rows) : time_(time), rows_(rows) {}
    bool known() const { return !rows_.empty(); }
    /// Of times that only grow.
    double at(double t)
    {
        while (row_ + 2 < time_.size() && time_[row_ + 1] <= t) ++row_;
        const double step = time_[row_ + 1] - time_[row_];
        return std::lerp(rows_[row_], rows_[row_ + 1], std::clamp((t - time_[row_]) / step, 0.0, 1.0));
    }

  private:
    const std::vector<double>&time_, &rows_;
    std::size_t row_ = 0;
};

std::vector<double> slopes(const std::vector<double>& time, const std::vector<double>& x)
{
    std::vector<double> v(x.size(), 0.0);
    for (std::size_t k = 0; k < x.size(); ++k) {
        const std::size_t a = k > 0 ? k - 1 : 0, b = std::min(k + 1, x.size() - 1);
        if (b > a) v[k] = (x[b] - x[a]) / (time[b] - time[a]);
    }
    return v;
}

struct Body {
    double inertia = 1, position = 0, velocity = 0;
    SimulatorFriction friction;

    void step(double force, double h)
    {
        const double held = inertia + h * friction.viscous;
        const double free = velocity + h * (force - friction.viscous * velocity) / held;
        const double most = h * friction.coulomb / held;
        velocity = std::copysign(std::max(0.0, std::abs(free) - most), free);
        position += h * velocity;
    }
};

/// Motor and link, or one body that is both.
class Bodies {
  public:
    Bodies(const ExportAnswer& a, double start) : joint_(a.joint)
    {
        // only MJCF has the spring; two hinges with stops stand in URDF and SDF for backlash, and their stops, as stiff
        // as the engine makes them, count here as stiff as the transmission
        const bool stops = joint_.backlash > 0 && (a.to == Simulator::urdf || a.to == Simulator::sdf);
        apart_ = joint_.two_bodies() && std::isfinite(joint_.stiffness) && (a.to == Simulator::mjcf || stops);
        SimulatorFriction motor = joint_.motor;
        motor.viscous += joint_.back_emf;
        link_ = {apart_ ? joint_.link_inertia : joint_.inertia(), start, 0, apart_ ? joint_.link : joint_.friction()};
        motor_ = {joint_.armature, start, 0, motor};
    }
    const Body& measured() const { return apart_ && !joint_.feedback_link ? motor_ : link_; }
    /// `inertia` of the link in this step, armature apart; not set: as exported.
    void step(double effort, double load, double inertia, double h)
    {
        if (is_set(inertia)) link_.inertia = apart_ ? inertia : inertia + joint_.armature;
        const double pull = load - joint_.gravity_amplitude * std::sin(link_.position + joint_.gravity_phase);
        if (!apart_) return link_.step(effort + pull, h);
        const double twist = motor_.position - link_.position, half = joint_.backlash / 2;
        const double stretch = std::abs(twist) > half ? twist - std::copysign(half, twist) : 0;
        const double carried = joint_.stiffness * stretch + joint_.damping * (motor_.velocity - link_.velocity);
        motor_.step(effort - carried, h);
        link_.step(carried + pull, h);
    }

  private:
    SimulatorJoint joint_;
    bool apart_ = false;
    Body motor_, link_;
};

}  // namespace

SimulatorRun run_in_simulator(const ExportAnswer& answer, const Record& r, double scale)
{
    const SimulatorJoint& s = answer.joint;
    const bool integrates = answer.to == Simulator::sdf || answer.to == Simulator::urdf;  // of a URDF its user's loop
    const auto rate = r.reference_velocity.empty() ? slopes(r.time, r.reference_position) : r.reference_velocity;
    Signal reference(r.time, r.reference_position), velocity(r.time, rate), load(r.time, r.load_effort),
        inertia(r.time, r.inertia), enabled(r.time, r.torque_enable);
    Bodies bodies(answer, r.position.front() / scale);
    SimulatorRun run;
    const double h = answer.timestep, start = r.time.front();
    const double held_back = delays_target(answer.to) ? answer.delay_steps * h : 0;
    double integral = 0;
    for (std::size_t k = 0; run.position.size() < r.rows(); ++k) {
        const double t = start + static_cast<double>(k) * h;
        const Body before = bodies.measured();
        const double error = reference.at(t - held_back) / scale - before.position;
        const double wanted = s.reference_velocity ? velocity.at(t - held_back) / scale : 0;
        if (integrates) integral += s.k_i * error * h;
        double effort = s.k_p * error + s.k_v * (wanted - before.velocity) + integral;
        effort = std::clamp(effort, -s.effort_limit, s.effort_limit);
        const bool on = !enabled.known() || enabled.at(t) > 0.5;
        bodies.step(on ? effort : 0, load.known() ? load.at(t) : 0, inertia.known() ? inertia.at(t) : not_set, h);
        while (run.position.size() < r.rows() && r.time[run.position.size()] < t + h * (1 - 1e-9)) {
            const double part = (r.time[run.position.size()] - t) / h;
            run.position.push_back(scale * std::lerp(before.position, bodies.measured().position, part));
            run.effort.push_back(effort);
        }
    }
    return run;
}

}  // namespace stickslip
