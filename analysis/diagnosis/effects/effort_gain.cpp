#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {

namespace {

/// What a voltage or a duty cycle makes of a motor.
void add_motor_forms(Effect& e)
{
    {
        EffectForm f;
        f.name = "drive";
        f.parameters = {
            factor_on_number(0.2, 5, 0.2, "true voltage at the winding per nominal"),
        };
        // the winding's voltage grows, its back-EMF does not
        f.apply = [](Joint& j, const double* p) {
            j.actuator.k_t *= p[0];
            j.actuator.k_e /= p[0];
        };
        f.seeds = {{1.03}, {1.7}, {0.6}};
        f.applies = [](const Joint& j) { return j.actuator.kind == ActuatorKind::dc_motor; };
        e.forms.push_back(f);
        // a motor wound otherwise: what it pushes by and what resists it are one constant
        f.name = "motor constant";
        f.parameters = {
            factor_on_number(0.2, 5, 0.2, "true torque constant, and back-EMF constant, per nominal"),
        };
        f.apply = [](Joint& j, const double* p) {
            j.actuator.k_t *= p[0];
            j.actuator.k_e *= p[0];
        };
        f.applies = [](const Joint& j) { return j.actuator.kind == ActuatorKind::dc_motor && j.actuator.k_e > 0; };
        e.forms.push_back(f);
        // a motor of another speed constant: it resists motion more or less than documented, as viscous friction that
        // its own current shows
        f.name = "back-emf";
        f.effort_alone = true;  // viscous friction, whose number is the less certain one, moves the joint likewise
        f.parameters = {
            factor_on_number(0.2, 5, 0.2, "true back-EMF constant per nominal"),
        };
        f.apply = [](Joint& j, const double* p) { j.actuator.k_e *= p[0]; };
        f.seeds = {{1.1}, {0.9}};
        e.forms.push_back(f);
    }
}

}  // namespace

Effect effort_gain()
{
    Effect e;
    e.name = "effort-gain";
    e.stage = Stage::actuator;
    e.scales_reading = true;
    e.form = "(1 + epsilon) u";
    e.source = "Lynch and Park 2017";
    e.confusable = {"inertia", "gain-k_p"};
    {
        EffectForm f;
        f.parameters = {
            factor_on_number(0.2, 5, 0.2, "true effort per nominal"),
        };
        f.apply = [](Joint& j, const double* p) { j.actuator.effort_gain *= p[0]; };
        f.seeds = {{1.03}, {0.97}};
        e.forms.push_back(f);
    }
    {
        // a drive measures its current, and logs it times the constant that its document has: the effort is another
        // one, and the log agrees with the command
        EffectForm f;
        f.name = "measured current";
        f.effort_alone = true;  // without a measured effort it is the form above
        f.parameters = {
            factor_on_number(0.2, 5, 0.2, "true effort per nominal, of which the measured one shows nothing"),
        };
        f.apply = [](Joint& j, const double* p) {
            j.actuator.effort_gain *= p[0];
            j.sensor.effort_scale /= p[0];
        };
        f.seeds = {{1.03}, {0.97}};
        e.forms.push_back(f);
    }
    add_motor_forms(e);
    return e;
}

}  // namespace stickslip::gap
