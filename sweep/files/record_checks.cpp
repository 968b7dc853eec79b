#include "sweep/files/record_checks.h"

#include "sweep/files/toml_input.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip::files {
namespace {

constexpr double degrees = 180 / std::numbers::pi;
constexpr double near_factor = 1.3;                  // two signals that agree up to noise and lag stay within this
constexpr double many_turns = 4 * std::numbers::pi;  // two turns of a joint: more is a wheel, or degrees
constexpr double long_axis = 10;                     // m; more is a crane, or millimetres

/// Standard deviation of the values that are there.
double spread(const std::vector<double>& values)
{
    double sum = 0, squares = 0, n = 0;
    for (double v : values) {
        if (std::isnan(v)) continue;
        sum += v;
        squares += v * v;
        ++n;
    }
    return n > 1 ? std::sqrt(std::max(0.0, squares / n - sum / n * (sum / n))) : 0;
}

/// The factor of a wrong unit that the ratio comes close to, or 0.
double wrong_factor(double ratio, Motion motion)
{
    const double unit = motion == Motion::revolute ? degrees : 1000;
    for (const double factor : {unit, 1 / unit})
        if (ratio > factor / near_factor && ratio < factor * near_factor) return factor;
    return 0;
}

std::vector<double> differentiated(const Record& r)
{
    std::vector<double> rate;
    for (std::size_t k = 1; k + 1 < r.position.size(); ++k)
        rate.push_back((r.position[k + 1] - r.position[k - 1]) / (r.time[k + 1] - r.time[k - 1]));
    return rate;
}

class Checks {
  public:
    Checks(const Record& record, const Joint& joint) : r_(record), joint_(joint), motion_(joint.mechanism.motion) {}

    std::vector<Suspicion> all()
    {
        compare("reference_position", spread(r_.reference_position), "position", spread(r_.position));
        compare("link_position", spread(r_.link_position), "position", spread(r_.position));
        if (!r_.velocity.empty())
            compare("velocity", spread(r_.velocity), "the rate of position", spread(differentiated(r_)));
        command();
        travel();
        clock();
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
                              number_text(std::round(10 * std::max(spread_a / spread_b, spread_b / spread_a)) / 10) +
                              " times as far as " + (factor > 1 ? b : a) + "; [record] can name the unit",
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
            if (!std::isfinite(u) || !std::isfinite(r_.effort_command[k])) continue;
            together += u * r_.effort_command[k], squares += u * u,
                command += r_.effort_command[k] * r_.effort_command[k];
        }
        if (!(squares > 0) || !(command > 0)) return;
        const double ratio = squares / together, alike = together / std::sqrt(squares * command);
        constexpr double surely = 0.9;  // correlation
        if (alike > surely && ratio > 1 && wrong_factor(ratio, motion_) != 0)
            found_.push_back({"suspected " + std::string(foreign_unit()) +
                                  ": with the gains of the joint the logged motion "
                                  "asks for " +
                                  number_text(std::round(10 * ratio) / 10) +
                                  " times the logged command; [record] can name the unit",
                              true});
    }

    void travel()
    {
        if (r_.position.empty() || !found_.empty()) return;
        double low = infinity, high = -infinity;
        for (double q : r_.position) {
            if (q < low) low = q;
            if (q > high) high = q;
        }
        const double travel = high - low, limit = motion_ == Motion::revolute ? many_turns : long_axis;
        if (travel > limit)
            found_.push_back({"suspected " + std::string(foreign_unit()) + ": position travels " + number_text(travel) +
                                  " " + std::string(unit_of(Quantity::position, motion_)) +
                                  "; [record] can name the unit",
                              false});
    }

    void clock()
    {
        const double period = joint_.control.period;
        if (!is_set(period) || r_.time.size() < 3) return;
        std::vector<double> steps;
        for (std::size_t k = 1; k < r_.time.size(); ++k) steps.push_back(r_.time[k] - r_.time[k - 1]);
        std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
        const double ratio = steps[steps.size() / 2] / period;
        for (const auto& [factor, unit] : {std::pair{1e3, "milliseconds"}, {1e6, "microseconds"}})
            if (ratio > factor / near_factor && ratio < factor * near_factor)
                found_.push_back({std::string("suspected ") + unit + ": rows are " +
                                      number_text(steps[steps.size() / 2]) + " s apart, control.period is " +
                                      number_text(period) + " s; [record] can name the unit",
                                  true});
    }

    const Record& r_;
    const Joint& joint_;
    Motion motion_;
    std::vector<Suspicion> found_;
};

}  // namespace

std::vector<Suspicion> suspicions(const Record& record, const Joint& joint)
{
    std::vector<Suspicion> found = Checks(record, joint).all();
    const auto off = std::count(record.torque_enable.begin(), record.torque_enable.end(), 0.0);
    if (off > 0)
        found.push_back({std::to_string(off) + " of " + std::to_string(record.rows()) +
                             " rows have torque_enable = 0: the motor was off",
                         false});
    return found;
}

}  // namespace stickslip::files
