// In one file: the slowest mode of a loop, by a matrix, behind a line of commands, or from the theory.
#include "analysis/simulation/sampled/closed_loop/loop_mode.h"

#include "analysis/loop/delayed_loop.h"
#include "analysis/stability/real_loop.h"
#include "analysis/stability/steady.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr std::size_t most_states = 400;     ///< whose multipliers are worth their eigenvalues
constexpr std::size_t most_on_the_way = 60;  ///< commands that are states of a matrix; more stand aside as a dead time
constexpr double difference = 1e-4;          ///< of a state's scale, on both sides
constexpr double probe = 1e-4;               ///< of the scale: small beside what bends the motion
constexpr double most_growth = 5;    ///< ln of that of a mode within a tick: what differences still are small by
constexpr long most_window = 5'000;  ///< ticks: of slow modes as much shows in fewer than a fold

/// What counts as a change of order one of each entry of SampledLoop::state().
std::vector<double> state_scale(const SampledLoop& loop, std::size_t size)
{
    const auto& joint = loop.motion.joint;
    std::vector<double> scale(joint.scale().begin(), joint.scale().begin() + joint.size());
    const double reading = scale[joint.measured()] * joint.reading_ratio();
    const double speed = std::abs(loop.reference_velocity());
    const std::size_t taps = loop.taps();
    scale.insert(scale.end(), taps, reading);
    scale.push_back(speed);
    const double effort = reading * loop.stiffness();
    if (loop.continuous()) scale.push_back(speed), scale.push_back(effort);
    if (loop.integrates()) scale.push_back(effort / std::abs(loop.integral_gain()));
    if (loop.integrates() && loop.continuous()) scale.push_back(reading);
    scale.resize(size, effort);
    return scale;
}

using Vector = std::vector<double>;

/// Friction states that answer nothing while the joint slides on: an element that slips at its yield force. Below it
/// the element is back in the time of a yield, above it is nothing, so that a displacement of it is no small motion
/// about steady sliding.
std::vector<bool> at_yield(const SampledLoop& loop)
{
    const auto& joint = loop.motion.joint;
    const auto size = static_cast<std::size_t>(joint.size());
    std::vector<double> J(size * size);
    joint.jacobian(loop.motion.y.data(), J.data());
    std::vector<bool> held(size, false);
    for (int body = 0; body < joint.bodies(); ++body)
        for (int k = 0; k < joint.states(body); ++k) {
            const auto row = J.begin() + static_cast<std::ptrdiff_t>(size) * (joint.first_state(body) + k);
            held[static_cast<std::size_t>(joint.first_state(body)) + static_cast<std::size_t>(k)] =
                std::all_of(row, row + static_cast<std::ptrdiff_t>(size), [](double x) { return x == 0; });
        }
    return held;
}

Vector after_tick(SampledLoop& loop, const Vector& state)
{
    loop.set_state(state);
    loop.tick();
    return loop.state();
}

}  // namespace

std::complex<double> LoopMode::rate() const
{
    const auto s = std::isfinite(std::abs(root)) ? root : std::log(multiplier) / period;
    return {s.real(), std::abs(s.imag())};
}

long LoopMode::window() const
{
    const auto s = rate();
    const double time = std::min(2 * std::numbers::pi / std::abs(s.imag()), std::log(3.0) / std::abs(s.real()));
    return std::clamp(std::lround(std::min(time / period, 1e15)), 1L, most_window);
}

namespace {

/// The change of the state after a tick by that of its entry `j` before it, in units of the scale, column by column.
class TickMap {
  public:
    TickMap(SampledLoop& loop, const LoopMode& mode) : loop_(loop), steady_(mode.steady)
    {
        scale = state_scale(loop, steady_.size());
        held_ = at_yield(loop);
        held_.resize(steady_.size(), false);
    }
    Vector scale;

    Eigen::VectorXd column(std::size_t j)
    {
        const auto n = steady_.size();
        Eigen::VectorXd changed = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(n));
        if (held_[j]) return changed;
        Vector up = steady_, down = steady_;
        up[j] += difference * scale[j], down[j] -= difference * scale[j];
        const double change = (up[j] - down[j]) / scale[j];
        const Vector a = after_tick(loop_, up), b = after_tick(loop_, down);
        for (std::size_t i = 0; i < n; ++i)
            if (!held_[i]) changed[static_cast<Eigen::Index>(i)] = (a[i] - b[i]) / scale[i] / change;
        return changed;
    }

  private:
    SampledLoop& loop_;
    const Vector& steady_;
    std::vector<bool> held_;
};

void take_vectors(const Eigen::VectorXcd& right, const Eigen::VectorXcd& left, const Vector& scale, LoopMode& mode)
{
    for (std::size_t i = 0; i < scale.size(); ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        mode.right.push_back(right[k] * scale[i]);
        mode.left.push_back(left[k] / scale[i]);
    }
}

