#include "sweep/report/figures/model_notes.h"

#include "analysis/joint/parameters.h"
#include "analysis/stability/steady.h"
#include "sweep/report/figures/sketch.h"
#include "sweep/words/symbols.h"

namespace stickslip {
namespace {

using sketch::labelled;

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

}  // namespace

std::vector<std::string> model_notes(const Joint& joint, const std::string& reduction)
{
    auto all = friction_notes(joint);
    const auto hardening = hardening_notes(joint);
    all.insert(all.begin(), hardening.begin(), hardening.end());
    if (!reduction.empty()) all.insert(all.begin(), reduction);
    all.insert(all.begin(), loop_note(joint));
    return all;
}

}  // namespace stickslip
