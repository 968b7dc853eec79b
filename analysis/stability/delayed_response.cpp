#include "analysis/stability/delayed_response.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <unsupported/Eigen/MatrixFunctions>

#include "analysis/stability/joint_spectrum.h"

namespace stickslip {
namespace {

constexpr int nodes = 4;          ///< of the cubic in a step
constexpr double resolved = 0.1;  ///< of the fastest rate, per step: what was fast comes back late
constexpr double inside = 1e-9;   ///< share of a step by which its ends look inwards, where history has a kink

/// Delayed force on a body: `velocity`, `position` or `area` (∫x dt) of that body, `time` ago, times `weight`.
struct DelayedTerm {
    int body;
    double time, velocity, position, area;
};

/// y' = A y + Σ b (delayed terms): y of state_matrix and, for each body, the area ∫x dt behind it. Twice integrated by
/// parts, ∫g(t') v(t − t') dt' of straight lines is a sum over the bends of g.
struct DelayedSystem {
    Eigen::MatrixXd A;
    std::array<int, max_bodies> area{};  ///< index of ∫x dt
    std::vector<DelayedTerm> terms;
};

DelayedSystem delayed_system(const LinearJoint& j)
{
    DelayedSystem s;
    const Eigen::MatrixXd inner = state_matrix(j);
    Eigen::Index n = inner.rows();
    s.A = Eigen::MatrixXd::Zero(n + j.bodies, n + j.bodies);
    s.A.topLeftCorner(n, n) = inner;
    for (int i = 0; i < j.bodies; ++i, ++n) {
        s.area[i] = static_cast<int>(n);
        s.A(n, i) = 1;
        for (const auto& d : j.friction[i].delays) s.terms.push_back({i, d.time, d.weight, 0, 0});
        if (!j.friction[i].table) continue;
        const auto& g = *j.friction[i].table;
        const double scale = j.friction[i].table_scale;
        double slope = 0;
        for (std::size_t k = 0; k + 1 < g.time.size(); ++k) {
            const double next = (g.value[k + 1] - g.value[k]) / (g.time[k + 1] - g.time[k]);
            if (k == 0) {
                s.A(j.bodies + i, i) += scale * g.value[0] / j.inertia[i];
                s.A(j.bodies + i, n) += scale * next / j.inertia[i];
            } else if (next != slope) {
                s.terms.push_back({i, g.time[k], 0, 0, scale * (next - slope)});
            }
            slope = next;
        }
        s.terms.push_back({i, g.time.back(), 0, -scale * g.value.back(), -scale * slope});
    }
    return s;
}

/// The motion so far; at rest before the start.
class History {
  public:
    History(int bodies, const std::array<int, max_bodies>& area) : bodies_(bodies), area_(area) {}

    void add(double t, const Eigen::VectorXd& y, const Eigen::VectorXd& left, const Eigen::VectorXd& right)
    {
        time_.push_back(t);
        y_.push_back(y);
        left_.push_back(left);
        right_.push_back(right);
    }
    double delayed(const DelayedTerm& term, double t) const
    {
        if (t < 0 || time_.size() < 2) return 0;
        const auto after = std::upper_bound(time_.begin(), time_.end(), t) - time_.begin();
        const auto k = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after, 1, std::ssize(time_) - 1)) - 1;
        const double h = time_[k + 1] - time_[k], u = (t - time_[k]) / h;
        const auto between = [&](int i) {
            const double d = y_[k + 1][i] - y_[k][i], a = h * right_[k][i] - d, b = d - h * left_[k + 1][i];
            return y_[k][i] + u * (d + (1 - u) * ((1 - u) * a + u * b));
        };
        double sum = 0;
        if (term.velocity != 0) sum += term.velocity * between(bodies_ + term.body);
        if (term.position != 0) sum += term.position * between(term.body);
        if (term.area != 0) sum += term.area * between(area_[term.body]);
        return sum;
    }

  private:
    int bodies_;
    std::array<int, max_bodies> area_;
    std::vector<double> time_;
    std::vector<Eigen::VectorXd> y_, left_, right_;  ///< slopes from both sides: the force may jump between
};

/// What one step of length h does to the state, to a force held on each body, and to (t/h)^p of it.
struct StepMatrices {
    Eigen::MatrixXd state;
    std::array<Eigen::MatrixXd, nodes> power;  ///< a column a body
};

StepMatrices step_matrices(const LinearJoint& j, const Eigen::MatrixXd& A, double h)
{
    const Eigen::Index n = A.rows();
    StepMatrices m;
    m.state = (A * h).exp();
    double factorial = 1;
    for (int p = 0; p < nodes; ++p) {
        if (p > 0) factorial *= p;
        m.power[p] = Eigen::MatrixXd::Zero(n, j.bodies);
        for (int i = 0; i < j.bodies; ++i) {
            // behind the state a chain of integrators, whose last is constant
            Eigen::MatrixXd chain = Eigen::MatrixXd::Zero(n + p + 1, n + p + 1);
            chain.topLeftCorner(n, n) = A * h;
            chain(j.bodies + i, n) = h / j.inertia[i];
            for (int k = 0; k < p; ++k) chain(n + k, n + k + 1) = 1;
            m.power[p].col(i) = factorial * chain.exp().block(0, n + p, n, 1);
        }
    }
    return m;
}

