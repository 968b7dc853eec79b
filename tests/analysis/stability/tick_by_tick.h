// A sampled loop written out tick by tick, whose map from tick to tick owes nothing to the program's own.
#pragma once
#include "analysis/numerics/balance.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/real_loop.h"
#include "tests/oracles/matrices.h"

#include <cmath>
#include <deque>

namespace stickslip::samples {

/// All that a loop remembers between two ticks, and one tick of it (docs/theory.md, real loops): read, estimate,
/// command, hold.
// the multipliers crowd around 1: their distance from it is what counts, and double loses it
using Real = long double;
using Matrix = test::LongMatrix;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
inline constexpr double tie = 1e-9;  // of a tick: rounding of delay/T

struct TickByTick {
    Matrix A;
    Vector B;
    int measured, bodies;
    Real T, delay, tau, scale;
    int average;
    bool exact;
    LoopGains g;

    struct Memory {
        Vector x;
        std::deque<Real> readings;  ///< newest first, `average` of them
        Real velocity = 0, sum = 0;
        std::deque<Real> commands;  ///< newest first
    };
    /// A sum that nobody reads would stay for ever.
    bool integrates() const { return g.integral != 0; }
    int ticks() const { return static_cast<int>(std::ceil(delay / T - tie)); }
    int size() const { return static_cast<int>(A.rows()) + average + 2 + ticks(); }

    int sum_at() const { return static_cast<int>(A.rows()) + average + 1; }

    Memory unpack(const Vector& v) const
    {
        Memory m;
        int i = static_cast<int>(A.rows());
        m.x = v.head(i);
        for (int k = 0; k < average; ++k) m.readings.push_back(v[i++]);
        m.velocity = v[i++];
        m.sum = v[i++];
        for (int k = 0; k < ticks(); ++k) m.commands.push_back(v[i++]);
        return m;
    }
    Vector pack(const Memory& m) const
    {
        Vector v(size());
        int i = static_cast<int>(A.rows());
        v.head(i) = m.x;
        for (const Real r : m.readings) v[i++] = r;
        v[i++] = m.velocity;
        v[i++] = m.sum;
        for (const Real c : m.commands) v[i++] = c;
        return v;
    }
    Vector held(const Vector& x, Real w, Real h) const
    {
        const auto n = A.rows();
        Matrix wide = Matrix::Zero(n + 1, n + 1);
        wide.topLeftCorner(n, n) = A * h;
        wide.topRightCorner(n, 1) = B * h;
        Vector from(n + 1);
        from << x, w;
        return (test::exponential(wide) * from).head(n);
    }
    Vector tick(const Vector& v) const
    {
        Memory m = unpack(v);
        const Real y = scale * m.x[measured];
        Real before = 0, now = y;
        for (int k = 0; k < average; ++k) before += m.readings[static_cast<std::size_t>(k)];
        for (int k = 0; k + 1 < average; ++k) now += m.readings[static_cast<std::size_t>(k)];
        m.velocity = exact ? scale * m.x[bodies + measured]
                           : m.velocity + T / (tau + T) * ((now - before) / average / T - m.velocity);
        m.readings.push_front(y);
        m.readings.pop_back();
        if (integrates()) m.sum += T * y;
        m.commands.push_front(-(g.position * y + g.velocity * m.velocity + g.integral * m.sum));
        const int whole = ticks();
        const Real early = delay - (whole - 1) * T;  // of the older command within this tick
        if (whole > 0 && early < T * (1 - tie)) {
            m.x = held(m.x, m.commands[static_cast<std::size_t>(whole)], early);
            m.x = held(m.x, m.commands[static_cast<std::size_t>(whole - 1)], T - early);
        } else {
            m.x = held(m.x, m.commands[static_cast<std::size_t>(whole)], T);
        }
        m.commands.pop_back();
        return pack(m);
    }
    /// The map of one tick, balanced.
    Matrix map() const
    {
        Matrix M(size(), size());
        for (int i = 0; i < size(); ++i) M.col(i) = tick(Vector::Unit(size(), i));
        if (!integrates()) M.row(sum_at()).setZero();
        if (M.allFinite()) balance(M);
        return M;
    }
    double growth() const
    {
        const Matrix M = map();
        if (!M.allFinite()) return not_set;
        return static_cast<double>(std::log(test::spectral_radius(M)) / T);
    }
};

inline TickByTick written_out(const Joint& j)
{
    LinearJoint open = linear_joint(j, j.control.V0 / j.sensor.position_scale);
    open.k_p = open.k_v = 0;
    const Matrix mechanism = state_matrix(open).cast<Real>();
    const auto n = mechanism.rows();
    const bool lag = j.actuator.lag > 0;
    TickByTick t;
    t.A = Matrix::Zero(n + lag, n + lag);
    t.A.topLeftCorner(n, n) = mechanism;
    t.B = Vector::Zero(n + lag);
    const double push = j.actuator.effort_gain / open.inertia[0];
    if (lag) {
        t.A(open.bodies, n) = push;
        t.A(n, n) = -1 / j.actuator.lag;
        t.B[n] = 1 / j.actuator.lag;
    } else {
        t.B[open.bodies] = push;
    }
    const auto& c = j.control;
    t.measured = c.feedback == Feedback::link ? open.link() : 0;
    t.bodies = open.bodies;
    t.T = c.period, t.delay = c.delay, t.tau = c.velocity_estimate.tau;
    t.scale = j.sensor.position_scale;
    t.average = static_cast<int>(c.velocity_estimate.average);
    t.exact = c.velocity_estimate.form == EstimateForm::exact;
    t.g = {c.k_p, c.k_v, c.k_i, 0};
    return t;
}

}  // namespace stickslip::samples
