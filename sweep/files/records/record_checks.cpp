#include "sweep/files/records/record_checks.h"

#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/records/ticks.h"
#include "analysis/numerics/statistics.h"
#include "sweep/files/records/signal_measures.h"
#include "sweep/files/text/toml_input.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip::files {
namespace {

constexpr double many_turns = 4 * std::numbers::pi;  // two turns of a joint: more is a wheel, or degrees
constexpr double another_rate = 3;  // between a rate and what it is the rate of; a filter makes no such factor
constexpr double long_axis = 10;    // m; more is a crane, or millimetres

class Checks {
  public:
    Checks(const Record& record, const Joint& joint, bool unit_named)
        : r_(record), joint_(joint), motion_(joint.mechanism.motion), unit_named_(unit_named)
    {
    }

    std::vector<Suspicion> all()
    {
        clock();
        if (!found_.empty()) return std::move(found_);  // every rate would be wrong, too
        compare("reference_position", spread(r_.reference_position), "position", spread(r_.position));
        compare("link_position", spread(r_.link_position), "position", spread(r_.position));
        const auto rate = differentiated(r_.time, r_.position);
        const auto reference_rate = differentiated(r_.time, r_.reference_position);
        compare("velocity", spread(r_.velocity), "the rate of position", spread(rate));
        if (found_.empty())  // turns a minute, a tenth of that, motor beside joint: any factor
            disproportion(size_of_rate(r_.time, r_.position, r_.velocity), another_rate, "velocity is", " times",
                          " the rate of position");
        reference_unit(reference_rate);
        // a joint that follows badly may lag by half a period, a rate is rough with noise
        constexpr double follows = -0.9, is_the_same = -0.5;
        if (found_.empty()) direction("position", r_.position, "reference_position", r_.reference_position, follows);
        direction("velocity", r_.velocity, "the rate of position", rate, is_the_same);
        direction("reference_velocity", r_.reference_velocity, "the rate of reference_position", reference_rate,
                  is_the_same);
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
        const std::string& larger = factor > 1 ? a : b;
        found_.push_back({"suspected " + std::string(foreign_unit()) + ": " + larger + " moves " +
                              rounded(std::max(spread_a / spread_b, spread_b / spread_a)) + " times as far as " +
                              (factor > 1 ? b : a) + "; [record] can name the unit",
                          true});
    }

    /// The logged command against what the documented gains make of the logged motion: all motion in a foreign unit.
    void command()
    {
        const auto& c = joint_.control;
        if (!found_.empty() || r_.effort_command.empty() || r_.reference_position.empty() || r_.position.empty())
            return;
        const bool rates = !r_.velocity.empty() && (!c.reference_velocity || !r_.reference_velocity.empty());
        if (c.k_v != 0 && !rates) return;
        double together = 0, squares = 0, command = 0;
        for (std::size_t k = 0; k < r_.rows(); ++k) {
            double u = c.k_p * (r_.reference_position[k] - r_.position[k]);
            if (c.k_v != 0) u += c.k_v * ((c.reference_velocity ? r_.reference_velocity[k] : 0.0) - r_.velocity[k]);
            if (!r_.feed_forward.empty()) u += r_.feed_forward[k];
            if (!std::isfinite(u) || !std::isfinite(r_.effort_command[k])) continue;
            together += u * r_.effort_command[k], squares += u * u,
                command += r_.effort_command[k] * r_.effort_command[k];
        }
        if (!(squares > 0) || !(command > 0)) return;
        const double ratio = squares / together, alike = together / std::sqrt(squares * command);
        constexpr double surely = 0.9;       // correlation; with less the gains do not say what moved
        constexpr double another_joint = 4;  // no gain of the same controller is documented as wrong as that
        command_explained_ = alike > surely && ratio < near_factor && ratio > 1 / near_factor;
        if (std::abs(alike) < surely) return;
        const std::string times = rounded(std::max(std::abs(ratio), 1 / std::abs(ratio)));
        if (alike < 0)
            found_.push_back(
                {"suspected sign: with the gains of the joint the logged motion requires the opposite of the "
                 "logged command; scale = -1 under [record.columns] turns a signal round",
                 true});
        else if (ratio > 1 && wrong_factor(ratio, motion_) != 0)
            found_.push_back({"suspected " + std::string(foreign_unit()) +
                                  ": with the gains of the joint the logged motion requires " + times +
                                  " times the logged command; [record] can name the unit",
                              true});
        else if (ratio > another_joint || ratio < 1 / another_joint)
            found_.push_back(
                {"suspected record of another joint: with the gains of the joint the logged motion requires " + times +
                     (ratio > 1 ? " times" : " times less than") +
                     " the logged command; per record, [record.files] can give other gains",
                 true});
    }

    /// A signal that runs against what it should follow.
    void direction(const std::string& a, const std::vector<double>& values, const std::string& b,
                   const std::vector<double>& others, double surely)
    {
        if (correlation(values, others) < surely)
            found_.push_back({"suspected sign: " + a + " runs against " + b +
                                  "; scale = -1 under [record.columns] turns a signal round",
                              true});
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
        disproportion(median(given) / median(expected), another_rate, "reference_velocity is", " times",
                      " the rate of reference_position");
    }

