#include "analysis/design/noise.h"

#include "analysis/joint/gains.h"
#include "analysis/stability/characteristic.h"
#include "analysis/stability/joint_spectrum.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>

namespace stickslip {
namespace {

constexpr double integral_precision = 1e-6;
constexpr unsigned deepest = 10;  ///< halvings of a piece of the integral
constexpr double highest = 20;    ///< times the Nyquist frequency, beyond which the held noise moves nothing

/// X_link/U(s) of the closed loop: where the command's noise enters is where the controller acts.
Complex command_response(const LinearJoint& j, Complex s)
{
    std::array<Complex, max_bodies> resistance, scale;
    for (int i = 0; i < j.bodies; ++i) resistance[i] = j.friction[i].f_v - transfer(j.friction[i], s), scale[i] = 1;
    const auto open = open_loop_matrix<Complex>(j, s, resistance, scale);
    Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, 0, max_bodies, max_bodies> Z(j.bodies, j.bodies);
    Eigen::Matrix<Complex, Eigen::Dynamic, 1, 0, max_bodies, 1> u(j.bodies);
    for (int i = 0; i < j.bodies; ++i) {
        u[i] = j.actuated[i];
        for (int k = 0; k < j.bodies; ++k) Z(i, k) = open[i][k];
        Z(i, j.measured) += (j.k_p + j.k_v * s) * j.actuated[i];
    }
    if (j.bodies == 1) return u[0] / Z(0, 0);
    return Z.partialPivLu().solve(u)[j.link()];
}

/// Transfer of one sampled velocity estimate: its filter, and the difference of averaged positions before it.
struct Estimate {
    Complex filter, difference;

    Estimate(const SensorNoise& n, double phase)
    {
        const Complex back = std::exp(Complex(0, -phase));  // z⁻¹
        const double a = n.period / (n.filter + n.period);
        filter = a / (1.0 - (1 - a) * back);
        Complex mean = 0, shifted = 1;
        for (int i = 0; i < static_cast<int>(n.average); ++i, shifted *= back) mean += shifted / n.average;
        difference = (1.0 - back) / n.period * mean;
    }
};

/// Variance of a sample of the command per radian of phase.
double command_spectrum(const Gains& g, const SensorNoise& n, double phase)
{
    const Estimate e(n, phase);
    const double x = n.position * n.position;
    // only a loop that integrates has a period in which it sums
    const Complex sum = g.k_i == 0 ? Complex(0) : g.k_i * n.period / (1.0 - std::exp(Complex(0, -phase)));
    if (is_set(n.velocity))
        return x * std::norm(g.k_p + sum) + n.velocity * n.velocity * g.k_v * g.k_v * std::norm(e.filter);
    return x * std::norm(g.k_p + sum + g.k_v * e.filter * e.difference);
}

/// Over pieces within which f is smooth.
template <class Function>
double integral(const Function& f, const std::vector<double>& breaks, unsigned halvings = deepest)
{
    using Rule = boost::math::quadrature::gauss_kronrod<double, 15>;
    double sum = 0;
    for (std::size_t i = 1; i < breaks.size(); ++i)
        if (breaks[i] > breaks[i - 1])
            sum += Rule::integrate(f, breaks[i - 1], breaks[i], halvings, integral_precision);
    return sum;
}

/// Cuts ln ω at every resonance and its flanks.
class Breaks {
  public:
    Breaks(double low, double high) : low_(low), high_(high), at_{std::log(low), std::log(high)} {}

    void cut(double omega)
    {
        if (omega > low_ && omega < high_) at_.push_back(std::log(omega));
    }
    void cut(const std::vector<Complex>& roots)
    {
        for (const auto& s : roots) {
            const double omega = std::abs(s.imag()), width = std::abs(s.real());
            cut(std::abs(s));
            for (const double k : {-8.0, -2.0, 0.0, 2.0, 8.0}) cut(omega + k * width);
        }
    }
    std::vector<double> sorted()
    {
        std::sort(at_.begin(), at_.end());
        return at_;
    }

