#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {
namespace {

/// Of a joint documented as one mass.
void add_divided_mass(Effect& e)
{
    EffectForm f;
    f.name = "divided-mass";
    f.divides = true;
    f.parameters = {
        {"width", Quantity::position, Scale::position, true, 1e-5, 0.5, 0.01, "total clearance"},
        {"motor_share", Quantity::number, Scale::one, false, 0.02, 0.98, 0.5, "share of the inertia on the motor side"},
        {"stiffness", Quantity::stiffness, Scale::stiffness, true, 0.3, 1e6, 100, "transmission stiffness"},
        {"link_friction", Quantity::number, Scale::one, false, 0, 1, 0.3, "share of the friction on the link side"},
        {"damping_ratio", Quantity::number, Scale::one, true, 1e-2, 100, 0.2, "damping ratio of the closed contact"},
    };
    f.parameters[2].meanwhile = 2e4;    // a contact is stiff
    f.parameters[4].open_above = true;  // grease keeps flanks from bouncing; more of it does not keep them more
    f.apply = [](Joint& j, const double* p) {
        divide_mass(j, p[1], p[2], p[4], p[3]);
        j.mechanism.transmission.backlash = p[0];
    };
    // the misfit is jagged in the width, a stiffness a decade off hides the right one, and where a load presses the
    // link onto a flank its friction decides when it leaves it
    for (double width : {0.001, 0.002, 0.004, 0.007, 0.012, 0.02, 0.035, 0.06})
        for (double share : {0.35, 0.65})
            for (double stiffness : {2000.0, 20000.0})
                for (double friction : {0.2, 0.4}) f.seeds.push_back({width, share, stiffness, friction, 0.2});
    f.applies = is_single_mass;
    f.rough = true;
    e.forms.push_back(f);
    // the encoder of a joint documented as one mass may sit behind the backlash
    f.name = "divided-mass-encoder-on-link";
    f.encoder_on_link = true;
    f.apply = [](Joint& j, const double* p) {
        divide_mass(j, p[1], p[2], p[4], p[3]);
        j.mechanism.transmission.backlash = p[0];
        j.control.feedback = Feedback::link;
    };
    e.forms.push_back(f);
}
/// Of a joint whose masses and spring are documented.
void add_two_mass(Effect& e)
{
    EffectForm f;
    f.name = "two-mass";
    f.parameters = {
        {"width", Quantity::position, Scale::load_position, true, 1e-05, 0.5, 0.01, "total clearance"},
    };
    f.apply = [](Joint& j, const double* p) { j.mechanism.transmission.backlash = p[0]; };
    // a wrong width is worse than none: only within a fifth of the right one does the misfit lead to it
    constexpr double narrowest = 5e-4, widest = 0.15, step = 1.35;  // numerical: starts of the search
    for (double width = narrowest; width < widest; width *= step) f.seeds.push_back({width});
    f.applies = is_two_mass;
    f.rough = true;
    f.needs_history = true;
    e.forms.push_back(f);
}
}  // namespace

Effect backlash()
{
    Effect e;
    e.name = "backlash";
    e.stage = Stage::mechanism;
    e.of_transmission = true;
    e.form = "backlash between motor and link";
    e.source = "Nordin and Gutman 2002";
    e.confusable = {"presliding", "compliance"};
    add_divided_mass(e);
    add_two_mass(e);
    return e;
}

}  // namespace stickslip::gap
