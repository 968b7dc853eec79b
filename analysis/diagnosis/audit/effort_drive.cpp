#include "analysis/diagnosis/audit/effort_drive.h"

#include "analysis/diagnosis/audit/effort_regression.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/plant/simulator.h"
#include "analysis/diagnosis/policy/audit.h"
#include "analysis/diagnosis/records/ticks.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

bool no_command(const Record& r)
{
    return r.effort_command.empty() && r.drive.empty();
}

double slope(const std::vector<double>& y, const std::vector<double>& time, std::size_t k)
{
    const std::size_t a = k == 0 ? 0 : k - 1, b = std::min(k + 1, y.size() - 1);
    return (y[b] - y[a]) / (time[b] - time[a]);
}

EffortTerms terms_of(const Record& r, const Joint& joint)
{
    EffortTerms terms;
    const Ticks ticks = on_clock(r, joint);
    const Plant plant = flatten(joint);
    Innovation innovation;
    predict(plant, ticks, known_command(plant, ticks), levels[1], innovation);
    double integral = 0;
    for (std::size_t k = 0, tick = 0; k < r.rows(); ++k, ++tick) {
        while (tick + 1 < ticks.size() && ticks.time[tick] < r.time[k]) ++tick;
        const double error = r.reference_position[k] - r.position[k];
        if (k > 0) integral += error * (r.time[k] - r.time[k - 1]);
        terms.error.push_back(error);
        terms.integral.push_back(integral);
        terms.velocity.push_back(r.velocity.empty() ? slope(r.position, r.time, k) : r.velocity[k]);
        terms.rate.push_back(r.reference_velocity.empty() ? slope(r.reference_position, r.time, k)
                                                          : r.reference_velocity[k]);
        terms.acceleration.push_back(0);
        const double predicted = innovation.predicted_effort[tick];
        terms.documented.push_back(std::isfinite(predicted) ? predicted : 0);
        terms.added.push_back(r.feed_forward.empty() ? 0 : r.feed_forward[k]);
        terms.effort.push_back(r.effort_measured[k]);
    }
    for (std::size_t k = 0; k < r.rows(); ++k) terms.acceleration[k] = slope(terms.rate, r.time, k);
    return terms;
}

/// The Coulomb feed-forward of a reference that moves, by the velocity at which most of it is there.
std::vector<double> direction_of(const std::vector<double>& rate, double speed)
{
    std::vector<double> along;
    for (const double v : rate) along.push_back(std::tanh(v / speed));
    return along;
}

/// Part of the squares that the documented structure leaves beside a feed-forward.
double left_beside_feed_forward(const EffortTerms& terms)
{
    constexpr double shares[] = {0.003, 0.01, 0.03, 0.1, 0.3};  // numerical: of the usual speed, half a decade apart
    double squares = 0, left = 1;
    for (const double v : terms.rate) squares += v * v;
    const double usual = std::sqrt(squares / static_cast<double>(terms.rate.size()));
    if (!(usual > 0)) return left;
    for (const double share : shares) {
        const auto along = direction_of(terms.rate, share * usual);
        for (std::size_t late = 0; late <= policy::most_rows_late; ++late) {
            const EffortRegression fed(terms,
                                       {&terms.documented, &terms.error, &terms.velocity, &terms.rate, &terms.added,
                                        &terms.acceleration, &along},
                                       false, late);
            if (fed.solved()) left = std::min(left, fed.left());
        }
    }
    return left;
}

}  // namespace

Record with_effort_of_current(Record record, const Joint& joint)
{
    if (!record.effort_measured.empty() || joint.actuator.kind != ActuatorKind::dc_motor) return record;
    for (double i : record.current)
        record.effort_measured.push_back(joint.actuator.effort_gain * joint.actuator.k_t * i);
    return record;
}

bool EffortOfController::documented_one() const
{
    return left < policy::made_by_controller || (left_fed < policy::made_by_feed_forward && left_fed < left_pid);
}

EffortOfController effort_of_controller(const Record& record, const Joint& joint)
{
    const EffortTerms terms = terms_of(record, joint);
    EffortOfController found;
    found.velocity_logged = !record.velocity.empty();
    double squares = 0, missed = 0;
    for (std::size_t k = 0; k < terms.effort.size(); ++k) {
        found.error.push_back(terms.effort[k] - terms.documented[k]);
        squares += terms.effort[k] * terms.effort[k], missed += found.error[k] * found.error[k];
    }
    if (squares > 0) found.as_documented = missed / squares;
    for (std::size_t late = 0; late <= policy::most_rows_late; ++late) {
        const EffortRegression own(terms, {&terms.documented, &terms.error, &terms.velocity, &terms.rate, &terms.added},
                                   false, late);
        const EffortRegression pid(terms, {&terms.error, &terms.velocity, &terms.integral, &terms.rate, &terms.added},
                                   true, late);
        if (own.solved()) found.judged = true, found.left = std::min(found.left, own.left());
        if (!pid.solved() || pid.left() >= found.left_pid) continue;
        found.left_pid = pid.left();
        found.k_p = pid.numbers()[0], found.k_v = -pid.numbers()[1], found.k_i = pid.numbers()[2];
    }
    if (found.judged && found.left >= policy::made_by_controller) found.left_fed = left_beside_feed_forward(terms);
    return found;
}