  private:
    double low_, high_;
    std::vector<double> at_;
};

/// |s| of the slowest root; NaN where one does not decay.
double slowest_of(const std::vector<Complex>& roots)
{
    double slowest = infinity;
    for (const auto& s : roots) {
        if (!(s.real() < 0)) return missing;
        slowest = std::min(slowest, std::abs(s));
    }
    return slowest;
}

/// rms motion of the link per noise of a held command, G the motion per command at iω.
template <class Response>
double held_noise(const Gains& gains, const SensorNoise& n, const std::vector<Complex>& roots, const Response& G)
{
    const double slowest = slowest_of(roots);
    if (std::isnan(slowest)) return missing;
    const double nyquist = std::numbers::pi / n.period;
    const double low = std::min(1e-3 * slowest, 1e-3 * nyquist), high = highest * nyquist;
    const auto density = [&](double omega) {
        const double half = omega * n.period / 2, held = half > 1e-8 ? std::sin(half) / half : 1;
        return std::norm(G(omega)) * n.period * held * held * command_spectrum(gains, n, omega * n.period);
    };
    Breaks breaks(low, high);
    breaks.cut(roots);
    for (int k = 1; k < highest; ++k) breaks.cut(k * nyquist);
    const double above = integral([&](double l) { return std::exp(l) * density(std::exp(l)); }, breaks.sorted());
    return std::sqrt((density(low) * low + above) / std::numbers::pi);
}

double held_effort(const Gains& gains, const SensorNoise& n)
{
    constexpr double pi = std::numbers::pi;
    const std::vector<double> breaks{1e-9, pi / 64, pi / 16, pi / 4, pi / 2, pi};
    return std::sqrt(integral([&](double phase) { return command_spectrum(gains, n, phase); }, breaks) / pi);
}

}  // namespace

double motion_noise(const LinearJoint& j, const SensorNoise& n)
{
    return held_noise({j.k_p, j.k_v, 0}, n, spectrum(j),
                      [&](double omega) { return command_response(j, Complex(0, omega)); });
}

double effort_noise(const LinearJoint& j, const SensorNoise& n)
{
    return held_effort({j.k_p, j.k_v, 0}, n);
}

LoopNoise loop_noise(const Joint& joint, const LoopResponse& response, const SensorNoise& n, NoiseOf asked)
{
    const bool moves = asked != NoiseOf::effort, acts = asked != NoiseOf::motion;
    const Gains gains = gains_of(joint.control);
    const double slowest = slowest_of(response.roots());
    if (std::isnan(slowest) || !(response.growth() < 0)) return {};
    if (response.period() == 0) {
        const auto motion = [&](double omega) { return response.by_command(omega).motion; };
        return {moves ? held_noise(gains, n, response.roots(), motion) : missing,
                acts ? held_effort({gains.k_p, gains.k_v, 0}, n) : missing};
    }
    // over the phase of a tick, by its logarithm as slow roots are far below a tick's rate
    const double T = response.period(), high = std::numbers::pi / T, low = std::min(1e-3 * slowest, 1e-3 * high);
    Breaks breaks(low, high);
    breaks.cut(response.roots());
    const auto at = breaks.sorted();
    const unsigned halvings = response.sums_aliases() ? 0 : deepest;  // the pieces are narrow, and a place is slow
    const auto rms = [&](const auto& G) {
        const auto density = [&](double omega) {
            return std::norm(G(omega)) * T * command_spectrum(gains, n, omega * T);
        };
        const double above = integral([&](double l) { return std::exp(l) * density(std::exp(l)); }, at, halvings);
        return std::sqrt((density(low) * low + above) / std::numbers::pi);
    };
    return {moves ? rms([&](double omega) { return response.by_command(omega).motion; }) : missing,
            acts ? rms([&](double omega) { return response.by_command(omega).remains; }) : missing};
}

}  // namespace stickslip
