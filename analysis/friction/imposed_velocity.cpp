#include "analysis/friction/imposed_velocity.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stickslip {
namespace {

States moved(const States& theta, double h, const States& rate, int n)
{
    States there = theta;
    for (int i = 0; i < n; ++i) there[i] += h * rate[i];
    return there;
}

/// One classical Runge-Kutta step of the states from t to t + h.
void step(const Friction& friction, const VelocityPiece& piece, double t, double h, States& theta, int n)
{
    const auto rate = [&](double at, const States& x) { return respond(friction, piece.velocity(at), x).rate; };
    const States a = rate(t, theta), b = rate(t + h / 2, moved(theta, h / 2, a, n)),
                 c = rate(t + h / 2, moved(theta, h / 2, b, n)), d = rate(t + h, moved(theta, h, c, n));
    for (int i = 0; i < n; ++i) theta[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
}

/// Steps that resolve the fastest state and the piece itself.
int steps_within(const Friction& friction, const VelocityPiece& piece, double t, double h, const States& theta, int n)
{
    constexpr double resolution = 0.02;  // of a time constant
    constexpr int least = 4, most = 100000;
    double fastest = 0;
    for (const double at : {t, t + h}) {
        const auto r = respond(friction, piece.velocity(at), theta);
        for (int i = 0; i < n; ++i) fastest = std::max(fastest, std::abs(r.rate_by_state[i]));
    }
    return std::clamp(static_cast<int>(std::min(fastest * h / resolution, double(most))), least, most);
}

}  // namespace

ImposedMotion impose_velocity(const Friction& friction, const std::vector<VelocityPiece>& pieces, int samples)
{
    const auto* kernel = std::get_if<Kernel>(&friction.law);
    const bool history = kernel ? kernel->impulses.size > 0 || kernel->samples : info(friction.law).needs_history;
    if (history) throw std::invalid_argument("delayed friction has no states to follow");
    if (samples < 2 || pieces.empty()) throw std::invalid_argument("needs at least one piece and two samples");
    const int n = states(friction);
    States theta = steady_state(friction, pieces.front().velocity(0));
    ImposedMotion motion;
    double start = 0, slip = 0;
    for (const auto& piece : pieces) {
        const auto keep = [&](double t) {
            const double V = piece.velocity(t);
            motion.time.push_back(start + t);
            motion.slip.push_back(slip);
            motion.velocity.push_back(V);
            motion.force.push_back(respond(friction, V, theta).force);
        };
        keep(0);
        const double h = piece.duration / (samples - 1);
        for (int i = 0; i + 1 < samples; ++i) {
            const double t = i * h;
            const int steps = steps_within(friction, piece, t, h, theta, n);
            for (int k = 0; k < steps; ++k) step(friction, piece, t + k * h / steps, h / steps, theta, n);
            slip += h / 6 * (piece.velocity(t) + 4 * piece.velocity(t + h / 2) + piece.velocity(t + h));
            keep(t + h);
        }
        start += piece.duration;
    }
    return motion;
}

}  // namespace stickslip
