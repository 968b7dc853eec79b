#include "analysis/stability/linear_friction.h"

#include <cmath>
#include <limits>

namespace stickslip {
namespace {

using Complex = std::complex<double>;

DelayList delays_of(const FrictionLaw& law, double V)
{
    return std::visit(
        [V](const auto& l) {
            if constexpr (requires { l.delays(V); }) return l.delays(V);
            return DelayList{};
        },
        law);
}

KernelTablePtr table_of(const FrictionLaw& law)
{
    return std::visit(
        [](const auto& l) {
            if constexpr (requires { l.table(); }) return l.table();
            return KernelTablePtr{};
        },
        law);
}

}  // namespace

LinearFriction linearise(const Friction& friction, double V)
{
    LinearFriction linear;
    const auto r = respond(friction, V, steady_state(friction, V));
    linear.f_v = r.by_velocity;
    for (int i = 0; i < states(friction); ++i) {
        if (r.rate_by_velocity[i] == 0 && r.rate_by_state[i] == 0) continue;
        const int k = linear.states++;
        linear.lambda[k] = r.rate_by_state[i];
        linear.b[k] = r.rate_by_velocity[i];
        linear.h[k] = r.by_state[i];
    }
    if (info(friction.law).needs_history) {
        // a flat piece of a delayed curve remembers nothing: no search has to find that out band by band
        for (const auto& d : delays_of(friction.law, V))
            if (d.weight != 0) linear.delays.push_back({friction.normal_load * d.weight, d.time});
        linear.table = table_of(friction.law);
        linear.table_scale = friction.normal_load;
    }
    return linear;
}

LinearFriction scaled(LinearFriction friction, double factor)
{
    friction.f_v *= factor;
    for (int i = 0; i < friction.states; ++i) friction.h[i] *= factor;
    for (auto& d : friction.delays) d.weight *= factor;
    friction.table_scale *= factor;
    return friction;
}

LinearFriction reflected(LinearFriction friction, double N)
{
    for (int i = 0; i < friction.states; ++i) friction.b[i] *= N;
    friction = scaled(std::move(friction), N);
    // what is no state has had one N, from the force; the other comes with the velocity
    friction.f_v *= N;
    for (auto& d : friction.delays) d.weight *= N;
    friction.table_scale *= N;
    return friction;
}

Complex transfer(const LinearFriction& friction, Complex s)
{
    Complex sum = 0;
    for (int i = 0; i < friction.states; ++i) sum += friction.weight(i) / (s - friction.lambda[i]);
    for (const auto& d : friction.delays) sum += d.weight * std::exp(-s * d.time);
    if (friction.table) sum += friction.table_scale * friction.table->transform(s);
    return sum;
}

Complex transfer_slope(const LinearFriction& friction, Complex s)
{
    Complex sum = 0;
    for (int i = 0; i < friction.states; ++i) {
        const Complex gap = s - friction.lambda[i];
        sum -= friction.weight(i) / (gap * gap);
    }
    for (const auto& d : friction.delays) sum -= d.weight * d.time * std::exp(-s * d.time);
    if (friction.table) sum += friction.table_scale * friction.table->transform_slope(s);
    return sum;
}

double kernel_integral(const LinearFriction& friction)
{
    double sum = 0;
    for (int i = 0; i < friction.states; ++i) sum += friction.weight(i) / -friction.lambda[i];
    for (const auto& d : friction.delays) sum += d.weight;
    if (friction.table) sum += friction.table_scale * friction.table->transform(0).real();
    return sum;
}

double steady_slope(const LinearFriction& friction)
{
    // where memory undoes the direct effect, rounding is left over
    constexpr double roundings = 8;
    const double memory = kernel_integral(friction), slope = friction.f_v - memory;
    const double least =
        roundings * std::numeric_limits<double>::epsilon() * (std::abs(friction.f_v) + std::abs(memory));
    return std::abs(slope) > least ? slope : 0;
}

}  // namespace stickslip