EffortDrive drive_by_effort(std::vector<Record>& records, const Joint& nominal, std::vector<Note>& notes)
{
    EffortDrive drive;
    for (const Record& r : records) {
        const Joint joint = joint_in(r, nominal);
        const Record converted = with_effort_of_current(r, joint);
        if (!no_command(r) || converted.effort_measured.empty()) return {};
        drive.controllers.emplace_back();
        if (r.reference_position.empty()) continue;
        drive.controllers.back() = effort_of_controller(converted, joint);
        // where nothing can be said of it, the documented one stands
        const auto& controller = drive.controllers.back();
        if (!controller.judged || controller.documented_one()) return {};
    }
    std::erase_if(notes, [](const Note& n) { return n.code == Note::Code::no_command; });
    for (std::size_t i = 0; i < records.size(); ++i) {
        const auto& c = drive.controllers[i];
        if (c.error.empty())
            notes.push_back({Note::Code::driven_by_effort, records[i].name});
        else
            notes.push_back({.code = Note::Code::another_controller,
                             .record = records[i].name,
                             .values = {c.left, c.left_pid, c.k_p, c.k_v, c.k_i}});
        records[i].reference_position.clear(), records[i].reference_velocity.clear();
    }
    return drive;
}

namespace {

/// A gain of the PID over the records.
struct Gain {
    double mean = 0, spread = 0;
};

Gain gain_over(const std::vector<EffortOfController>& controllers, double EffortOfController::*gain)
{
    Gain g;
    double records = 0;
    for (const auto& c : controllers)
        if (!c.error.empty()) g.mean += c.*gain, records += 1;
    g.mean /= records;
    for (const auto& c : controllers)
        if (!c.error.empty()) g.spread = std::max(g.spread, std::abs(c.*gain - g.mean));
    return g;
}

/// Names a proportional or derivative gain that differs from the document by more than it does between the records.
void name_factor(const Gain& found, double Control::*documented, std::string_view effect, std::string_view parameter,
                 double share, std::vector<Case>& cases, Audit& audit)
{
    const double gain = cases[0].joint.control.*documented, off = std::abs(found.mean - gain);
    if (!(gain > 0) || !(off > policy::rough_gain * gain) || !(off > found.spread)) return;
    audit.findings.push_back(
        {std::string(effect), std::string(parameter), found.mean / gain, found.spread / gain, Quantity::number, share});
    for (auto& c : cases) c.joint.control.*documented *= found.mean / gain;
}

}  // namespace

void audit_effort(const EffortDrive& drive, std::vector<Case>& cases, Audit& audit, std::vector<Note>& reasons)
{
    double left = 0, left_pid = 0, documented = 0;
    bool none = true, velocity_logged = true;
    for (std::size_t i = 0; i < drive.controllers.size(); ++i) {
        const auto& c = drive.controllers[i];
        if (c.error.empty()) continue;
        none = false, velocity_logged = velocity_logged && c.velocity_logged;
        cases[i].controller_error = c.error;
        left = std::max(left, c.left), left_pid = std::max(left_pid, c.left_pid);
        documented = std::max(documented, c.as_documented);
    }
    if (none) return;
    const Gain k_i = gain_over(drive.controllers, &EffortOfController::k_i);
    const Control& control = cases[0].joint.control;
    const bool lacks_integral = control.structure == Structure::pid && control.k_i == 0;
    if (!lacks_integral || left_pid > policy::made_by_pid || k_i.spread > policy::one_integral * std::abs(k_i.mean)) {
        reasons.push_back({.code = Note::Code::no_such_controller, .values = {left}});
        return;
    }
    for (auto& c : cases) c.joint.control.k_i = k_i.mean;
    const double share = 1 - left_pid / std::max(documented, left_pid);
    audit.findings.push_back({"gain-k_i", "gain-k_i.value", k_i.mean, k_i.spread, Quantity::integral_gain, share});
    name_factor(gain_over(drive.controllers, &EffortOfController::k_p), &Control::k_p, "gain-k_p", "gain-k_p.factor",
                share, cases, audit);
    // a velocity made of differences carries the encoder's noise, which makes its gain too small
    if (velocity_logged)
        name_factor(gain_over(drive.controllers, &EffortOfController::k_v), &Control::k_v, "gain-k_v",
                    "gain-k_v.factor", share, cases, audit);
}

Joint behind_its_effort(Joint joint)
{
    joint.actuator = Actuator{};
    joint.control.delay = 0;
    return joint;
}

}  // namespace stickslip::gap