/// Commands on their way only move on: z h = H h + (a + b z) l, z^n l = c h, of the other states h, the oldest command
/// l and n commands. That is a loop behind n ticks of dead time.
void find_behind_line(TickMap& map, std::size_t others, std::size_t commands, LoopMode& mode)
{
    using Complex = std::complex<double>;
    const auto m = static_cast<Eigen::Index>(others);
    Eigen::MatrixXd H(m, m);
    Eigen::RowVectorXd c(m);
    for (Eigen::Index j = 0; j < m; ++j) {
        const Eigen::VectorXd column = map.column(static_cast<std::size_t>(j));
        H.col(j) = column.head(m);
        c[j] = column[column.size() - 1];
    }
    const Eigen::VectorXd a = map.column(others).head(m), b = map.column(others + 1).head(m);
    if (!H.allFinite() || !c.allFinite() || !a.allFinite() || !b.allFinite()) {
        mode.why = Detail::leaves_within_tick;
        return;
    }
    DelayedLoop loop;
    loop.period = mode.period;
    loop.A = Eigen::MatrixXd::Zero(m + 1, m + 1);
    loop.A.topLeftCorner(m, m) = H - Eigen::MatrixXd::Identity(m, m);
    loop.A.col(m).head(m) = a;
    loop.A(m, m) = -1;
    loop.input = Eigen::VectorXd::Unit(m + 1, m);
    loop.input.head(m) = b;
    loop.held = Eigen::RowVectorXd::Zero(m + 1);
    loop.output = loop.held;
    loop.output.head(m) = -c;
    loop.delay = static_cast<double>(commands - 1) * mode.period;
    const auto root = rightmost_root(loop, 1);
    if (!root) {
        mode.why = Detail::dead_time_too_long;
        return;
    }
    const Complex z = std::exp(*root * mode.period), passed = std::exp(-*root * (loop.delay + mode.period));
    mode.multiplier = z;
    Eigen::MatrixXcd closed = H.cast<Complex>() + (a.cast<Complex>() + b.cast<Complex>() * z) * (passed * c);
    closed.diagonal().array() -= z;
    const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(closed, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const auto size = m + static_cast<Eigen::Index>(commands);
    Eigen::VectorXcd right(size), left(size);
    right.head(m) = svd.matrixV().col(m - 1);
    left.head(m) = svd.matrixU().col(m - 1).conjugate();
    Complex on_the_way = (passed * c * right.head(m))(0), felt = 0;
    for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(commands); ++i, on_the_way *= z) {
        right[m + i] = on_the_way;
        // what the oldest command does to the rest, and the one behind it, in which dead time ends within a tick
        if (i == 0) felt = (left.head(m).transpose() * a)(0);
        if (i == 1) felt += (left.head(m).transpose() * b)(0);
        felt /= z;
        left[m + i] = felt;
    }
    take_vectors(right, left, map.scale, mode);
}

void find_in_matrix(TickMap& map, std::size_t n, LoopMode& mode)
{
    Eigen::MatrixXd M(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
    for (std::size_t j = 0; j < n; ++j) M.col(static_cast<Eigen::Index>(j)) = map.column(j);
    if (!M.allFinite()) {
        mode.why = Detail::leaves_within_tick;
        return;
    }
    const Eigen::EigenSolver<Eigen::MatrixXd> right(M), left(M.transpose());
    Eigen::Index best = 0, same = 0;
    for (Eigen::Index i = 1; i < right.eigenvalues().size(); ++i)
        if (std::abs(right.eigenvalues()[i]) > std::abs(right.eigenvalues()[best])) best = i;
    const auto z = right.eigenvalues()[best];
    for (Eigen::Index i = 1; i < left.eigenvalues().size(); ++i)
        if (std::abs(left.eigenvalues()[i] - z) < std::abs(left.eigenvalues()[same] - z)) same = i;
    mode.multiplier = z;
    take_vectors(right.eigenvectors().col(best), left.eigenvectors().col(same), map.scale, mode);
}

}  // namespace

bool leaves_within_tick(std::complex<double> root, double period)
{
    return root.real() * period > most_growth;
}

LoopMode mode_by_theory(std::complex<double> root, double period)
{
    LoopMode mode;
    mode.period = period;
    mode.root = root;
    mode.multiplier = std::exp(root * period);
    if (!mode.known()) mode.why = std::isinf(root.real()) ? Detail::leaves_within_tick : Detail::growth_unmeasured;
    return mode;
}

LoopMode loop_mode(SampledLoop& loop)
{
    LoopMode mode;
    mode.period = loop.period();
    mode.steady = loop.state();
    const auto n = mode.steady.size(), commands = loop.commands_on_the_way();
    const bool aside = commands > most_on_the_way;
    if (n - (aside ? commands : 0) > most_states) {
        mode.why = Detail::dead_time_too_long;
        return mode;
    }
    TickMap map(loop, mode);
    if (aside)
        find_behind_line(map, n - commands, commands, mode);
    else
        find_in_matrix(map, n, mode);
    loop.set_state(mode.steady);
    return mode;
}

double measure_loop_growth(SampledLoop& loop, const LoopMode& mode)
{
    if (!mode.known()) return missing;
    const std::size_t n = mode.steady.size();
    const long window = mode.window();
    const auto size = [&](const Vector& up, const Vector& down) {
        std::complex<double> sum = 0;
        for (std::size_t i = 0; i < n; ++i) sum += mode.left[i] * (up[i] - down[i]);
        return std::abs(sum);
    };
    const auto rate_of = [&](double share) {
        Vector up = mode.steady, down = mode.steady;
        for (std::size_t i = 0; i < n; ++i)
            up[i] += share * mode.right[i].real(), down[i] -= share * mode.right[i].real();
        const double before = size(up, down);
        for (Vector* side : {&up, &down}) {
            loop.set_state(*side);
            for (long k = 0; k < window; ++k) loop.tick();
            *side = loop.state();
        }
        return std::log(size(up, down) / before) / (static_cast<double>(window) * mode.period);
    };
    // even powers of the disturbance cancel between the sides, the third between the sizes
    const double half = rate_of(0.5 * probe), whole = rate_of(probe);
    loop.set_state(mode.steady);
    return (4 * half - whole) / 3;
}

}  // namespace stickslip
