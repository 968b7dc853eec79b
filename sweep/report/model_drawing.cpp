#include "sweep/report/model_drawing.h"

#include "analysis/results/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace stickslip {
namespace {

constexpr double box_width = 120, box_height = 64, gap = 150, floor_y = 190, box_top = floor_y - box_height;
constexpr double spring_y = box_top + 18, damper_y = box_top + 46, middle_y = box_top + box_height / 2;
constexpr double wall_height = 100, margin = 60, height = 310, least_width = 760;
constexpr const char* ink = "#1c1c1c";

/// "k_{p} = 2 kN/m", or the symbol alone where there is no number.
std::string labelled(const char* symbol, double value, Quantity quantity, Motion motion)
{
    return is_set(value) ? std::string(symbol) + " = " + with_unit(value, quantity, motion) : symbol;
}

/// Chart mark-up as SVG: subscripts lowered.
std::string svg_text(const std::string& markup)
{
    std::string text;
    for (std::size_t i = 0; i < markup.size(); ++i) {
        const auto end = markup.compare(i, 2, "_{") == 0 ? markup.find('}', i) : std::string::npos;
        if (end == std::string::npos) {
            text += markup[i] == '<' ? "&lt;" : markup[i] == '&' ? "&amp;" : std::string(1, markup[i]);
            continue;
        }
        text += "<tspan dy=\"4\" font-size=\"10\">" + markup.substr(i + 2, end - i - 2) +
                "</tspan><tspan dy=\"-4\"> </tspan>";
        i = end;
    }
    return text;
}

class Drawing {
  public:
    explicit Drawing(Motion motion) : motion_(motion) {}

    void line(double x1, double y1, double x2, double y2)
    {
        body_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>\n", x1, y1, x2, y2);
    }
    void text(double x, double y, const std::string& markup, const char* anchor = "middle")
    {
        body_ += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor, svg_text(markup));
    }
    void circle(double x, double y, double r)
    {
        body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"#fff\"/>\n", x, y, r);
    }
    void path(const std::string& d) { body_ += "<path d=\"" + d + "\"/>\n"; }

    void box(double x, const char* name, const std::string& inertia)
    {
        body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"#e8eef6\"/>\n", x, box_top,
                             box_width, box_height);
        text(x + box_width / 2, middle_y - 6, name);
        text(x + box_width / 2, middle_y + 14, inertia);
    }
    /// Ground under a body: that is where its friction acts.
    void friction(double x, const char* symbol, const Friction& f)
    {
        line(x - 10, floor_y, x + box_width + 10, floor_y);
        for (double at = x - 4; at < x + box_width + 10; at += 10) line(at, floor_y, at - 7, floor_y + 8);
        text(x + box_width / 2, floor_y + 28, std::string(symbol) + ": " + std::string(info(f.law).name));
    }
    void spring(double x1, double x2, double y, const std::string& label)
    {
        const double lead = 14, teeth = 6, step = (x2 - x1 - 2 * lead) / (2 * teeth);
        std::string d = fmt::format("M{} {}H{}", x1, y, x1 + lead);
        for (int i = 0; i < 2 * teeth; ++i)
            d += fmt::format("L{} {}", x1 + lead + (i + 0.5) * step, y + (i % 2 ? 7 : -7));
        path(d + fmt::format("L{} {}H{}", x2 - lead, y, x2));
        text((x1 + x2) / 2, y - 14, label);
    }
    void damper(double x1, double x2, double y, const std::string& label)
    {
        const double m = (x1 + x2) / 2;
        path(fmt::format("M{} {}H{}M{} {}H{}V{}H{}M{} {}V{}M{} {}H{}", x1, y, m - 4, m - 16, y - 8, m + 12, y + 8,
                         m - 16, m - 4, y - 6, y + 6, m + 12, y, x2));
        text(m, y + 26, label);
    }
    /// A wall with its hatching to the outer side.
    void wall(double x, double outwards)
    {
        line(x, middle_y - wall_height / 2, x, middle_y + wall_height / 2);
        for (double y = middle_y - wall_height / 2 + 8; y <= middle_y + wall_height / 2; y += 10)
            line(x, y, x + 8 * outwards, y - 7);
    }
    void arrow(double x1, double x2, double y, const std::string& label)
    {
        path(fmt::format("M{} {}H{}M{} {}L{} {}L{} {}", x1, y, x2, x2 - 8, y - 5, x2, y, x2 - 8, y + 5));
        text((x1 + x2) / 2, y - 8, label);
    }

    std::string finish(double width, const std::string& title, const std::string& note, const std::string& more = "")
    {
        return fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
            "role=\"img\" "
            "font-family=\"DejaVu Sans, sans-serif\" font-size=\"13\">\n<title>{2}</title>\n<rect width=\"{0}\" "
            "height=\"{1}\" fill=\"#fff\"/>\n<text x=\"{3}\" y=\"24\" font-weight=\"bold\">{2}</text>\n<text x=\"{3}\" "
            "y=\"{4}\">{5}</text>\n<text x=\"{3}\" y=\"{8}\">{9}</text>\n<g stroke=\"{6}\" stroke-width=\"1.5\" "
            "fill=\"none\">\n{7}</g>\n</svg>\n",
            std::max(width, least_width), height, title, margin / 2, height - 38, svg_text(note), ink, unstroked(),
            height - 16, svg_text(more));
    }

    Motion motion() const { return motion_; }

  private:
    /// Text is filled, not stroked.
    std::string unstroked() const
    {
        std::string out = body_;
        const std::string tag = "<text ";
        for (std::size_t at = 0; (at = out.find(tag, at)) != std::string::npos; at += tag.size())
            out.insert(at + tag.size(), fmt::format("fill=\"{}\" stroke=\"none\" ", ink));
        return out;
    }

    Motion motion_;
    std::string body_;
};

