#include "analysis/loop/delayed_loop.h"

#include <cmath>

namespace stickslip {
namespace {

/// The same row over more states.
Eigen::RowVectorXd widened(const Eigen::RowVectorXd& row, Eigen::Index size)
{
    Eigen::RowVectorXd all = Eigen::RowVectorXd::Zero(size);
    all.head(row.size()) = row;
    return all;
}

/// In s: of the actuator's lag and of the integral.
std::vector<double> poles_around(double lag, bool integrates)
{
    std::vector<double> poles;
    if (lag > 0) poles.push_back(-1 / lag);
    if (integrates) poles.push_back(0);
    return poles;
}

}  // namespace

DelayedLoop delayed_loop(const DelayedPlant& delayed, double delay, double tau, double lag, const LoopGains& base,
                         const LoopGains& turned)
{
    const auto& plant = delayed.prompt;
    const auto n = plant.A.rows();
    const bool filter = tau > 0 && (base.estimates() || turned.estimates());
    const bool integrates = base.integral != 0 || turned.integral != 0;
    const Eigen::Index size = n + filter + integrates;
    DelayedLoop loop;
    loop.delay = delay;
    loop.A = Eigen::MatrixXd::Zero(size, size);
    loop.A.topLeftCorner(n, n) = plant.A;
    loop.input = Eigen::VectorXd::Zero(size);
    loop.input.head(n) = plant.B;
    const Eigen::RowVectorXd reading = widened(plant.C, size);
    Eigen::RowVectorXd velocity = widened(plant.C_v, size), travelled = reading, sum = Eigen::RowVectorXd::Zero(size);
    if (filter) {
        travelled = Eigen::RowVectorXd::Unit(size, n);
        velocity = (reading - travelled) / tau;
        loop.A.row(n) = velocity;
    }
    if (integrates) {
        sum = Eigen::RowVectorXd::Unit(size, n + filter);
        loop.A.row(n + filter) = reading;
    }
    const auto feedback = [&](const LoopGains& g) {
        return Eigen::RowVectorXd(g.position * reading + g.velocity * velocity + g.integral * sum +
                                  g.travelled * travelled);
    };
    loop.held = -feedback(base);
    loop.output = feedback(turned);
    if (delayed.friction.empty()) return loop;
    for (auto f : delayed.friction) {
        f.push.conservativeResizeLike(Eigen::VectorXd::Zero(size));
        f.speed = widened(f.speed, size);
        loop.friction.push_back(std::move(f));
    }
    loop.mechanism_right_of = delayed.roots_right_of;
    loop.other_poles = poles_around(lag, integrates);
    if (filter) loop.other_poles.push_back(-1 / tau);
    return loop;
}

std::optional<DelayedLoop> delayed_sampled_loop(const DelayedPlant& delayed, const LoopTiming& timing, double lag,
                                                const LoopGains& base, const LoopGains& turned)
{
    const auto parts = loop_without_whole_ticks(delayed.prompt, timing, base, turned);
    if (!parts) return std::nullopt;
    DelayedLoop loop;
    loop.A = parts->loop.difference;
    loop.input = parts->loop.input;
    loop.output = parts->loop.output;
    loop.held = parts->held;
    loop.period = timing.period;
    loop.delay = parts->whole_ticks * timing.period;
    if (delayed.friction.empty()) return loop;
    loop.friction = delayed.friction;
    loop.mechanism_right_of = delayed.roots_right_of;
    const bool sums = base.integral != 0 || turned.integral != 0;
    const bool travels = timing.exact && (base.travelled != 0 || turned.travelled != 0);
    loop.other_poles = poles_around(lag, sums || travels);
    if (!timing.exact && timing.tau > 0 && (base.estimates() || turned.estimates()))
        loop.other_poles.push_back(std::log(timing.tau / (timing.tau + timing.period)) / timing.period);
    loop.ticked = std::make_shared<const TickedFriction>(TickedFriction{delayed.prompt, timing, base, turned});
    return loop;
}

}  // namespace stickslip
