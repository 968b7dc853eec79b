// One step of Rodas5P for a pack of rate-and-state joints with one state, unrolled from the stage tables, with the 3 ×
// 3 solve written out.
#pragma once
#include <utility>

#include "analysis/simulation/lanes/functions.h"
#include "analysis/simulation/solvers/rodas5p_table.h"

namespace stickslip::lanes {

/// X, w, p of every lane (job.h), or a displacement or rate of them.
template <class P>
struct Triple {
    P X, w, p;

    [[gnu::always_inline]] static Triple zero() { return {P(0.0), P(0.0), P(0.0)}; }
    [[gnu::always_inline]] void add(const Triple& y) { X = X + y.X, w = w + y.w, p = p + y.p; }
    [[gnu::always_inline]] void add(const P& weight, const Triple& y)
    {
        X = X + weight * y.X;
        w = w + weight * y.w;
        p = p + weight * y.p;
    }
};

/// Triple, and one state more.
template <class P>
struct Quadruple {
    Triple<P> joint;
    P w, z;  ///< w that of the joint

    [[gnu::always_inline]] static Quadruple zero() { return {Triple<P>::zero(), P(0.0), P(0.0)}; }
    [[gnu::always_inline]] void add(const Quadruple& y) { joint.add(y.joint), w = joint.w, z = z + y.z; }
    [[gnu::always_inline]] void add(const P& weight, const Quadruple& y)
    {
        joint.add(weight, y.joint), w = joint.w, z = z + weight * y.z;
    }
};

template <class P>
[[gnu::always_inline]] inline P part(const Triple<P>& y, int k)
{
    return k == 0 ? y.X : k == 1 ? y.w : y.p;
}
template <class P>
[[gnu::always_inline]] inline P part(const Quadruple<P>& y, int k)
{
    return k == 3 ? y.z : part(y.joint, k);
}

/// How fast the state p changes, and by what: the slip law.
template <class P>
struct SlipState {
    P beta;

    void set_beta(int lane, double value) { beta.set(lane, value); }
    [[gnu::always_inline]] P rate(const Triple<P>& y, const Exponential<P>& v) const
    {
        return -(v.value * (y.p + beta * y.w));
    }
    [[gnu::always_inline]] P by_w(const Triple<P>& y, const Exponential<P>& v) const
    {
        return -(v.value * (y.p + beta * y.w + beta));
    }
    [[gnu::always_inline]] P decay(const Triple<P>&, const Exponential<P>& v) const { return v.value; }
};

/// The same of the ageing law.
template <class P>
struct AgeingState {
    P beta, per_beta;

    void set_beta(int lane, double value) { beta.set(lane, value), per_beta.set(lane, 1 / value); }
    [[gnu::always_inline]] P rate(const Triple<P>& y, const Exponential<P>& v) const
    {
        return beta * (exponential(-(y.p * per_beta)).minus_one - v.minus_one);
    }
    [[gnu::always_inline]] P by_w(const Triple<P>&, const Exponential<P>& v) const { return -(beta * v.value); }
    /// −∂p'/∂p
    [[gnu::always_inline]] P decay(const Triple<P>& y, const Exponential<P>&) const
    {
        return exponential(-(y.p * per_beta)).value;
    }
};

template <class P, template <class> class Friction>
struct PackedGroups {
    P K, per_M, c;
    Friction<P> friction;
};

template <class State>
struct PackedStep {
    State end;  ///< state at the end
    State U[rodas5p::stages];
    const State& error() const { return U[rodas5p::stages - 1]; }
};

/// What everything at one state shares: e^w, and what a force does to w.
template <class P>
struct AtState {
    Exponential<P> e;
    P per_Mv;
};
template <class Equations, class State>
[[gnu::always_inline]] inline auto at_state(const Equations& g, const State& y)
{
    const auto e = exponential(y.w);
    return AtState<decltype(e.value * e.value)>{e, g.per_M / e.value};
}

template <class P, template <class> class Friction>
[[gnu::always_inline]] inline Triple<P> rate(const PackedGroups<P, Friction>& g, const Triple<P>& y,
                                             const Exponential<P>& v, const P& per_Mv)
{
    const P balance = g.c * v.minus_one + g.K * y.X + y.w + y.p;
    return {v.minus_one, -(balance * per_Mv), g.friction.rate(y, v)};
}

/// Σ_j table[i][j] U_j over the nonzero coefficients, which are constants of the program.
template <const auto& table, int i, class P, class State, int... j>
[[gnu::always_inline]] inline void add_stages(State& sum, const State* U, std::integer_sequence<int, j...>)
{
    const auto add = [&]<int k>() __attribute__((always_inline))
    {
        if constexpr (table[i][k] != 0) sum.add(P(table[i][k]), U[k]);
    };
    (add.template operator()<j>(), ...);
}

/// Factors of I/(hγ) − J with J = [0 v 0; −J_10 J_11 −J_12; 0 J_21 −decay], eliminated through the middle row.
template <class P>
struct Elimination {
    P hg, v, J21, x_share, p_share, per_gs, per_pivot;

