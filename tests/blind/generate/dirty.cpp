#include "tests/blind/generate/dirty.h"

#include "tests/blind/generate/effects_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace blind {
namespace {

/// Off by 2 to 10 %, either way.
double off(Draw& draw)
{
    return 1 + draw.sign() * draw.log_uniform(0.02, 0.1);
}

/// Shapes of the same causes that the formulas of the catalogue do not have.
std::vector<std::string> change_forms(Machine& m, const Nominal& n, const Dirt& dirt)
{
    std::vector<std::string> names;
    auto& x = m.mechanism;
    auto& f = x.friction[0];
    const auto& documented = n.machine.mechanism;
    if (f.static_rise != 0 && documented.friction[0].static_rise == 0) {
        f.shape = dirt.seed % 2 ? DryFriction::Shape::tanh : DryFriction::Shape::rational;
        names.emplace_back(dirt.seed % 2 ? "tanh-stribeck" : "rational-stribeck");
    }
    if (f.bristle_stiffness > 0) {
        f.elements = slip_elements;
        names.emplace_back("maxwell-slip");
    }
    if (f.load_share != 0) f.back_driving = dirt.back_driving, names.emplace_back("back-driving");
    if (f.ripple.amplitude != 0) f.ripple.second = dirt.second_harmonic, names.emplace_back("two-harmonics");
    if (x.cogging.amplitude != 0) x.cogging.second = dirt.second_harmonic, names.emplace_back("two-harmonics");
    if (f.drift != 0) f.to_document = true, names.emplace_back("drift-to-the-document");
    if (x.bodies == 2 && documented.bodies == 1) {
        x.hardening = dirt.hardening;
        x.hardening_stretch = 2 * n.coulomb() / x.stiffness;  // m or rad: where friction has it at every reversal
        names.emplace_back(x.backlash > 0 ? "soft-contacts" : "hardening");
    }
    return names;
}

}  // namespace

Dirt draw_dirt(const Nominal& n, std::size_t records, bool forms, Draw& draw)
{
    Dirt d;
    d.inertia = off(draw), d.coulomb = off(draw), d.viscous = off(draw), d.gravity = off(draw);
    d.asymmetry = draw.sign() * draw.log_uniform(0.003, 0.03);
    d.ripple = draw.log_uniform(0.003, 0.03), d.cogging = draw.log_uniform(0.003, 0.02);
    d.drift = draw.sign() * draw.log_uniform(0.003, 0.03), d.drift_time = draw.log_uniform(3, 15);
    d.ripple_rate = draw_ripple(n, draw).rate, d.cogging_rate = draw_ripple(n, draw).rate, d.phase = draw.phase();
    const bool levels_differ = draw.chance(0.6), cut = draw.chance(0.3);
    const double by = draw.uniform(0.03, 0.1);
    for (std::size_t r = 0; r < records; ++r) {
        d.level.push_back(levels_differ ? 1 + 0.5 * by * draw.uniform(-1, 1) : 1);
        d.cut.push_back(cut ? draw.uniform(0.3, 2) : 0);
    }
    d.other_forms = forms && draw.chance(0.6);
    d.second_harmonic = draw.uniform(0.2, 0.6), d.back_driving = draw.uniform(0.3, 0.8);
    d.hardening = draw.uniform(0.5, 2);
    d.colour = draw.chance(0.4) ? draw.uniform(0.3, 0.9) : 0;
    d.spikes = draw.chance(0.3) ? draw.log_uniform(3e-5, 5e-4) : 0;
    d.jitter = draw.chance(0.4) ? draw.log_uniform(0.005, 0.05) : 0;
    d.lost = draw.chance(0.3) ? draw.log_uniform(2e-4, 5e-3) : 0;
    d.milliseconds = draw.chance(0.2);
    d.seed = draw.seed();
    return d;
}

std::vector<std::string> soil(Machine& m, const Nominal& n, const Dirt& d, std::size_t record)
{
    std::vector<std::string> forms;
    if (d.other_forms) forms = change_forms(m, n, d);
    auto& x = m.mechanism;
    const double level = n.coulomb();
    for (double& inertia : x.inertia) inertia *= d.inertia;
    for (auto& f : x.friction) {
        f.coulomb *= d.coulomb * d.level[record];
        f.viscous *= d.viscous;
    }
    x.gravity *= d.gravity;
    auto& f = x.friction[0];
    f.uneven_coulomb += d.asymmetry * level;
    if (f.ripple.amplitude == 0) f.ripple = {d.ripple * level, d.ripple_rate, d.phase};
    if (f.drift == 0) f.drift = d.drift * level, f.drift_time = d.drift_time;
    if (x.cogging.amplitude == 0) x.cogging = {d.cogging * level, d.cogging_rate, -d.phase};
    m.sensors.colour = d.colour, m.sensors.spikes = d.spikes;
    return forms;
}

Record weathered(Record r, const Dirt& d, std::size_t index, double period)
{
    Draw draw(seed_of(d.seed, index));
    std::vector<bool> keep(r.size());
    for (std::size_t k = 0; k < r.size(); ++k) keep[k] = r.time[k] >= d.cut[index];
    for (std::size_t k = 0; k < r.size(); ++k)
        if (draw.chance(d.lost / 3))
            for (std::size_t i = k, until = k + 1 + static_cast<std::size_t>(draw.below(5)); i < until; ++i)
                if (i > 0 && i + 1 < r.size()) keep[i] = false;
    const double row = r.size() > 1 ? r.time[1] - r.time[0] : period;
    for (double& t : r.time) t += std::clamp(d.jitter * draw.normal(), -0.4, 0.4) * row;
    for (auto* column : {&r.time, &r.reference_position, &r.reference_velocity, &r.position, &r.velocity, &r.command,
                         &r.effort, &r.current, &r.supply, &r.link_position, &r.true_position, &r.true_velocity}) {
        if (column->empty()) continue;
        std::size_t next = 0;
        for (std::size_t k = 0; k < column->size(); ++k)
            if (keep[k]) (*column)[next++] = (*column)[k];
        column->resize(next);
    }
    if (d.milliseconds)
        for (double& t : r.time) t *= 1e3;
    return r;
}

std::vector<Parameter> corrections(const Nominal& n, const Dirt& d)
{
    const auto& m = n.machine.mechanism;
    const bool stribeck = m.friction[0].static_rise > 0;
    std::vector<Parameter> list;
    const auto add = [&](const std::string& path, double documented, double factor) {
        if (documented != 0) list.push_back({path, documented, documented * factor});
    };
    add(m.bodies == 2 ? "joint.motor_inertia" : "joint.inertia", m.inertia[0], d.inertia);
    if (m.bodies == 2) add("joint.link_inertia", m.inertia[1], d.inertia);
    add(friction_path(n.machine, stribeck ? "c0" : "coulomb"), m.friction[0].coulomb, d.coulomb);
    add(friction_path(n.machine, stribeck ? "c1" : "viscous"), m.friction[0].viscous, d.viscous);
    add("load.gravity_amplitude", m.gravity, d.gravity);
    list.push_back({friction_path(n.machine, "asymmetry.coulomb"), 0, d.asymmetry * n.coulomb()});
    return list;
}

}  // namespace blind