/// Spring above, damper below, between two x.
void coupling(Drawing& d, double x1, double x2, const char* k, double stiffness, const char* c, double damping)
{
    d.spring(x1, x2, spring_y, labelled(k, stiffness, Quantity::stiffness, d.motion()));
    if (damping != 0) d.damper(x1, x2, damper_y, labelled(c, damping, Quantity::damping, d.motion()));
}

/// What lies beyond the link: the finger on a fixed surface in force control, or the contact alone.
double beyond_link(Drawing& d, const Joint& joint, double x)
{
    const auto& c = joint.control;
    const bool force = c.kind == ControlKind::force;
    if (!force && c.contact_stiffness == 0) return x + margin;
    if (force)
        coupling(d, x, x + gap, "k_{p}", c.k_p, "k_{v}", c.k_v);
    else
        d.spring(x, x + gap, middle_y, labelled("k_{c}", c.contact_stiffness, Quantity::stiffness, d.motion()));
    if (force && c.contact_stiffness > 0)
        d.text(x + gap / 2, box_top - 18,
               "beside it " + labelled("k_{c}", c.contact_stiffness, Quantity::stiffness, d.motion()));
    d.wall(x + gap, 1);
    return x + gap + margin;
}

/// The loop in words, where it is no spring of the drawing.
std::string loop_note(const Joint& joint)
{
    const auto& c = joint.control;
    const auto motion = joint.mechanism.motion;
    const std::string speed = labelled("V_{0}", c.V0, Quantity::velocity, motion);
    if (c.kind == ControlKind::force) return "F_{m} ramps so that the link slides at " + speed;
    if (joint.mechanism.model == Model::single_mass) return "the motor moves at " + speed;
    return "F_{m} = k_{p}, k_{v} times the error of the " +
           std::string(c.feedback == Feedback::link ? "link" : "motor") + ": " +
           labelled("k_{p}", c.k_p, Quantity::stiffness, motion) + ", " +
           labelled("k_{v}", c.k_v, Quantity::damping, motion) + ", " + speed;
}

struct BodyDrawing {
    const char *name, *inertia_symbol, *friction_symbol;
    double inertia;
    Quantity quantity;
    const Friction* friction;
};

void draw_body(Drawing& d, double x, const BodyDrawing& b)
{
    std::string symbol = b.inertia_symbol;
    if (d.motion() == Motion::revolute) symbol.front() = 'J';
    d.box(x, b.name, labelled(symbol.c_str(), b.inertia, b.quantity, d.motion()));
    d.friction(x, b.friction_symbol, *b.friction);
}

