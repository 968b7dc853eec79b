#include "sweep/study/export/gap_left.h"

#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/heldout/ensemble.h"
#include "analysis/joint/gains.h"
#include "sweep/study/export/simulator_run.h"

#include <cmath>
#include <map>
#include <stdexcept>

namespace stickslip {
namespace {

/// What ros2_control runs on the joint as it is: gains, integral and its limit at the documented period.
Joint under_gains_alone(Joint joint)
{
    const Control own = joint.control;
    const Gains gains = gains_of(own);
    joint.control = Control();
    joint.control.feedback = own.feedback;
    joint.control.k_p = gains.k_p, joint.control.k_v = gains.k_v, joint.control.k_i = gains.k_i;
    joint.control.integral_limit = own.integral_limit;
    joint.control.period = own.period;
    joint.control.velocity_estimate.form = EstimateForm::backward_difference;
    return joint;
}

/// A run without noise, row by row, in the units of the record.
struct Run {
    std::vector<double> position, command, effort;
};

Run of_joint(const gap::Case& c, const Joint& joint)
{
    const auto trace = gap::simulate_closed_loop(gap::flatten(joint), c.ticks, 0);
    const double unit = gap::command_unit(joint).factor;
    Run run;
    for (std::size_t k = 0; k < c.ticks.size(); ++k) {
        if (!c.ticks.logged[k]) continue;
        run.position.push_back(trace.position[k]);
        run.command.push_back(unit * trace.command[k]);
        run.effort.push_back(trace.effort[k]);
    }
    return run;
}

Run of_text(const Record& record, const gap::CommandUnit& unit, const ExportAnswer& answer)
{
    const SimulatorJoint& s = answer.joint;
    auto simulated = run_in_simulator(answer, record, s.feedback_link ? 1 : s.ratio);
    Run run{std::move(simulated.position), simulated.effort, std::move(simulated.effort)};
    for (double& x : run.command) x *= unit.factor / s.effort_per_command;
    for (double& x : run.effort) x /= s.ratio;
    return run;
}

double mean_square(const gap::Ticks& t, const std::vector<double>& logged, double unit, const std::vector<double>& run)
{
    double sum = 0, n = 0;
    std::size_t row = 0;
    for (std::size_t k = 0; k < t.size(); ++k) {
        if (!t.logged[k]) continue;
        const double x = run[row++];
        if (is_set(logged[k]) && t.enabled[k]) sum += std::pow(unit * logged[k] - x, 2), n += 1;
    }
    return n > 0 ? sum / n : 0;
}

struct RecordLeft {
    std::vector<SignalLeft> signals;  ///< squares
    std::vector<double> rows;
};

RecordLeft left_in(const Record& record, const Joint& joint, Simulator to, const ExportOptions& options)
{
    constexpr int runs = 4;
    std::vector<Note> notes;
    const gap::Case c = gap::prepare(record, joint, notes);
    if (!c.ticks.has_reference) throw std::invalid_argument(record.name + ": has no reference_position to follow");
    const gap::CommandUnit unit = gap::command_unit(c.joint);
    const Run own = of_joint(c, c.joint);
    const Run text = to == Simulator::ros2_control
                         ? of_joint(c, under_gains_alone(c.joint))
                         : of_text(record, unit, export_joint(gap::joint_in(record, joint), to, options));
    RecordLeft left;
    for (const auto& floor : gap::compare(c, c.joint, runs, -infinity, infinity)) {
        const bool position = floor.signal == "position", command = floor.signal == "effort_command";
        const auto& logged = position ? c.ticks.position : command ? c.ticks.command : c.ticks.effort;
        const auto column = position ? &Run::position : command ? &Run::command : &Run::effort;
        const double factor = command ? unit.factor : 1;
        // noisy runs of a true joint differ by twice the variance, a run without noise and a record by one
        left.signals.push_back({floor.signal, floor.unit, mean_square(c.ticks, logged, factor, own.*column),
                                mean_square(c.ticks, logged, factor, text.*column), floor.floor / 2});
        left.rows.push_back(floor.rows);
    }
    return left;
}

}  // namespace

GapLeft gap_left(const Joint& joint, Simulator to, const ExportOptions& options, const std::vector<Record>& records,
                 const ParallelFor& parallel)
{
    std::vector<RecordLeft> of_record(records.size());
    parallel(records.size(), [&](std::size_t i) { of_record[i] = left_in(records[i], joint, to, options); });
    std::map<std::string, std::pair<SignalLeft, double>> sums;
    for (const auto& r : of_record)
        for (std::size_t s = 0; s < r.signals.size(); ++s) {
            const SignalLeft& one = r.signals[s];
            auto& [sum, n] = sums.try_emplace(one.signal, SignalLeft{one.signal, one.unit}, 0.0).first->second;
            sum.joint += r.rows[s] * one.joint, sum.text += r.rows[s] * one.text, sum.floor += r.rows[s] * one.floor;
            n += r.rows[s];
        }
    GapLeft left;
    for (auto& [name, of] : sums) {
        auto& [s, n] = of;
        // as the diagnosis counts, whose runs have noise of their own
        left.joint += (s.joint / s.floor + 1) / 2, left.text += (s.text / s.floor + 1) / 2;
        s.joint = std::sqrt(s.joint / n), s.text = std::sqrt(s.text / n), s.floor = std::sqrt(s.floor / n);
        left.signals.push_back(s);
    }
    const double signals = static_cast<double>(left.signals.size());
    left.joint = std::sqrt(left.joint / signals), left.text = std::sqrt(left.text / signals);
    return left;
}

}  // namespace stickslip
