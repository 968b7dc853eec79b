#include "analysis/simulation/sampled/closed_loop/loop_start.h"

#include <cmath>

namespace stickslip {
namespace {

constexpr double slower = 0.5;  ///< of V_0: where a start begins that nobody said more of

}  // namespace

double small_size(DisturbanceKind kind, double V0, std::complex<double> s)
{
    const double speed = small_disturbance * std::abs(V0);
    switch (kind) {
        case DisturbanceKind::start:
            return slower;
        case DisturbanceKind::position:
        case DisturbanceKind::offset:
            return speed / std::abs(s);
        case DisturbanceKind::velocity:
        case DisturbanceKind::impulse:
        case DisturbanceKind::state:
            break;
    }
    return speed;
}

Detail why_not_disturbed(const Joint& joint, DisturbanceKind kind)
{
    if (kind != DisturbanceKind::state) return Detail::none;
    const Chain chain = chain_of(joint);
    return states(*chain.body[chain.bodies - 1].friction) > 0 ? Detail::none : Detail::no_state;
}

bool disturb_loop(SampledLoop& loop, const Joint& joint, const Disturbance& disturbance)
{
    const double size = disturbance.size, V0 = loop.frame();
    if (disturbance.kind == DisturbanceKind::start) return loop.begin_slower(size);
    if (!loop.begin_steadily()) return false;
    auto& j = loop.motion.joint;
    double* y = loop.motion.y.data();
    const Chain chain = chain_of(joint);
    const int link = j.link();
    const Friction& friction = *chain.body[link].friction;
    const int first_state = j.first_state(link);
    const auto theta = steady_state(friction, V0);
    const auto r = respond(friction, V0, theta);
    const bool remembers = states(friction) > 0 && r.by_state[0] != 0;
    const auto speed_up = [&](int i, double dv) {
        const double v = j.velocity(y, i) + dv;
        if (j.logarithmic(i) && !(v > 0)) return false;
        j.set_velocity(y, i, v);
        return true;
    };
    switch (disturbance.kind) {
        case DisturbanceKind::position:
        case DisturbanceKind::offset:
            loop.displace(size);
            if (disturbance.kind == DisturbanceKind::position && remembers)
                y[first_state] -= joint.control.k_p * size / r.by_state[0];
            break;
        case DisturbanceKind::velocity: {
            if (remembers) {
                auto changed = theta;
                const double force = respond(friction, V0 + size, theta).force;
                changed[0] -= (force - r.force) / r.by_state[0];
                y[first_state] = changed[0];
            }
            for (int i = 0; i < j.bodies(); ++i)
                if (!speed_up(i, size)) return false;
            break;
        }
        case DisturbanceKind::impulse:
            if (!speed_up(link, size / chain.body[link].inertia)) return false;
            break;
        case DisturbanceKind::state:
            if (!remembers) return false;
            y[first_state] += size / r.by_state[0];
            break;
        case DisturbanceKind::start:
            break;
    }
    loop.motion.enter();
    return true;
}

}  // namespace stickslip