std::string single_mass(const Joint& joint)
{
    Drawing d(joint.mechanism.motion);
    const auto& c = joint.control;
    const double wall = margin, x = wall + gap;
    draw_body(d, x, {"link", "m", "f", joint.mechanism.inertia, Quantity::inertia, &joint.friction});
    if (c.kind == ControlKind::position) {
        d.wall(wall, -1);
        d.arrow(wall - 30, wall + 30, box_top - 46, "x_{m}");
        coupling(d, wall, x, "k_{p}", c.k_p, "k_{v}", c.k_v);
    } else {
        d.arrow(wall + 50, x, middle_y, "F_{m}");
    }
    d.arrow(x + 30, x + 90, box_top - 30, "x_{l}");
    const double width = beyond_link(d, joint, x + box_width);
    return d.finish(width, model_figure(joint) + ": one mass", loop_note(joint));
}

std::string chain(const Joint& joint)
{
    Drawing d(joint.mechanism.motion);
    const auto& m = joint.mechanism;
    const bool three = m.model == Model::three_mass;
    double x = margin + 60;
    d.arrow(margin, x, middle_y, "F_{m}");
    draw_body(d, x, {"motor", "M_{m}", "f_{m}", m.motor_inertia, Quantity::inertia, &joint.frictions.motor});
    std::string reduction;
    const double N = three ? m.motor_transmission.ratio * m.transmission_link.ratio : m.transmission.ratio;
    if (N != 1) reduction = fmt::format("reduction N = {}, values of the motor at its own side", plain_number(N));
    if (three) {
        coupling(d, x + box_width, x + box_width + gap, "k_{m-tr}", m.motor_transmission.stiffness, "damping",
                 m.motor_transmission.damping);
        x += box_width + gap;
        draw_body(d, x,
                  {"transmission", "M_{tr}", "f_{tr}", m.transmission_inertia, Quantity::inertia,
                   &joint.frictions.transmission});
    }
    const auto& last = three ? m.transmission_link : m.transmission;
    coupling(d, x + box_width, x + box_width + gap, three ? "k_{tr-l}" : "k_{tr}", last.stiffness, "damping",
             last.damping);
    x += box_width + gap;
    draw_body(d, x, {"link", "M_{l}", "f_{l}", m.link_inertia, Quantity::inertia, &joint.frictions.link});
    d.arrow(x + 30, x + 90, box_top - 30, "x_{l}");
    const double width = beyond_link(d, joint, x + box_width);
    return d.finish(width, model_figure(joint) + (three ? ": three masses" : ": two masses"), loop_note(joint),
                    reduction);
}

/// The lever's motor pulls at N times the arm of the link; both springs are drawn at their own height.
std::string lever(const Joint& joint)
{
    Drawing d(joint.mechanism.motion);
    const auto& m = joint.mechanism;
    double x = margin + 60;
    d.arrow(margin, x, middle_y, "F_{m}");
    draw_body(d, x, {"motor", "M_{m}", "f_{m}", m.motor_inertia, Quantity::inertia, &joint.frictions.motor});
    const double at = x + box_width + gap, top = spring_y - 6, arm = middle_y + 26, pivot = floor_y + 34;
    d.spring(x + box_width, at, spring_y,
             labelled("k_{m-tr}", m.motor_transmission.stiffness, Quantity::stiffness, d.motion()));
    d.line(at, top, at, pivot);
    d.circle(at, spring_y, 4);
    d.circle(at, arm, 4);
    d.circle(at, pivot, 7);
    d.text(at - 14, pivot + 5, labelled("J_{tr}", m.transmission_inertia, Quantity::rotary_inertia, d.motion()), "end");
    const std::string arms = labelled("d", m.lever_arm, Quantity::length, d.motion());
    d.text(at, pivot + 26, arms + " below, N d above, N = " + plain_number(m.motor_transmission.ratio));
    d.text(at, spring_y - 40, "f_{tr}: " + std::string(info(joint.frictions.transmission.law).name));
    d.spring(at, at + gap, arm, labelled("k_{tr-l}", m.transmission_link.stiffness, Quantity::stiffness, d.motion()));
    x = at + gap;
    draw_body(d, x, {"link", "M_{l}", "f_{l}", m.link_inertia, Quantity::inertia, &joint.frictions.link});
    d.arrow(x + 30, x + 90, box_top - 30, "x_{l}");
    const double width = beyond_link(d, joint, x + box_width);
    return d.finish(width, model_figure(joint) + ": lever and three inertias", loop_note(joint));
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

std::string model_drawing(const Joint& joint)
{
    if (joint.mechanism.model == Model::single_mass) return single_mass(joint);
    return joint.mechanism.model == Model::lever ? lever(joint) : chain(joint);
}

}  // namespace stickslip
