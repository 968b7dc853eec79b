#include "tests/blind/generate/mimic.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace blind {
namespace {

/// Small changes of one number each; their motions span what simple effects can explain.
std::vector<std::function<void(Machine&)>> simple_changes(const Nominal& n)
{
    const double force = 0.1 * n.coulomb(), slope = force / n.speed, inertia = 0.05 * n.inertia();
    std::vector<std::function<void(Machine&)>> list = {
        [=](Machine& m) { m.mechanism.friction[0].coulomb += force; },
        [=](Machine& m) { m.mechanism.friction[0].viscous += slope; },
        [=](Machine& m) { m.mechanism.friction[0].uneven_viscous += slope; },
        [=](Machine& m) { m.mechanism.constant_load += force; },
        [=](Machine& m) { m.mechanism.inertia[m.mechanism.bodies - 1] += inertia; },
        [=](Machine& m) { m.mechanism.friction[0].load_share += 0.02; },
    };
    if (n.machine.revolute) list.push_back([=](Machine& m) { m.mechanism.gravity += force; });
    return list;
}

/// Every compared signal of every record in one row, in floors, without noise.
std::vector<double> motion(const Setting& s, std::vector<Machine> machines, const std::vector<double>& floors)
{
    std::vector<double> row;
    for (std::size_t r = 0; r < machines.size(); ++r) {
        machines[r].sensors.position_noise = machines[r].sensors.effort_noise = machines[r].sensors.quantum = 0;
        const Record record = run_loop(machines[r], s.excitations[r], 0, s.stride);
        for (std::size_t i = 0; i < s.signals.size(); ++i)
            for (double x : record.*s.signals[i].values) row.push_back(x / floors[i]);
    }
    return row;
}

double dot(const std::vector<double>& a, const std::vector<double>& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

}  // namespace

double explained_by_catalogue(const Setting& s, const std::vector<Machine>& truth)
{
    std::vector<double> floors;
    for (const auto& signal : closed_loop_gap(s.record(s.machines), s.ensemble, {}, s.signals).signals)
        floors.push_back(signal.floor);
    const auto nominal = motion(s, s.machines, floors);
    const auto from_nominal = [&](const std::vector<Machine>& machines) {
        auto row = motion(s, machines, floors);
        for (std::size_t i = 0; i < row.size(); ++i) row[i] -= nominal[i];
        return row;
    };
    auto rest = from_nominal(truth);
    const double whole = dot(rest, rest);
    // Gram–Schmidt: each direction takes from the rest what it explains beyond the ones before.
    std::vector<std::vector<double>> basis;
    for (const auto& change : simple_changes(s.nominal)) {
        auto machines = s.machines;
        for (auto& m : machines) change(m);
        auto row = from_nominal(machines);
        for (const auto& b : basis) {
            const double along = dot(row, b);
            for (std::size_t i = 0; i < row.size(); ++i) row[i] -= along * b[i];
        }
        const double norm = std::sqrt(dot(row, row));
        if (!(norm > 0)) continue;
        for (double& x : row) x /= norm;
        const double along = dot(rest, row);
        for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= along * row[i];
        basis.push_back(std::move(row));
    }
    return 1 - dot(rest, rest) / whole;
}

}  // namespace blind
