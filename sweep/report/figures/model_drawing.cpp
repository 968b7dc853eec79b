#include "sweep/report/figures/model_drawing.h"

#include "sweep/report/figures/model_notes.h"
#include "sweep/report/figures/sketch.h"

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
    return d.finish(width, model_figure(joint) + ": one mass", model_notes(joint, ""));
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
    return d.finish(width, model_figure(joint) + (three ? ": three masses" : ": two masses"),
                    model_notes(joint, reduction));
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
    return d.finish(width, model_figure(joint) + ": lever and three inertias", model_notes(joint, ""));
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
    figure.caption = "The joint as the theory models it, " + model_figure(joint) +
                     " of the paper: friction acts between each body and the ground under it.";
    figure.picture = std::move(drawing);
    return figure;
}

Section model_section(const Joint& joint)
{
    return {"model", "The joint", "", {model_drawing_figure(joint, "lumped-model")}, {}};
}

}  // namespace stickslip
