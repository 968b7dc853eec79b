#include "analysis/diagnosis/outcomes/rows.h"

#include "analysis/joint/gains.h"
#include "analysis/joint/parameters.h"
#include "analysis/results/cannot_answer.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

double middle(std::vector<double> values)
{
    double sum = 0;
    for (double v : values) sum += std::log(v);
    return std::exp(sum / static_cast<double>(values.size()));
}

bool same_settings(const OutcomeRow& a, const OutcomeRow& b)
{
    constexpr double alike = 1e-6;  // numerical: as digits of a table are
    for (std::size_t k = 0; k < a.settings.size(); ++k)
        if (std::abs(a.settings[k] - b.settings[k]) >
            alike * std::max(std::abs(a.settings[k]), std::abs(b.settings[k])))
            return false;
    return true;
}

}  // namespace

void refuse_unfit(const Joint& joint, const OutcomeTable& table)
{
    if (joint.mechanism.model != Model::single_mass)
        throw CannotAnswer(CannotAnswer::Why::table_of_many_bodies, table.name);
    if (joint.control.contact_stiffness != 0 || joint.control.force_gain != 0)
        throw CannotAnswer(CannotAnswer::Why::table_of_two_springs, table.name);
}

Joint joint_at(const Joint& nominal, const OutcomeTable& table, const std::vector<double>& settings)
{
    Joint joint = nominal;
    bool by_force = false;
    for (std::size_t k = 0; k < table.paths.size(); ++k) {
        if (!find_parameter(joint, table.paths[k]))
            throw CannotAnswer(CannotAnswer::Why::no_number, table.name, table.paths[k]);
        number_at(joint, table.paths[k]) = settings[k];
        by_force = by_force || table.paths[k] == "control.force_rate";
    }
    auto& c = joint.control;
    if (by_force || (is_set(c.force_rate) && !is_set(c.V0))) c.V0 = c.force_rate / c.k_p;
    c.force_rate = not_set;
    return joint;
}

Outcomes prepared(const Joint& nominal, const OutcomeTable& table)
{
    Outcomes o{table, {}, {}};
    std::vector<double> stiffness, velocity, inertia;
    for (const auto& row : table.rows) {
        Joint joint = joint_at(nominal, table, row.settings);
        const std::string place = table.name + ":" + std::to_string(row.line) + ":1";
        if (!(joint.control.V0 > 0)) throw CannotAnswer(CannotAnswer::Why::no_velocity, place);
        const double k_p = gains_of(joint.control).k_p;
        if (!(k_p > 0)) throw CannotAnswer(CannotAnswer::Why::no_stiffness, place);
        stiffness.push_back(k_p), velocity.push_back(joint.control.V0);
        inertia.push_back(joint.mechanism.inertia);
        o.joints.push_back(std::move(joint));
    }
    o.scales.stiffness = middle(stiffness), o.scales.velocity = middle(velocity), o.scales.inertia = middle(inertia);
    const double level = std::abs(steady_force(nominal.friction, o.scales.velocity));
    // a level keeps the friction positive and cancels in the boundary
    o.scales.level = std::isfinite(level) && level > 0 ? level : 100 * o.scales.damping() * o.scales.velocity;
    return o;
}

int contradictions(const OutcomeTable& table, std::vector<Note>& notes)
{
    std::vector<bool> seen(table.rows.size());
    int against = 0;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        if (seen[i]) continue;
        int yes = 0, no = 0;
        std::vector<double> lines;
        for (std::size_t j = i; j < table.rows.size(); ++j)
            if (same_settings(table.rows[i], table.rows[j])) {
                seen[j] = true;
                (table.rows[j].stick_slip ? yes : no) += 1;
                lines.push_back(static_cast<double>(table.rows[j].line));
            }
        if (yes > 0 && no > 0) {
            against += std::min(yes, no);
            notes.push_back({.code = Note::Code::same_settings, .record = table.name, .values = lines});
        }
    }
    return against;
}

}  // namespace stickslip::gap