    [[gnu::always_inline]] Elimination(const P& h, const P& speed, const P& J10, const P& J11, const P& J12,
                                       const P& by_w, const P& decay)
        : hg(h * P(rodas5p::gamma)), v(speed), J21(by_w)
    {
        const P diagonal = P(1.0) / hg;
        per_gs = P(1.0) / (diagonal + decay);
        x_share = J10 * hg;
        p_share = J12 * per_gs;
        per_pivot = P(1.0) / ((diagonal - J11) + x_share * v + p_share * J21);
    }
    template <template <class> class Friction>
    [[gnu::always_inline]] Elimination(const PackedGroups<P, Friction>& g, const Triple<P>& y, const Exponential<P>& e,
                                       const P& per_Mv, const P& w_rate, const P& h)
        : Elimination(h, e.value, g.K * per_Mv, -((g.c * e.value + 1.0) * per_Mv) - w_rate, per_Mv,
                      g.friction.by_w(y, e), g.friction.decay(y, e))
    {
    }
    [[gnu::always_inline]] Triple<P> solve(const Triple<P>& right) const
    {
        const P w = (right.w - x_share * right.X - p_share * right.p) * per_pivot;
        return {(right.X + v * w) * hg, w, (right.p + J21 * w) * per_gs};
    }
};

template <class P, template <class> class Friction>
[[gnu::always_inline]] inline Elimination<P> eliminate(const PackedGroups<P, Friction>& g, const Triple<P>& y,
                                                       const Exponential<P>& e, const P& per_Mv, const Triple<P>& rate,
                                                       const P& h)
{
    return Elimination<P>(g, y, e, per_Mv, rate.w, h);
}

/// The step of every lane from y with its own h, under equations that have rate() and eliminate().
template <class P, class Equations, class State>
[[gnu::always_inline]] inline void rodas5p_step(const Equations& g, const State& y, const P& h, PackedStep<State>& step)
{
    const auto here = at_state(g, y);
    const P per_h = P(1.0) / h;
    const State start_rate = rate(g, y, here.e, here.per_Mv);
    const auto matrix = eliminate(g, y, here.e, here.per_Mv, start_rate, h);
    step.U[0] = matrix.solve(start_rate);
    State stage;
    const auto advance = [&]<int i>() __attribute__((always_inline))
    {
        using Before = std::make_integer_sequence<int, i>;
        if constexpr (i < 6) {
            stage = y;
            add_stages<rodas5p::a, i, P>(stage, step.U, Before{});
        } else {  // rows 6 and 7 of the table: the stage before plus its U
            stage.add(step.U[i - 1]);
        }
        const auto there = at_state(g, stage);
        State f = rate(g, stage, there.e, there.per_Mv), carried = State::zero();
        add_stages<rodas5p::c, i, P>(carried, step.U, Before{});
        f.add(per_h, carried);
        step.U[i] = matrix.solve(f);
    };
    [&]<int... i>(std::integer_sequence<int, i...>) __attribute__((always_inline))
    {
        (advance.template operator()<i + 1>(), ...);
    }
    (std::make_integer_sequence<int, rodas5p::stages - 1>{});
    step.end = stage;
    step.end.add(step.U[rodas5p::stages - 1]);
}

}  // namespace stickslip::lanes