    /// Two sizes that no wrong number of the joint could set so far apart.
    void disproportion(double ratio, double most, const std::string& what, const std::string& more,
                       const std::string& than)
    {
        if (!std::isfinite(ratio) || ratio <= 0 || (ratio <= most && ratio >= 1 / most)) return;
        found_.push_back({"suspected unit: " + what + " " + rounded(std::max(ratio, 1 / ratio)) +
                              (ratio > 1 ? more : " times less than") + than + "; [record] can name the unit",
                          true});
    }

    /// The measured effort against its command.
    void effort()
    {
        if (joint_.actuator.kind != ActuatorKind::effort || r_.effort_measured.empty()) return;
        std::vector<double> asked = r_.effort_command;
        double largest = 0;
        for (double& u : asked) u *= joint_.actuator.effort_gain, largest = std::max(largest, std::abs(u));
        // a constant command varies by its rounding at most, and nothing follows that
        constexpr double constant = 1e-3;  // of its size
        if (spread(asked) <= constant * largest) return;
        constexpr double opposite = -0.5;  // a lagging or noisy effort comes to nothing, not to the opposite
        direction("effort_measured", r_.effort_measured, "effort_command", asked, opposite);
        constexpr double another_unit = 100;  // no gain is as wrong as that
        disproportion(spread(r_.effort_measured) / spread(asked), another_unit, "effort_measured varies by",
                      " times as much as", " the command requires");
    }

    /// A signal that stays at one value although the joint moves was not connected.
    void dead_signals()
    {
        if (r_.position.empty() || spread(r_.position) == 0) return;
        constexpr std::size_t few = 20;  // rows: a slow signal may stay for fewer
        const auto dead = [&](const char* name, const std::vector<double>& values) {
            if (values.size() < few || !std::isfinite(values[0]) || spread(values) > 1e-12 * std::abs(values[0]))
                return;
            found_.push_back({std::string(name) + " stays at " + number_text(values[0]) +
                                  " while position moves: remove the column if it was not connected",
                              true});
        };
        dead("velocity", r_.velocity);
        dead("effort_measured", r_.effort_measured);
        dead("current", r_.current);
        dead("link_position", r_.link_position);
        // a constant command moves a joint, too; not one whose controller follows a reference
        if (spread(r_.reference_position) > 0 && joint_.control.k_p != 0) {
            dead("effort_command", r_.effort_command);
            dead("the drive signal", r_.drive);
        }
    }

    /// An encoder on the motor turns as many times farther as the reduction says.
    double motor_per_joint() const
    {
        const bool on_motor = joint_.mechanism.model == Model::two_mass && joint_.control.feedback == Feedback::motor;
        return on_motor ? std::max(1.0, joint_.mechanism.transmission.ratio) : 1;
    }

    static std::string rounded(double value) { return number_text(std::round(10 * value) / 10); }

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
            found_.push_back({"suspected " + std::string(foreign_unit()) + ": position travels " + rounded(travel) +
                                  " " + unit + "; position = { unit = \"" +
                                  (motion_ == Motion::revolute ? "deg" : "mm") +
                                  "\" } under [record.columns] says so, unit = \"" + unit + "\" that it is right",
                              true});
    }

    void clock()
    {
        const double period = joint_.control.period;
        if (!is_set(period) || r_.time.size() < 3) return;
        const double step = gap::median_step(r_.time), ratio = step / period;
        constexpr double slowest_log = 1e3 / near_factor;  // ticks a row; who logs as seldom sees no friction
        if (ratio < slowest_log) return;
        std::string unit = "another unit of time than seconds";
        for (const auto& [factor, name] : {std::pair{1e3, "milliseconds"}, {1e6, "microseconds"}, {1e9, "nanoseconds"}})
            if (ratio > factor / near_factor && ratio < factor * near_factor) unit = name;
        found_.push_back({"suspected " + unit + ": rows are " + number_text(step) + " s apart, control.period is " +
                              number_text(period) + " s; [record] can name the unit",
                          true});
    }

    const Record& r_;
    const Joint& joint_;
    Motion motion_;
    bool unit_named_ = false;
    bool command_explained_ = false;  ///< by the documented gains, in the documented units
    std::vector<Suspicion> found_;
};

}  // namespace

std::vector<Suspicion> suspicions(const Record& record, const Joint& joint, bool unit_named)
{
    const Joint here = gap::joint_in(record, joint);
    std::vector<Suspicion> found = Checks(record, here, unit_named).all();
    const auto off = std::count(record.torque_enable.begin(), record.torque_enable.end(), 0.0);
    if (off > 0)
        found.push_back({std::to_string(off) + " of " + std::to_string(record.rows()) +
                             " rows have torque_enable = 0: the motor was off",
                         false});
    return found;
}

}  // namespace stickslip::files
