#include "sweep/files/records/record_checks.h"

#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/records/ticks.h"
#include "analysis/numerics/statistics.h"
#include "sweep/files/records/signal_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip::files {
namespace {

constexpr double many_turns = 4 * std::numbers::pi;  // two turns of a joint: more is a wheel, or degrees
constexpr double another_rate = 3;  // between a rate and what it is the rate of; a filter makes no such factor
constexpr double long_axis = 10;    // m; more is a crane, or millimetres

double largest_size(const std::vector<double>& values)
{
    double largest = 0;
    for (const double v : values) largest = std::isfinite(v) ? std::max(largest, std::abs(v)) : largest;
    return largest;
}

class Checks {
  public:
    Checks(const Record& record, const Joint& joint, bool unit_named)
        : r_(record), joint_(joint), motion_(joint.mechanism.motion), unit_named_(unit_named)
    {
    }

    std::vector<Note> all()
    {
        clock();
        if (!found_.empty()) return std::move(found_);  // every rate would be wrong, too
        compare("reference_position", spread(r_.reference_position), "position", spread(r_.position));
        compare("link_position", spread(r_.link_position), "position", spread(r_.position));
        const auto rate = differentiated(r_.time, r_.position);
        const auto reference_rate = differentiated(r_.time, r_.reference_position);
        compare("velocity", spread(r_.velocity), "position_rate", spread(rate));
        if (found_.empty())  // turns a minute, a tenth of that, motor beside joint: any factor
            disproportion(size_of_rate(r_.time, r_.position, r_.velocity), another_rate,
                          {.code = Note::Code::unit_of_rate, .names = {"velocity", "position_rate"}});
        reference_unit(reference_rate);
        // a joint that follows badly may lag by half a period, a rate is rough with noise
        constexpr double follows = -0.9, is_the_same = -0.5;
        if (found_.empty()) direction("position", r_.position, "reference_position", r_.reference_position, follows);
        direction("velocity", r_.velocity, "position_rate", rate, is_the_same);
        direction("reference_velocity", r_.reference_velocity, "reference_position_rate", reference_rate, is_the_same);
        command();
        effort();
        dead_signals();
        travel();
        return std::move(found_);
    }

  private:
    const char* foreign_unit() const { return motion_ == Motion::revolute ? "degrees" : "millimetres"; }

    void compare(const std::string& a, double spread_a, const std::string& b, double spread_b)
    {
        if (spread_a == 0 || spread_b == 0) return;
        const double factor = wrong_factor(spread_a / spread_b, motion_);
        if (factor == 0) return;
        found_.push_back({.code = Note::Code::unit_between_signals,
                          .names = {foreign_unit(), factor > 1 ? a : b, factor > 1 ? b : a},
                          .values = {std::max(spread_a / spread_b, spread_b / spread_a)}});
    }

    /// The logged command against what the documented gains make of the logged motion: all motion in a foreign unit.
    void command()
    {
        const auto& c = joint_.control;
        if (!found_.empty() || r_.effort_command.empty() || r_.reference_position.empty() || r_.position.empty())
            return;
        const bool rates = !r_.velocity.empty() && (!c.reference_velocity || !r_.reference_velocity.empty());
        if (c.k_v != 0 && !rates) return;
        // a limit, documented or not, hides how much was asked for
        constexpr double at_limit = 0.99;
        const double limit = at_limit * largest_size(r_.effort_command);
        std::size_t rows = 0;
        double together = 0, squares = 0, command = 0;
        for (std::size_t k = 0; k < r_.rows(); ++k) {
            double u = c.k_p * (r_.reference_position[k] - r_.position[k]);
            if (c.k_v != 0) u += c.k_v * ((c.reference_velocity ? r_.reference_velocity[k] : 0.0) - r_.velocity[k]);
            if (!r_.feed_forward.empty()) u += r_.feed_forward[k];
            if (!std::isfinite(u) || !(std::abs(r_.effort_command[k]) < limit)) continue;
            ++rows;
            together += u * r_.effort_command[k], squares += u * u,
                command += r_.effort_command[k] * r_.effort_command[k];
        }
        constexpr std::size_t few = 20;  // as many say nothing of the rest
        if (rows < few || !(squares > 0) || !(command > 0)) return;
        const double ratio = squares / together, alike = together / std::sqrt(squares * command);
        constexpr double surely = 0.9;       // correlation; with less the gains do not say what moved
        constexpr double another_joint = 4;  // no gain of the same controller is documented as wrong as that
        command_explained_ = alike > surely && ratio < near_factor && ratio > 1 / near_factor;
        if (std::abs(alike) < surely) return;
        if (alike < 0)
            found_.push_back({.code = Note::Code::sign_by_gains});
        else if (ratio > 1 && wrong_factor(ratio, motion_) != 0)
            found_.push_back({.code = Note::Code::unit_by_gains, .names = {foreign_unit()}, .values = {ratio}});
        else if (ratio > another_joint || ratio < 1 / another_joint)
            found_.push_back({.code = Note::Code::gains_of_another_joint, .values = {ratio}});
    }

    /// A signal that runs against what it should follow.
    void direction(const std::string& a, const std::vector<double>& values, const std::string& b,
                   const std::vector<double>& others, double surely)
    {
        constexpr double rounding = 1e-6;  // of its size: what spreads less stands still, and has no direction
        const auto stands = [](const auto& v) { return spread(v) <= rounding * largest_size(v); };
        if (stands(values) || stands(others)) return;
        if (correlation(values, others) < surely)
            found_.push_back({.code = Note::Code::opposite_signs, .names = {a, b}});
    }

