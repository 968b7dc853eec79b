#include "analysis/stability/linear_friction.h"

#include <cmath>

namespace stickslip {
namespace {

void append(LinearFriction& sum, const FrictionResponse& r, int states)
{
    sum.f_v += r.by_velocity;
    for (int i = 0; i < states; ++i) {
        const int k = sum.states++;
        sum.lambda[k] = r.rate_by_state[i];
        sum.b[k] = r.rate_by_velocity[i];
        sum.h[k] = r.by_state[i];
    }
}

/// The memory that a static law carries on top, as a rate-and-state law without a level of its own.
RateAndState memory_law(const Memory& m)
{
    RateAndState law;
    law.f0 = 0;
    law.A = m.A;
    law.V_star = m.V_star;
    law.B.push_back(m.B);
    law.L.push_back(m.L);
    return law;
}

bool has_memory(const Memory& m)
{
    return m.A != 0 || m.B != 0;
}

}  // namespace

LinearFriction linearise(const Friction& friction, double V)
{
    LinearFriction linear;
    append(linear, respond(friction.law, V, steady_state(friction.law, V)), states(friction.law));
    linear.f_v += std::copysign(friction.asymmetry.viscous, V);
    if (has_memory(friction.memory)) {
        const auto law = memory_law(friction.memory);
        append(linear, law.respond(V, law.steady_state(V)), law.states());
    }
    return linear;
}

std::complex<double> transfer(const LinearFriction& friction, std::complex<double> s)
{
    std::complex<double> sum = 0;
    for (int i = 0; i < friction.states; ++i) sum += friction.weight(i) / (s - friction.lambda[i]);
    return sum;
}

double kernel_integral(const LinearFriction& friction)
{
    double sum = 0;
    for (int i = 0; i < friction.states; ++i) sum += friction.weight(i) / -friction.lambda[i];
    return sum;
}

double steady_slope(const LinearFriction& friction)
{
    return friction.f_v - kernel_integral(friction);
}

double steady_force(const Friction& friction, double V)
{
    double force =
        steady_force(friction.law, V) + friction.asymmetry.coulomb + friction.asymmetry.viscous * std::abs(V);
    if (has_memory(friction.memory)) force += memory_law(friction.memory).steady_force(V);
    return force;
}

}  // namespace stickslip
