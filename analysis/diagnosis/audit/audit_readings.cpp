#include "analysis/diagnosis/audit/audit_readings.h"

#include "analysis/diagnosis/audit/regression.h"
#include "analysis/diagnosis/plant/controller.h"
#include "analysis/diagnosis/policy/audit.h"
#include "analysis/diagnosis/policy/records.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {

void audit_grid(std::vector<Case>& cases, Audit& result)
{
    double quantum = infinity;
    for (const auto& c : cases) {
        std::vector<double> readings;
        for (std::size_t k = 0; k < c.ticks.size(); ++k)
            if (c.ticks.logged[k]) readings.push_back(c.ticks.position[k]);
        quantum = std::min(quantum, grid_of(readings));
    }
    const Sensor documented = cases[0].joint.sensor;
    const bool coarser = quantum < infinity && coarser_grid(quantum, documented);
    if (!coarser) return;
    if (!cases[0].noise_documented) {
        // without a documented sensor a fine or a round grid may be nothing but the digits of the file
        constexpr double visible = 1e-3, round = 1e-3;  // numerical: of the span; of the digit
        double span = 0;
        for (const auto& c : cases) {
            const auto [low, high] = std::minmax_element(c.ticks.position.begin(), c.ticks.position.end());
            span = std::max(span, *high - *low);
        }
        const double digit = quantum / std::pow(10, std::floor(std::log10(quantum) + round));
        const bool decimal = std::min({std::abs(digit - 1), std::abs(digit - 2), std::abs(digit - 5)}) < round * digit;
        if (decimal || quantum < visible * span) return;
    }
    result.findings.push_back({"quantisation", "quantisation.quantum", quantum, 0, Quantity::position, 1});
    for (auto& c : cases) {
        c.joint.sensor.encoder_quantum = quantum;
        c.sigma = std::max(c.sigma, std::hypot(documented.position_noise, quantum / std::sqrt(12.0)));
    }
}

namespace {

/// A source's resistance and open-circuit voltages, from the voltages beside the motor's currents.
class SupplyLine {
  public:
    /// Of one record: its source may have another open-circuit voltage.
    void add(const std::vector<double>& voltage, const std::vector<double>& current)
    {
        const double n = static_cast<double>(voltage.size());
        Means m;
        for (std::size_t k = 0; k < voltage.size(); ++k) m.voltage += voltage[k] / n, m.current += current[k] / n;
        for (std::size_t k = 0; k < voltage.size(); ++k) {
            const double v = voltage[k] - m.voltage, i = current[k] - m.current;
            voltage_current_ += v * i, current_current_ += i * i, voltage_voltage_ += v * v;
        }
        records_.push_back(m);
    }

    double resistance() const { return -voltage_current_ / current_current_; }
    double open_voltage(std::size_t record) const
    {
        return records_[record].voltage + resistance() * records_[record].current;
    }
    /// Part of the squares of the voltage's changes that the current explains; 0 where it does not change.
    double explained() const
    {
        const double squares = current_current_ * voltage_voltage_;
        return squares > 0 ? voltage_current_ * voltage_current_ / squares : 0;
    }

  private:
    struct Means {
        double voltage = 0, current = 0;
    };
    double voltage_current_ = 0, current_current_ = 0, voltage_voltage_ = 0;
    std::vector<Means> records_;
};

}  // namespace

void audit_supply(std::vector<Case>& cases, Audit& result)
{
    SupplyLine line;
    for (const auto& c : cases) {
        const Actuator& a = c.joint.actuator;
        if (a.kind != ActuatorKind::dc_motor || !is_set(a.supply_voltage) || !c.supply_logged) return;
        Innovation innovation;
        const Plant plant = flatten(c.joint);
        predict(plant, c.ticks, known_command(plant, c.ticks), levels[1], innovation);
        std::vector<double> voltage, current;
        for (std::size_t k = 0; k < c.ticks.size(); ++k) {
            if (!c.ticks.logged[k] || !c.ticks.enabled[k]) continue;
            const double effort = is_set(c.ticks.effort[k]) ? c.ticks.effort[k] : innovation.predicted_effort[k];
            voltage.push_back(c.ticks.supply[k]);
            current.push_back(std::abs(effort / (a.effort_gain * a.k_t)));
        }
        line.add(voltage, current);
    }
    if (line.explained() < policy::supply_follows || line.resistance() <= 0) return;
    const double resistance = line.resistance();
    result.findings.push_back(
        {"supply-sag", "supply-sag.resistance", resistance, 0, Quantity::resistance, line.explained()});
    for (std::size_t i = 0; i < cases.size(); ++i) {
        auto& c = cases[i];
        c.joint.actuator.supply_resistance += resistance;
        c.ticks.supply.assign(c.ticks.size(), line.open_voltage(i));
    }
}

double command_rounding(const std::vector<Case>& cases)
{
    double largest = 0;
    for (const auto& c : cases) {
        double square = 0, n = 0;
        for (double u : c.ticks.command)
            if (is_set(u)) square += u * u, n += 1;
        if (square > 0) largest = std::max(largest, command_step(c.ticks) / std::sqrt(square / n));
    }
    return largest;
}

double observed_limit(const std::vector<Case>& cases)
{
    double highest = 0;
    for (const auto& c : cases)
        for (double u : c.ticks.command)
            if (is_set(u)) highest = std::max(highest, std::abs(u));
    int at = 0;
    for (const auto& c : cases)
        for (double u : c.ticks.command) at += is_set(u) && std::abs(u) > (1 - 1e-9) * highest;
    return at >= 10 ? highest : infinity;
}

bool coarser_grid(double quantum, const Sensor& documented)
{
    return quantum > policy::coarser_grid * documented.encoder_quantum &&
           quantum > policy::grid_over_noise * documented.position_noise;
}

double grid_of(const std::vector<double>& readings)
{
    constexpr double rounding = 1e-9;            // numerical: of the span: equal readings
    constexpr double near = 0.1, beside = 0.05;  // numerical: of a step: refines it; a reading that is not on the grid
    std::vector<double> sorted = readings;
    std::sort(sorted.begin(), sorted.end());
    if (sorted.empty()) return 0;
    const double span = sorted.back() - sorted.front();
    double least = infinity;
    for (std::size_t k = 1; k < sorted.size(); ++k)
        if (const double d = sorted[k] - sorted[k - 1]; d > rounding * span) least = std::min(least, d);
    if (least == infinity) return 0;
    // refine the step by the farthest reading it can count to
    double step = least;
    for (std::size_t k = 0; k < sorted.size(); ++k) {
        const double count = std::round((sorted[k] - sorted.front()) / step);
        if (count > 0 && std::abs(sorted[k] - sorted.front() - count * step) < near * step)
            step = (sorted[k] - sorted.front()) / count;
    }
    std::size_t off = 0;
    for (double y : sorted) {
        const double count = (y - sorted.front()) / step;
        off += std::abs(count - std::round(count)) > beside;
    }
    return off * 1000 < sorted.size() ? step : 0;
}

double command_step(const Ticks& ticks)
{
    std::vector<double> logged;
    for (std::size_t k = 0; k < ticks.size(); ++k)
        if (ticks.logged[k] && is_set(ticks.command[k])) logged.push_back(ticks.command[k]);
    return grid_of(logged);
}

}  // namespace stickslip::gap
