// In one file: one drawing and the parts that it is put together from.
#include "sweep/report/figures/model_drawing.h"

#include "analysis/joint/parameters.h"
#include "analysis/stability/steady.h"
#include "sweep/report/figures/sketch.h"
#include "sweep/words/symbols.h"

namespace stickslip {
namespace {

using namespace sketch;

/// What a spring and a damper stand for: themselves, or gains.
struct CoupledBy {
    Quantity spring = Quantity::stiffness, damper = Quantity::damping;
};
constexpr CoupledBy by_gains{Quantity::position_gain, Quantity::velocity_gain};

/// Spring above, damper below, between two x.
void coupling(Sketch& d, double x1, double x2, const char* k, double stiffness, const char* c, double damping,
              CoupledBy by = {})
{
    d.spring(x1, x2, spring_y, labelled(k, stiffness, by.spring, d.units()));
    if (damping != 0) d.damper(x1, x2, damper_y, labelled(c, damping, by.damper, d.units()));
}

/// What lies beyond the link: the finger on a fixed surface in force control, or the contact alone.
double beyond_link(Sketch& d, const Joint& joint, double x)
{
    const auto& c = joint.control;
    const bool force = c.kind == ControlKind::force;
    if (!force && c.contact_stiffness == 0) return x + margin;
    if (force)
        coupling(d, x, x + gap, "k_{p}", c.k_p, "k_{v}", c.k_v, by_gains);
    else
        d.spring(x, x + gap, middle_y, labelled("k_{c}", c.contact_stiffness, Quantity::stiffness, d.units()));
    if (force && c.contact_stiffness > 0)
        d.text(x + gap / 2, box_top - 18,
               "beside it " + labelled("k_{c}", c.contact_stiffness, Quantity::stiffness, d.units()));
    d.wall(x + gap, 1);
    return x + gap + margin;
}

/// The loop in words, where it is no spring of the drawing.
std::string loop_note(const Joint& joint)
{
    const auto& c = joint.control;
    const Units units = units_of(joint);
    const std::string speed = labelled("V_{0}", commanded_velocity(joint), Quantity::velocity, units);
    if (c.kind == ControlKind::force)
        return "F_{m} ramps so that the link slides at " + speed +
               (is_set(c.force_rate) ? ": the force rises by " + with_unit(c.force_rate, Quantity::effort_rate, units)
                                     : "") +
               (c.force_gain > 0 ? "; " + plain_number(c.force_gain) + " of the contact force is fed back to the motor"
                                 : "");
    if (joint.mechanism.model == Model::single_mass) return "the motor moves at " + speed;
    return "F_{m} = k_{p}, k_{v} times the error of the " +
           std::string(c.feedback == Feedback::link ? "link" : "motor") + ": " +
           labelled("k_{p}", c.k_p, Quantity::position_gain, units) + ", " +
           labelled("k_{v}", c.k_v, Quantity::velocity_gain, units) + ", " + speed;
}

/// "f_{l}: rate-and-state, f_{0} = 60 N, A = 1 N, …", a line a body: every number of the law, and of the further terms
/// those that are not at rest.
std::vector<std::string> friction_notes(Joint joint)
{
    Joint plain = joint;
    for (Friction* f : std::initializer_list<Friction*>{&plain.friction, &plain.frictions.motor,
                                                        &plain.frictions.transmission, &plain.frictions.link})
        *f = Friction{f->law};
    const auto own = parameters(joint), at_rest = parameters(plain);
    struct Place {
        const char *symbol, *table;
        const Friction* friction;
    };
    std::vector<Place> places{{"f", "friction.", &joint.friction}};
    if (joint.mechanism.model != Model::single_mass) {
        places = {{"f_{m}", "friction.motor.", &joint.frictions.motor},
                  {"f_{l}", "friction.link.", &joint.frictions.link}};
        if (joint.frictions.has_transmission)
            places.insert(places.begin() + 1, {"f_{tr}", "friction.transmission.", &joint.frictions.transmission});
    }
    std::vector<std::string> notes;
    for (const auto& place : places) {
        std::string text = std::string(place.symbol) + ": " + std::string(info(place.friction->law).name);
        for (std::size_t i = 0; i < own.size(); ++i) {
            const auto& p = own[i];
            if (!p.path.starts_with(place.table) || !is_set(*p.value)) continue;
            const bool of_law = p.need == Need::required;
            if (!of_law && *p.value == *at_rest[i].value) continue;
            const std::string name =
                of_law ? symbol_of(p.path, units_of(joint)) : p.path.substr(std::string_view(place.table).size());
            text += ", " + name + " = " + with_unit(*p.value, p.quantity, units_of(joint));
        }
        notes.push_back(std::move(text));
    }
    return notes;
}

/// Springs that are stiffer the more they carry.
std::vector<std::string> hardening_notes(const Joint& joint)
{
    std::vector<std::string> notes;
    const auto add = [&](const char* spring, const char* cubic, const Transmission& t) {
        if (t.cubic_stiffness == 0) return;
        const auto number = labelled(cubic, t.cubic_stiffness, Quantity::cubic_stiffness, units_of(joint));
        notes.push_back(std::string(spring) + " hardens: " + number + " beside it");
    };
    const auto& m = joint.mechanism;
    if (m.model == Model::two_mass) add("k_{tr}", "k_{3,tr}", m.transmission);
    if (m.model != Model::three_mass && m.model != Model::lever) return notes;
    add("k_{m-tr}", "k_{3,m-tr}", m.motor_transmission);
    add("k_{tr-l}", "k_{3,tr-l}", m.transmission_link);
    return notes;
}

std::vector<std::string> notes(const Joint& joint, const std::string& reduction)
{
    auto all = friction_notes(joint);
    const auto hardening = hardening_notes(joint);
    all.insert(all.begin(), hardening.begin(), hardening.end());
    if (!reduction.empty()) all.insert(all.begin(), reduction);
    all.insert(all.begin(), loop_note(joint));
    return all;
}

struct BodyDrawing {
    const char *name, *inertia_symbol, *friction_symbol;
    double inertia;
    Quantity quantity;
    const Friction* friction;
};

void draw_body(Sketch& d, double x, const BodyDrawing& b)
{
    std::string symbol = b.inertia_symbol;
    if (d.units().motion == Motion::revolute) symbol.front() = 'J';
    d.box(x, b.name, labelled(symbol, b.inertia, b.quantity, d.units()));
    d.friction(x, b.friction_symbol, *b.friction);
}

LineDrawing single_mass(const Joint& joint)
{
    Sketch d(units_of(joint));
    const auto& c = joint.control;
    const double wall = margin, x = wall + gap;
    draw_body(d, x, {"link", "m", "f", joint.mechanism.inertia, Quantity::inertia, &joint.friction});
    if (c.kind == ControlKind::position) {
        d.wall(wall, -1);
        d.arrow(wall - 30, wall + 30, box_top - 46, "x_{m}");
        coupling(d, wall, x, "k_{p}", c.k_p, "k_{v}", c.k_v, by_gains);
    } else {
        d.arrow(wall + 50, x, middle_y, "F_{m}");
    }
    d.arrow(x + 30, x + 90, box_top - 30, "x_{l}");
    const double width = beyond_link(d, joint, x + box_width);
    return d.finish(width, model_figure(joint) + ": one mass", notes(joint, ""));
}

LineDrawing chain(const Joint& joint)
{
    Sketch d(units_of(joint));
    const auto& m = joint.mechanism;
    const bool three = m.model == Model::three_mass;
    double x = margin + 60;
    d.arrow(margin, x, middle_y, "F_{m}");
    draw_body(d, x, {"motor", "M_{m}", "f_{m}", m.motor_inertia, Quantity::inertia, &joint.frictions.motor});
    std::string reduction;
    const double N = three ? m.motor_transmission.ratio * m.transmission_link.ratio : m.transmission.ratio;
    if (N != 1) reduction = "reduction N = " + plain_number(N) + ", values of the motor at its own side";
    if (three) {
        coupling(d, x + box_width, x + box_width + gap, "k_{m-tr}", m.motor_transmission.stiffness, "c_{m-tr}",
                 m.motor_transmission.damping);
        x += box_width + gap;
        draw_body(d, x,
                  {"transmission", "M_{tr}", "f_{tr}", m.transmission_inertia, Quantity::inertia,
                   &joint.frictions.transmission});
    }
    const auto& last = three ? m.transmission_link : m.transmission;
    coupling(d, x + box_width, x + box_width + gap, three ? "k_{tr-l}" : "k_{tr}", last.stiffness,
             three ? "c_{tr-l}" : "c_{tr}", last.damping);
    x += box_width + gap;
    draw_body(d, x, {"link", "M_{l}", "f_{l}", m.link_inertia, Quantity::inertia, &joint.frictions.link});
    d.arrow(x + 30, x + 90, box_top - 30, "x_{l}");
    const double width = beyond_link(d, joint, x + box_width);
    return d.finish(width, model_figure(joint) + (three ? ": three masses" : ": two masses"), notes(joint, reduction));
}

/// The lever's motor pulls at N times the arm of the link; both springs are drawn at their own height.
LineDrawing lever(const Joint& joint)
{
    Sketch d(units_of(joint));
    const auto& m = joint.mechanism;
    double x = margin + 60;
    d.arrow(margin, x, middle_y, "F_{m}");
    draw_body(d, x, {"motor", "M_{m}", "f_{m}", m.motor_inertia, Quantity::inertia, &joint.frictions.motor});
    const double at = x + box_width + gap, top = spring_y - 6, arm = middle_y + 26, pivot = floor_y + 34;
    d.spring(x + box_width, at, spring_y,
             labelled("k_{m-tr}", m.motor_transmission.stiffness, Quantity::stiffness, d.units()));
    d.line({{at, top}, {at, pivot}});
    d.ring(at, spring_y, 4);
    d.ring(at, arm, 4);
    d.ring(at, pivot, 7);
    d.text(at - 14, pivot + 5, labelled("J_{tr}", m.transmission_inertia, Quantity::rotary_inertia, d.units()),
           LineDrawing::Anchor::right);
    const std::string arms = labelled("d", m.lever_arm, Quantity::length, d.units());
    d.text(at, pivot + 26, arms + " below, N d above, N = " + plain_number(m.motor_transmission.ratio));
    d.text(at + 14, pivot + 5, "f_{tr}: " + std::string(info(joint.frictions.transmission.law).name),
           LineDrawing::Anchor::left);
    d.spring(at, at + gap, arm, labelled("k_{tr-l}", m.transmission_link.stiffness, Quantity::stiffness, d.units()));
    const auto damping = [&](double x1, double y, const char* symbol, double value) {
        if (value != 0) d.text(x1 + gap / 2, y + 22, labelled(symbol, value, Quantity::damping, d.units()));
    };
    damping(x + box_width, spring_y, "c_{m-tr}", m.motor_transmission.damping);
    damping(at, arm, "c_{tr-l}", m.transmission_link.damping);
    x = at + gap;
    draw_body(d, x, {"link", "M_{l}", "f_{l}", m.link_inertia, Quantity::inertia, &joint.frictions.link});
    d.arrow(x + 30, x + 90, box_top - 30, "x_{l}");
    const double width = beyond_link(d, joint, x + box_width);
    return d.finish(width, model_figure(joint) + ": lever and three inertias", notes(joint, ""));
}

}  // namespace

std::string model_figure(const Joint& joint)
{
    switch (joint.mechanism.model) {
        case Model::single_mass:
            return joint.control.kind == ControlKind::position ? "Fig. 7a" : "Fig. 7b";
        case Model::two_mass:
            return "Fig. 6";
        case Model::three_mass:
            return "Fig. 5";
        case Model::lever:
            return "Fig. 4";
    }
    return "";
}

LineDrawing model_drawing(const Joint& joint)
{
    if (joint.mechanism.model == Model::single_mass) return single_mass(joint);
    return joint.mechanism.model == Model::lever ? lever(joint) : chain(joint);
}

Figure model_drawing_figure(const Joint& joint, std::string id)
{
    Figure figure;
    figure.id = std::move(id);
    auto drawing = model_drawing(joint);
    figure.finding = "The lumped model, " + drawing.title + ".";
    for (const auto& note : drawing.notes) figure.finding += " " + note + ".";
    figure.caption = "The joint as the theory sees it, " + model_figure(joint) +
                     " of the paper: friction acts between each body and the ground under it.";
    figure.picture = std::move(drawing);
    return figure;
}

Section model_section(const Joint& joint)
{
    return {"model", "The joint", "", {model_drawing_figure(joint, "lumped-model")}, {}};
}

}  // namespace stickslip
