#include "sweep/words/export_text.h"

#include "analysis/results/text.h"

#include <fmt/format.h>

namespace stickslip {
namespace {

std::string delay_text(const ExportAnswer& answer)
{
    const auto steps = fmt::format("{:g} s are {} step{} of {:g} s", answer.joint.delay, answer.delay_steps,
                                   answer.delay_steps == 1 ? "" : "s", answer.timestep);
    switch (answer.to) {
        case Simulator::mjcf:
            return steps +
                   "; delay= of an actuator delays the target, not the feedback inside position and velocity "
                   "servos: "
                   "close the loop outside and use the <motor> in the comment, whose delay acts on the effort";
        case Simulator::isaaclab:
            return steps +
                   "; DelayedPDActuatorCfg delays the target by that, the feedback is not delayed: close the loop "
                   "in "
                   "your own actuator class for the dead time of the joint file";
        case Simulator::ros2_control:
            return "dead time belongs to the hardware, not to the controller's parameters";
        default:
            return steps + "; delay the command by that in your own controller";
    }
}

std::string friction_text(Simulator to, Lost why)
{
    const std::string name = simulator_name(to);
    switch (why) {
        case Lost::static_rise:
            return name +
                   " has one level for rest and motion: friction above the Coulomb level at rest and low speed is lost";
        case Lost::memory:
            return name + " has no friction that remembers: the level is that of steady sliding, its memory is lost";
        case Lost::presliding:
            return name + " has no elastic presliding: only the level of sliding is kept";
        case Lost::direction:
            return name + " has the same friction in both directions; the mean of both is kept";
        case Lost::position_dependent:
            return name + " has no force locked to position; apply it from your own code at each step";
        case Lost::time_dependent:
            return name + " has no force that changes with time; apply it from your own code at each step";
        default:
            return name + " has no friction that grows with the transmitted effort";
    }
}

std::string loop_text(Simulator to, Lost why)
{
    const std::string name = simulator_name(to);
    switch (why) {
        case Lost::gains_elsewhere:
            return name + " describes the mechanism, not its controller; export --to ros2_control writes the gains";
        case Lost::mechanism_elsewhere:
            return name + " describes the controller, not the mechanism; export --to urdf, sdf or mjcf writes it";
        case Lost::lag:
            return name + " has no lag between the effort that is commanded and the one that acts";
        case Lost::sampling:
            return "the loop runs at the simulator's time step, not at the controller's period";
        case Lost::estimate:
            return name + " feeds back the true velocity, not the controller's filtered estimate";
        case Lost::sensor:
            return name +
                   " feeds back the true position: noise, quantisation and errors of the encoder are not in the loop";
        case Lost::feedback_side:
            return "a servo here measures the body that it drives; close the loop on the link outside and command the "
                   "motor's effort";
        case Lost::integral:
            return name + " takes gains on the error and its rate; integrate in a controller of your own";
        case Lost::feed_forward:
            return name + " adds nothing for the motion that is commanded; add it to the commanded effort yourself";
        case Lost::supply:
            return "the limit is kept as a constant effort, without its dependence on speed and current";
        default:
            return "only position control is exported";
    }
}

}  // namespace

std::string simulator_name(Simulator to)
{
    switch (to) {
        case Simulator::mjcf:
            return "MuJoCo";
        case Simulator::urdf:
            return "URDF";
        case Simulator::sdf:
            return "SDF";
        case Simulator::isaaclab:
            return "Isaac Lab";
        case Simulator::ros2_control:
            return "ros2_control";
    }
    return "";
}

std::string gap_left_text(const ExportAnswer& answer)
{
    const GapLeft& left = *answer.gap_left;
    const bool stepped = answer.to != Simulator::ros2_control;
    std::string text =
        fmt::format("On these records the text{} leaves {:.3g} × the noise floor, the joint {:.3g} ×",
                    stepped ? fmt::format(", in steps of {:g} s,", answer.timestep) : "", left.text, left.joint);
    for (const auto& s : left.signals)
        text += fmt::format("\n  {}: {:.3g} {} by the text, {:.3g} by the joint, {:.3g} is noise", s.signal, s.text,
                            s.unit, s.joint, s.floor);
    return text;
}

std::string lost_text(const ExportAnswer& answer, const NotExpressible& lost)
{
    switch (lost.why) {
        case Lost::no_element:
            return simulator_name(answer.to) + " has no element for it";
        case Lost::from_the_robot:
            return "inertia and gravity come from the robot's own asset";
        case Lost::joined_to_link:
            return fmt::format(
                "{} has no rotor inertia: N²·J is part of the link's here; on a moving arm it resists this axis only",
                simulator_name(answer.to));
        case Lost::hardening:
            return "springs of " + simulator_name(answer.to) + " are linear";
        case Lost::rigid:
            return simulator_name(answer.to) + " has no spring between motor and link: both move as one";
        case Lost::three_bodies:
            return "the middle body joined the motor, its spring on the motor's side is rigid";
        case Lost::backlash:
            return simulator_name(answer.to) +
                   " takes two joints for it in the robot's asset: export --to mjcf, urdf or sdf writes them";
        case Lost::damped_gap:
            return "the damping of a tendon acts within the backlash, too, that of the joint only where its flanks "
                   "touch";
        case Lost::delay_of_target:
            return delay_text(answer);
        case Lost::static_rise:
        case Lost::memory:
        case Lost::presliding:
        case Lost::direction:
        case Lost::position_dependent:
        case Lost::time_dependent:
        case Lost::load_dependent:
            return friction_text(answer.to, lost.why);
        default:
            return loop_text(answer.to, lost.why);
    }
}

std::string read_at_text(const SimulatorJoint& joint)
{
    const double speed = joint.friction().speed;
    if (!(speed > 0)) return "";
    const auto at = "Friction is read at " + with_unit(speed, Quantity::velocity, Units(joint.motion));
    return at + (joint.speed_assumed ? ", as neither --speed nor a velocity of sliding (control.V0) is given: its law "
                                       "states no Coulomb level"
                                     : ": its law states no Coulomb level");
}

}  // namespace stickslip
