#include "analysis/friction/friction.h"

namespace stickslip {
namespace {

/// A static law in two parts: the level, which bristles may carry, and the viscous slope. Nothing for other laws.
struct StaticParts {
    Level level;
    double viscous;
};
std::optional<StaticParts> static_parts(const FrictionLaw& law, double speed)
{
    return std::visit(
        [speed](const auto& l) -> std::optional<StaticParts> {
            if constexpr (requires { l.static_force(), l.level(speed); }) {
                const Level level = l.level(speed);
                return StaticParts{level, l.respond(speed, {}).by_velocity - level.slope};
            }
            return std::nullopt;
        },
        law);
}

/// Appends a state that follows its own evolution.
void append(FrictionResponse& r, int i, double by_state, double rate, double rate_by_velocity, double rate_by_state)
{
    r.by_state[i] = by_state;
    r.rate[i] = rate;
    r.rate_by_velocity[i] = rate_by_velocity;
    r.rate_by_state[i] = rate_by_state;
}

/// The law with its level at the lagged speed s, which is state i.
FrictionResponse lagged_response(const StaticParts& lagged, double lag, double V, double s, int i)
{
    const double direction = std::copysign(1.0, V);
    FrictionResponse r = slide({lagged.level.value, 0}, lagged.viscous, V);
    append(r, i, direction * lagged.level.slope, (std::abs(V) - s) / lag, direction / lag, -1 / lag);
    return r;
}

/// The law whose force s, state i, follows the curve late.
FrictionResponse delayed_response(const StaticParts& now, double lag, double V, double s, int i)
{
    const double direction = std::copysign(1.0, V);
    FrictionResponse r = slide({s, 0}, 0, V);
    const double curve = now.level.value + now.viscous * std::abs(V), slope = now.level.slope + now.viscous;
    append(r, i, direction, (curve - s) / lag, direction * slope / lag, -1 / lag);
    return r;
}

/// The memory's contact on top of a law; `level` is what the law itself and the memory's state resist.
RegularisedForce memory_contact(const Memory& m, double level, double V)
{
    if (m.A > 0) return regularised_force(m.A, m.V_star, level, V);
    const double direction = V == 0 ? 0 : std::copysign(1.0, V);
    return {direction * level, 0, direction};
}

/// Puts the memory on top of a law's response; its state is number i.
void remember(FrictionResponse& r, const Memory& m, double V, double theta, int i)
{
    const double direction = std::copysign(1.0, V), speed = std::abs(V);
    const auto contact = memory_contact(m, direction * r.force + theta, V);
    const double passed_on = contact.by_level * direction;  // ∂/∂f of what the law itself resists
    r.force = contact.force;
    r.by_velocity = contact.by_velocity + passed_on * r.by_velocity;
    for (int k = 0; k < i; ++k) r.by_state[k] *= passed_on;
    const auto change = evolve(m.form, m.B, m.L, m.V_star, speed, theta);
    append(r, i, contact.by_level, change.rate, direction * change.by_speed, change.by_state);
}

}  // namespace

double PositionRipple::by_place(double q) const
{
    return amplitude * periods * std::cos(periods * q + phase) +
           2 * second_amplitude * periods * std::cos(2 * periods * q + second_phase);
}

int states(const Friction& friction)
{
    return states(friction.law) + friction.has_lag() + (friction.has_bristle() || friction.has_memory());
}

bool has_response(const Friction& friction)
{
    if (friction.has_bristle() && (friction.has_memory() || friction.has_lag())) return false;
    return !(friction.has_bristle() || friction.has_memory() || friction.has_lag()) || friction.problem().empty();
}

States steady_state(const Friction& friction, double V)
{
    States theta = steady_state(friction.law, V);
    int next = states(friction.law);
    const double speed = std::abs(V);
    if (friction.has_lag())
        theta[next++] = friction.memory.lag_viscous ? std::abs(steady_force(friction.law, speed)) : speed;
    if (friction.has_bristle()) {
        if (const auto parts = static_parts(friction.law, speed))
            theta[next] = slide(parts->level, 0, V).force / friction.bristle.stiffness;
    } else if (friction.has_memory()) {
        theta[next] = -friction.memory.B * std::log(speed / friction.memory.V_star);
    }
    return theta;
}

FrictionResponse respond(const Friction& friction, double V, const States& theta)
{
    FrictionResponse r = respond(friction.law, V, theta);
    int next = states(friction.law);
    if (friction.has_lag()) {
        const Memory& m = friction.memory;
        if (const auto parts = static_parts(friction.law, m.lag_viscous ? std::abs(V) : theta[next]))
            r = m.lag_viscous ? delayed_response(*parts, m.lag, V, theta[next], next)
                              : lagged_response(*parts, m.lag, V, theta[next], next);
        ++next;
    }
    if (friction.has_bristle()) {
        if (const auto parts = static_parts(friction.law, std::abs(V)))
            r = bristle_response({friction.bristle.stiffness, friction.bristle.damping}, parts->level, parts->viscous,
                                 V, theta[next]);
    } else if (friction.has_memory()) {
        remember(r, friction.memory, V, theta[next], next);
    }
    r.force += friction.asymmetry.coulomb + friction.asymmetry.viscous * std::abs(V);
    r.by_velocity += V < 0 ? -friction.asymmetry.viscous : friction.asymmetry.viscous;
    // the states stay as they are: contacts of one law under more load are more of the same contacts
    r.force *= friction.normal_load;
    r.by_velocity *= friction.normal_load;
    for (double& slope : r.by_state) slope *= friction.normal_load;
    return r;
}

double steady_force(const Friction& friction, double V)
{
    if (friction.has_memory()) return respond(friction, V, steady_state(friction, V)).force;
    const double f =
        steady_force(friction.law, V) + friction.asymmetry.coulomb + friction.asymmetry.viscous * std::abs(V);
    return friction.normal_load * f;
}

double static_force(const Friction& friction)
{
    return friction.normal_load * static_force(friction.law);
}

std::string Friction::problem() const
{
    if ((has_bristle() || has_lag()) && !static_parts(law, 1))
        return std::string(has_bristle() ? "bristle" : "memory.lag") +
               " needs a static law (coulomb-viscous, kinetic-static or stribeck), got " + std::string(info(law).name);
    if (stickslip::states(*this) > max_states)
        return "the law and its memory have more than " + std::to_string(max_states) + " states";
    return "";
}

}  // namespace stickslip