/// Coefficients of the cubic through values at 0, 1/3, 2/3 and 1.
std::array<double, nodes> cubic(const std::array<double, nodes>& f)
{
    return {f[0], -5.5 * f[0] + 9 * f[1] - 4.5 * f[2] + f[3], 9 * f[0] - 22.5 * f[1] + 18 * f[2] - 4.5 * f[3],
            -4.5 * f[0] + 13.5 * f[1] - 13.5 * f[2] + 4.5 * f[3]};
}

/// Where steps must end beside the force's samples.
std::vector<double> kinks(const std::vector<DelayedTerm>& terms, double end)
{
    std::vector<double> all;
    for (const auto& a : terms) {
        if (a.velocity == 0) continue;
        all.push_back(a.time);
        for (const auto& b : terms)
            if (b.velocity != 0) all.push_back(a.time + b.time);
    }
    std::erase_if(all, [&](double t) { return t >= end; });
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace

// In one piece: the method of steps, with its history as local state.
ForcedResponse delayed_response(const LinearJoint& j, const SampledForce& force)
{
    const auto system = delayed_system(j);
    const int link = j.link();
    double longest = force.step;
    for (const auto& term : system.terms) longest = std::min(longest, term.time);
    const Eigen::VectorXcd modes = system.A.eigenvalues();
    longest = std::min(longest, resolved / modes.cwiseAbs().maxCoeff());

    std::map<double, StepMatrices> known;
    const auto matrices = [&](double h) -> const StepMatrices& {
        const auto at = known.find(h);
        return at != known.end() ? at->second : known.emplace(h, step_matrices(j, system.A, h)).first->second;
    };
    History history(j.bodies, system.area);
    Eigen::VectorXd y = Eigen::VectorXd::Zero(system.A.rows()), slope = y;
    y[j.bodies + link] = force.impulse / j.inertia[link];
    ForcedResponse response;
    const auto keep = [&](double t) {
        response.time.push_back(t);
        response.position.push_back(y[link]);
        response.velocity.push_back(y[j.bodies + link]);
    };
    const auto delayed_forces = [&](double t) {
        std::array<double, max_bodies> f{};
        for (const auto& term : system.terms) f[term.body] += history.delayed(term, t - term.time);
        return f;
    };
    const auto slope_at = [&](double t, double d) {
        auto f = delayed_forces(t);
        f[link] += d;
        Eigen::VectorXd rate = system.A * y;
        for (int i = 0; i < j.bodies; ++i) rate[j.bodies + i] += f[i] / j.inertia[i];
        return rate;
    };
    const auto advance = [&](double t, double h, double d) {
        const auto& m = matrices(h);
        std::array<std::array<double, nodes>, max_bodies> delayed{};
        for (int q = 0; q < nodes; ++q) {
            const auto f = delayed_forces(t + h * std::clamp(q / 3.0, inside, 1 - inside));
            for (int i = 0; i < j.bodies; ++i) delayed[i][q] = f[i];
        }
        Eigen::VectorXd next = m.state * y + m.power[0].col(link) * d;
        for (int i = 0; i < j.bodies; ++i) {
            const auto c = cubic(delayed[i]);
            for (int p = 0; p < nodes; ++p) next += m.power[p].col(i) * c[p];
        }
        y = next;
    };
    keep(0);
    const auto breaks = kinks(system.terms, force.step * static_cast<double>(force.value.size()));
    auto kink = breaks.begin();
    for (std::size_t i = 0; i < force.value.size(); ++i) {
        const double d = force.value[i], begin = force.step * static_cast<double>(i);
        double done = 0;  // of this sample
        while (done < force.step) {
            while (kink != breaks.end() && *kink <= begin + done + inside * longest) ++kink;
            double end = force.step;
            if (kink != breaks.end() && *kink < begin + force.step - inside * longest) end = *kink - begin;
            const int steps = static_cast<int>(std::ceil((end - done) / longest * (1 - inside)));
            const double h = (end - done) / steps, start = begin + done;
            for (int k = 0; k < steps; ++k) {
                const double t = start + k * h;
                history.add(t, y, slope, slope_at(t + inside * h, d));
                advance(t, h, d);
                slope = slope_at(t + h * (1 - inside), d);
            }
            done = end;
        }
        keep(force.step * static_cast<double>(i + 1));
    }
    return response;
}

}  // namespace stickslip
