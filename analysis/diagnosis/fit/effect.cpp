#include "analysis/diagnosis/fit/effect.h"

namespace stickslip::gap {

namespace {

double unit_with(Scale scale, double effort, double velocity, double position)
{
    switch (scale) {
        case Scale::velocity:
            return velocity;
        case Scale::position:
            return position;
        case Scale::damping:
            return effort / velocity;
        case Scale::stiffness:
            return effort / position;
        case Scale::wave_number:
            return 1 / position;
        default:
            return effort;
    }
}

double on(const Reflected& body, Scale scale, const Scales& s)
{
    return unit_with(scale, s.effort * body.effort, s.velocity * body.motion, s.position * body.motion);
}

}  // namespace

double unit_of(Scale scale, const Scales& s)
{
    switch (scale) {
        case Scale::one:
            return 1;
        case Scale::effort:
        case Scale::velocity:
        case Scale::position:
        case Scale::damping:
        case Scale::stiffness:
        case Scale::wave_number:
            return on({}, scale, s);
        case Scale::friction_effort:
            return on(s.friction, Scale::effort, s);
        case Scale::friction_velocity:
            return on(s.friction, Scale::velocity, s);
        case Scale::friction_position:
            return on(s.friction, Scale::position, s);
        case Scale::friction_damping:
            return on(s.friction, Scale::damping, s);
        case Scale::friction_stiffness:
            return on(s.friction, Scale::stiffness, s);
        case Scale::friction_wave_number:
            return on(s.friction, Scale::wave_number, s);
        case Scale::load_effort:
            return on(s.load, Scale::effort, s);
        case Scale::load_velocity:
            return on(s.load, Scale::velocity, s);
        case Scale::load_position:
            return on(s.load, Scale::position, s);
        case Scale::load_damping:
            return on(s.load, Scale::damping, s);
        case Scale::load_wave_number:
            return on(s.load, Scale::wave_number, s);
        case Scale::peak_effort:
            return s.peak_effort;
        case Scale::tick:
            return s.tick;
        case Scale::duration:
            return s.duration;
        case Scale::inertia:
            return s.inertia;
        case Scale::angular_frequency:
            return 1;
        case Scale::command:
            return s.command;
    }
    return 1;
}

std::string_view name_of(Stage stage)
{
    switch (stage) {
        case Stage::friction:
            return "friction";
        case Stage::mechanism:
            return "mechanism";
        case Stage::actuator:
            return "actuator";
        case Stage::controller:
            return "controller";
        case Stage::sensor:
            return "sensor";
        case Stage::outside:
            return "outside";
        case Stage::correction:
            return "correction";
    }
    return "";
}

EffectParameter factor_on_number(double low, double high, double prior, std::string_view help, std::string_view name)
{
    EffectParameter p{name, Quantity::number, Scale::one, true, low, high, prior, help};
    p.factor = true;
    return p;
}

const Effect* effect_named(std::string_view name)
{
    for (const auto& e : effects())
        if (e.name == name) return &e;
    return nullptr;
}

}  // namespace stickslip::gap