    /// A reference has no noise: where it moves, it and its rate agree. Steps are no part of the rate, so medians.
    void reference_unit(const std::vector<double>& rate)
    {
        std::vector<double> given, expected;
        for (std::size_t k = 0; k < std::min(rate.size(), r_.reference_velocity.size()); ++k)
            if (std::isfinite(rate[k]) && std::isfinite(r_.reference_velocity[k]) && r_.reference_velocity[k] != 0)
                given.push_back(std::abs(r_.reference_velocity[k])), expected.push_back(std::abs(rate[k]));
        constexpr std::size_t few = 20;  // rows: a median of fewer is one stretch of the motion
        if (given.size() < few) return;
        disproportion(median(given) / median(expected), another_rate,
                      {.code = Note::Code::unit_of_rate, .names = {"reference_velocity", "reference_position_rate"}});
    }

    /// Two sizes that no wrong number of the joint could set so far apart.
    void disproportion(double ratio, double most, Note what)
    {
        if (!std::isfinite(ratio) || ratio <= 0 || (ratio <= most && ratio >= 1 / most)) return;
        what.values = {ratio};
        found_.push_back(std::move(what));
    }

    /// The measured effort against its command.
    void effort()
    {
        if (joint_.actuator.kind != ActuatorKind::effort || r_.effort_measured.empty()) return;
        std::vector<double> asked = r_.effort_command;
        for (double& u : asked) u *= joint_.actuator.effort_gain;
        // a constant command varies by its rounding at most, and nothing follows that
        constexpr double constant = 1e-3;  // of its size
        if (spread(asked) <= constant * largest_size(asked)) return;
        constexpr double opposite = -0.5;  // a lagging or noisy effort comes to nothing, not to the opposite
        direction("effort_measured", r_.effort_measured, "effort_command", asked, opposite);
        // no gain is as wrong as the first; a copy of the command in every row is no measured effort of its own, and
        // wrong by more than a gain can be (effort-gain) it is in another unit
        constexpr double another_unit = 100, copied = 0.999, unit_of_copy = 5;
        const bool copy = correlation(r_.effort_measured, asked) > copied;
        disproportion(spread(r_.effort_measured) / spread(asked), copy ? unit_of_copy : another_unit,
                      {.code = Note::Code::unit_of_effort});
    }

    /// A signal that stays at one value although the joint moves was not connected.
    void dead_signals()
    {
        if (r_.position.empty() || spread(r_.position) == 0) return;
        constexpr std::size_t few = 20;  // rows: a slow signal may stay for fewer
        const auto dead = [&](const char* name, const std::vector<double>& values) {
            if (values.size() < few || !std::isfinite(values[0]) || spread(values) > 1e-12 * std::abs(values[0]))
                return;
            found_.push_back({.code = Note::Code::dead_signal, .names = {name}, .values = {values[0]}});
        };
        dead("velocity", r_.velocity);
        dead("effort_measured", r_.effort_measured);
        dead("current", r_.current);
        dead("link_position", r_.link_position);
        // a constant command moves a joint, too; not one whose controller follows a reference
        if (spread(r_.reference_position) > 0 && joint_.control.k_p != 0) {
            dead("effort_command", r_.effort_command);
            dead("drive", r_.drive);
        }
    }

    /// An encoder on the motor turns as many times farther as the reduction says.
    double motor_per_joint() const
    {
        const bool on_motor = joint_.mechanism.model == Model::two_mass && joint_.control.feedback == Feedback::motor;
        return on_motor ? std::max(1.0, joint_.mechanism.transmission.ratio) : 1;
    }

    void travel()
    {
        if (r_.position.empty() || !found_.empty()) return;
        double low = infinity, high = -infinity;
        for (double q : r_.position) {
            if (q < low) low = q;
            if (q > high) high = q;
        }
        const double travel = high - low,
                     limit = (motion_ == Motion::revolute ? many_turns : long_axis) * motor_per_joint();
        // degrees and radians alike make a motion that a joint can be fitted to; only someone who knows can tell
        const std::string unit(unit_of(Quantity::position, Units(motion_)));
        if (travel > limit && !unit_named_ && !command_explained_)
            found_.push_back({.code = Note::Code::unit_by_travel,
                              .names = {foreign_unit(), motion_ == Motion::revolute ? "deg" : "mm", unit},
                              .values = {travel}});
    }

    void clock()
    {
        const double period = joint_.control.period;
        if (!is_set(period) || r_.time.size() < 3) return;
        const double step = gap::median_step(r_.time), ratio = step / period;
        constexpr double slowest_log = 1e3 / near_factor;  // ticks a row; who logs as seldom sees no friction
        if (ratio < slowest_log) return;
        Note clock{.code = Note::Code::unit_of_clock, .values = {step, period}};
        for (const auto& [factor, name] : {std::pair{1e3, "milliseconds"}, {1e6, "microseconds"}, {1e9, "nanoseconds"}})
            if (ratio > factor / near_factor && ratio < factor * near_factor) clock.names = {name};
        found_.push_back(std::move(clock));
    }

    const Record& r_;
    const Joint& joint_;
    Motion motion_;
    bool unit_named_ = false;
    bool command_explained_ = false;  ///< by the documented gains, in the documented units
    std::vector<Note> found_;
};

}  // namespace

std::vector<Note> suspicions(const Record& record, const Joint& joint, bool unit_named)
{
    const Joint here = gap::joint_in(record, joint);
    auto found = Checks(record, here, unit_named).all();
    const auto off = std::count(record.torque_enable.begin(), record.torque_enable.end(), 0.0);
    if (off > 0)
        found.push_back(
            {.code = Note::Code::motor_off, .values = {static_cast<double>(off), static_cast<double>(record.rows())}});
    return found;
}

}  // namespace stickslip::files
