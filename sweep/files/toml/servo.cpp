#include "sweep/files/toml/servo.h"

#include "sweep/files/toml/servo_text.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "analysis/base/field.h"

namespace stickslip::files {
namespace {

constexpr double turn = 2 * std::numbers::pi;  ///< rad per revolution

/// The registers that were stated, others at their defaults; the sample time where the file states it.
struct Registers {
    std::map<std::string, double> value;
    double period = not_set;
    double at(const char* name) const { return value.at(name); }
};

struct Register {
    std::string name;
    double standard;  ///< not set: it has to be stated
    double least, most;
};

struct Servo {
    std::vector<std::string> names;
    std::string source;
    std::vector<Register> registers;
    /// Fills the gains; what cannot be converted is returned as the reason.
    std::function<std::string(const Registers&, ServoGains&)> convert;
};

/// ROBOTIS e-Manual of the X series (xl330-m288, xl330-m077, xc330-m288, xm430-w210), "Position PID Gain(80, 82, 84)":
/// K_P = P/128, K_I = I/65536, K_D = D/16, on the position error in pulses of 1/4096 revolution, in units of Goal
/// PWM, of which 885 are 100 %. "The constant in each equation includes sampling time", which is not published: P needs
/// none, I and D are per sample of control.period.
std::string dynamixel_x(const Registers& r, ServoGains& gains)
{
    constexpr double pulses = 4096 / turn, full_pwm = 885;
    constexpr double signal = pulses / full_pwm;  // duty per rad and per unit gain
    gains.numbers["control.k_p"] = r.at("P") / 128 * signal;
    if ((r.at("I") != 0 || r.at("D") != 0) && !is_set(r.period))
        return "the manual's constants of I and D include the sampling time, which it does not publish; expected "
               "control.period";
    gains.numbers["control.k_i"] = r.at("I") == 0 ? 0 : r.at("I") / 65536 * signal / r.period;
    gains.numbers["control.k_v"] = r.at("D") == 0 ? 0 : r.at("D") / 16 * signal * r.period;
    return "";
}

/// mjbots moteus, its reference (control law) and its guide to PID tuning: torque = kp·error + kd·velocity error
/// + ki ∫error, N·m per revolution at the output of the reducer; ilimit is the limit of the integral's torque.
std::string moteus(const Registers& r, ServoGains& gains)
{
    gains.numbers["control.k_p"] = r.at("kp") / turn;
    gains.numbers["control.k_v"] = r.at("kd") / turn;
    gains.numbers["control.k_i"] = r.at("ki") / turn;
    if (r.at("ki") != 0 && r.at("ilimit") == 0) gains.numbers["control.k_i"] = 0;
    if (r.at("ki") != 0 && r.at("ilimit") > 0 && std::isfinite(r.at("ilimit")))
        gains.numbers["control.integral_limit"] = r.at("ilimit");
    return "";
}

/// ODrive, Firmware/MotorControl/controller.hpp: pos_gain in (turn/s)/turn, vel_gain in N·m/(turn/s),
/// vel_integrator_gain in N·m/(turn/s · s); velocity loop inside a position loop.
std::string odrive(const Registers& r, ServoGains& gains)
{
    gains.choices["control.structure"] = "cascade";
    gains.numbers["control.position_gain"] = r.at("pos_gain");
    gains.numbers["control.velocity_gain"] = r.at("vel_gain") / turn;
    gains.numbers["control.velocity_integral_gain"] = r.at("vel_integrator_gain") / turn;
    return "";
}

const std::vector<Servo>& servos()
{
    constexpr double most_register = 16383;
    static const std::vector<Servo> all{
        {{"dynamixel-xl330", "dynamixel-xc330", "dynamixel-xm430"},
         "ROBOTIS e-Manual, X series, Position PID Gain(80, 82, 84): P/128, I/65536, D/16 in Goal PWM (885 = 100 %) "
         "per "
         "pulse (4096 a revolution); k_p in duty per rad, for [actuator] signal = \"duty\"",
         {{"P", not_set, 0, most_register}, {"I", 0, 0, most_register}, {"D", 0, 0, most_register}},
         dynamixel_x},
        {{"moteus"},
         "mjbots moteus reference and PID tuning guide: N·m per revolution at the output of the reducer",
         {{"kp", not_set, 0, infinity},
          {"kd", 0, 0, infinity},
          {"ki", 0, 0, infinity},
          {"ilimit", infinity, 0, infinity}},
         moteus},
        {{"odrive"},
         "ODrive firmware, MotorControl/controller.hpp: (turn/s)/turn, N·m/(turn/s), N·m/(turn/s·s)",
         {{"pos_gain", not_set, 0, infinity},
          {"vel_gain", not_set, 0, infinity},
          {"vel_integrator_gain", 0, 0, infinity}},
         odrive}};
    return all;
}

const Servo* servo_named(const std::string& name)
{
    for (const auto& servo : servos())
        if (std::find(servo.names.begin(), servo.names.end(), name) != servo.names.end()) return &servo;
    return nullptr;
}

std::string joined(const std::vector<std::string>& names)
{
    std::string list;
    for (const auto& name : names) list += (list.empty() ? "" : ", ") + name;
    return list;
}

/// The stated registers and the defaults of others; complains about the rest.
Registers registers_of(const Servo& servo, const toml::table& control, const Place& place, Complaints& complaints)
{
    Registers r;
    std::vector<std::string> names;
    for (const auto& known : servo.registers) names.push_back(known.name), r.value[known.name] = known.standard;
    if (const auto period = control["period"].value<double>()) r.period = *period;
    const toml::node* node = control.get("registers");
    if (node && !node->is_table()) {
        complaints.add(node->source(), "control.registers", "is not a table, expected { " + joined(names) + " }");
        return r;
    }
    if (node)
        for (auto&& [key, value] : *node->as_table()) {
            const std::string name(key.str()), path = "control.registers." + name;
            const auto known = std::find_if(servo.registers.begin(), servo.registers.end(),
                                            [&](const Register& k) { return k.name == name; });
            const auto number = value.value<double>();
            if (known == servo.registers.end())
                complaints.add(key.source(), path, "is not a register of this servo, expected " + joined(names));
            else if (!number || !(*number >= known->least && *number <= known->most))
                complaints.add(
                    value.source(), path,
                    fmt::format("is {}, expected a number within [{}, {}]",
                                number ? fmt::format("{}", *number) : "no number", known->least, known->most));
            else
                r.value[name] = *number;
        }
    for (const auto& known : servo.registers)
        if (!is_set(r.value[known.name]))
            complaints.add(place, "control.registers." + known.name,
                           "is missing; registers of this servo are " + joined(names));
    return r;
}

}  // namespace

std::vector<std::string> servo_names()
{
    std::vector<std::string> names;
    for (const auto& servo : servos()) names.insert(names.end(), servo.names.begin(), servo.names.end());
    return names;
}

ServoGains servo_gains(const toml::table& root, Complaints& complaints)
{
    ServoGains gains;
    const toml::table* control = root["control"].as_table();
    if (!control) return gains;
    const toml::node* node = control->get("servo");
    if (!node) {
        if (const toml::node* registers = control->get("registers"))
            complaints.add(registers->source(), "control.registers",
                           "needs control.servo, expected " + joined(servo_names()));
        return gains;
    }
    const Place place = node->source();
    const auto name = node->value<std::string>();
    const Servo* servo = name ? servo_named(*name) : nullptr;
    if (!servo) {
        complaints.add(
            place, "control.servo",
            "is " + (name ? "\"" + *name + "\"" : std::string("no text")) + ", expected " + joined(servo_names()));
        return gains;
    }
    gains.servo = *name, gains.source = servo->source;
    if (const auto motion = root["joint"]["motion"].value<std::string>(); !motion || *motion != "revolute")
        complaints.add(place, "control.servo", "turns, but joint.motion is not \"revolute\"");
    const std::size_t before = complaints.count();
    const auto registers = registers_of(*servo, *control, place, complaints);
    if (complaints.count() > before) return gains;
    if (const auto problem = servo->convert(registers, gains); !problem.empty())
        complaints.add(place, "control.registers", problem);
    return gains;
}

std::string servo_text(const std::filesystem::path& joint_file)
{
    const auto name = joint_file.string();
    const toml::table root = parse_toml(read_text(joint_file), name);
    Complaints complaints(name);
    const auto gains = servo_gains(root, complaints);
    if (gains.servo.empty() || !complaints.empty()) return "";
    std::string list;
    for (const auto& [path, value] : gains.choices) list += (list.empty() ? "" : ", ") + path + " = " + value;
    for (const auto& [path, value] : gains.numbers)
        list += fmt::format("{}{} = {:.6g}", list.empty() ? "" : ", ", path, value);
    return "control.servo \"" + gains.servo + "\": " + list + ". Source: " + gains.source + ".";
}

}  // namespace stickslip::files
