// Causes outside the catalogue, as edits like any other.
#include "tests/blind/generate/effects_parts.h"
#include "tests/blind/generate/outside.h"

namespace blind {

Edit draw_outside(const std::string& name, const Nominal& n, Draw& draw)
{
    using Kind = Outside::Kind;
    Outside o;
    for (const auto& [known, kind] : outside_kinds())
        if (known == name) o.kind = kind;
    const double travel = n.travel;
    double unit = n.coulomb();
    switch (o.kind) {
        case Kind::quadratic_drag:
            unit = n.coulomb() / (n.speed * n.speed);
            break;
        case Kind::softening_ends:
        case Kind::hardening_ends:
            o.where = travel * draw.uniform(0.35, 0.6);
            o.width = travel * 0.2;
            break;
        case Kind::cubic_spring:
            o.where = travel * 0.7;
            break;
        case Kind::hysteretic_load:
            o.where = travel;
            o.width = travel * draw.uniform(0.08, 0.2);
            break;
        case Kind::bumps:
            o.width = draw.uniform(0.8, 2.5);
            break;
        case Kind::random_force:
            o.width = draw.log_uniform(0.02, 0.15);
            break;
        case Kind::changing_inertia:
            o.where = draw.uniform(3, 7);
            o.width = draw.uniform(0.1, 0.5);
            unit = 1;
            break;
        case Kind::local_obstacle:
            o.where = travel * draw.uniform(-0.4, 0.4);
            o.width = travel * draw.uniform(0.04, 0.12);
            break;
        case Kind::none:
            break;
    }
    Edit e{.name = name, .smallest = 0.05, .largest = 20, .differs_by_record = true};
    e.apply = [o, unit](Machine& m, double size) -> Changed {
        m.mechanism.outside = o;
        return {changed("outside.size", m.mechanism.outside.size, size * unit),
                {"outside.where", 0, o.where},
                {"outside.width", 0, o.width}};
    };
    return e;
}

}  // namespace blind
