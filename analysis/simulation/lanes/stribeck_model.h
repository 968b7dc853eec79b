// A mass under Stribeck friction as the kernel steps it while it slides: the explicit pair of Dormand & Prince.
#pragma once
#include <utility>

#include "analysis/simulation/lanes/functions.h"
#include "analysis/simulation/lanes/stribeck_program.h"

namespace stickslip::lanes {

template <class P>
class StribeckModel {
    using M = typename P::MaskType;

  public:
    using Job = StribeckJob;
    using Answer = StribeckAnswer;
    using Program = StribeckProgram;
    static constexpr int size = 2;  ///< X, u

    struct State {
        P X, u;
    };
    class Step {
      public:
        P end(int k) const { return k == 0 ? last.X : last.u; }
        P error(int k) const { return k == 0 ? difference.X : difference.u; }
        State rates[dormand_prince::stages];
        State last, difference;
    };

    void load(int lane, const Job& job)
    {
        const auto& g = job.groups;
        zeta_.set(lane, g.zeta);
        alpha_.set(lane, g.alpha);
        rho_.set(lane, g.rho);
        gaussian_.set(lane, g.power == 2 ? 1 : 0);
    }
    /// A harmless problem for a lane without a job.
    static constexpr Job idle() { return {{1, 0, 1, 1, 2}, -1, 1, true, {0, 0}, false}; }

    void start(int, const double*) {}
    void step(const P* y, const P& h, Step& s) const
    {
        const State from{y[0], y[1]};
        s.rates[0] = rate(from);
        [&]<int... i>(std::integer_sequence<int, i...>) __attribute__((always_inline))
        {
            ((s.last = stage<dormand_prince::weight, i + 1>(from, s.rates, h), s.rates[i + 1] = rate(s.last)), ...);
        }
        (std::make_integer_sequence<int, dormand_prince::stages - 1>{});
        s.difference = stage<dormand_prince::error_weight, 0>({P(0.0), P(0.0)}, s.rates, h);
    }
    void remember(const M&, const P*, const P&) {}

    M events(const P* y, const Step& s) const
    {
        const P zero(0.0), slow(near_rest - 1), rest(-1.0), u = y[1], end = s.end(1);
        const M section = ((zero < u) & (end <= zero)) | ((u <= zero) & (zero < end));
        const M resting = ((slow < u) & (end <= slow)) | ((u <= slow) & (slow < end));
        const M turning = s.rates[0].u * s.rates[dormand_prince::stages - 1].u < zero;
        return section | resting | turning | ((rest < u) & (end <= rest));
    }
    M settled(const Step& s, const P& small) const { return (abs(s.end(0)) < small) & (abs(s.end(1)) < small); }

    /// What the program of one lane sees of a step.
    void look(int i, const Step& s, StribeckView& view) const
    {
        for (int j = 0; j < dormand_prince::stages; ++j) view.k[j][0] = s.rates[j].X[i], view.k[j][1] = s.rates[j].u[i];
    }
    EventFlags flags(const StribeckView& view, int, double settled) const
    {
        EventFlags flags;
        const double u0 = view.y0[1], u1 = view.y1[1];
        flags.section = (u0 > 0) != (u1 > 0);
        flags.slow = (u0 > near_rest - 1) != (u1 > near_rest - 1);
        flags.turning = view.k[0][1] * view.k[dormand_prince::stages - 1][1] < 0;
        flags.rest = u0 > -1 && u1 <= -1;
        const auto small = [settled](double x) { return x < settled && x > -settled; };
        flags.settled = small(view.y1[0]) && small(u1);
        return flags;
    }

  private:
    [[gnu::always_inline]] State rate(const State& y) const
    {
        const P q = y.u * (P(1.0) + gaussian_ * (P(1.0) + y.u));  // u, or u (2 + u)
        const auto e = exponential(-(rho_ * q));
        return {y.u, -(y.X + zeta_ * y.u + alpha_ * e.minus_one)};
    }

    /// from + h Σ_j table[i][j] k_j over the nonzero coefficients, which are constants of the program.
    template <const auto& table, int i>
    [[gnu::always_inline]] static State stage(const State& from, const State* k, const P& h)
    {
        State sum{P(0.0), P(0.0)};
        const auto add = [&]<int j>() __attribute__((always_inline))
        {
            if constexpr (table[i][j] != 0) {
                const P weight(table[i][j]);
                sum.X = sum.X + weight * k[j].X;
                sum.u = sum.u + weight * k[j].u;
            }
        };
        constexpr int columns = sizeof(table[i]) / sizeof(double);
        [&]<int... j>(std::integer_sequence<int, j...>) __attribute__((always_inline))
        {
            (add.template operator()<j>(), ...);
        }
        (std::make_integer_sequence<int, columns>{});
        return {from.X + h * sum.X, from.u + h * sum.u};
    }

    P zeta_, alpha_, rho_, gaussian_;
};

}  // namespace stickslip::lanes
