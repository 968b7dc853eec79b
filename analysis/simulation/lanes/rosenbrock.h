// One step of Rodas5P for a pack of slip-law joints, unrolled from the stage tables, with the 3 × 3 solve written out.
#pragma once
#include <utility>

#include "analysis/simulation/lanes/functions.h"
#include "analysis/simulation/solvers/rodas5p_table.h"

namespace stickslip::lanes {

/// X, w, p of every lane (job.h), or a displacement or rate of them.
template <class P>
struct Triple {
    P X, w, p;
};

template <class P>
struct PackedGroups {
    P K, per_M, beta, c;
};

template <class P>
struct PackedStep {
    Triple<P> end;  ///< state at the end
    Triple<P> U[rodas5p::stages];
    const Triple<P>& error() const { return U[rodas5p::stages - 1]; }
};

template <class P>
[[gnu::always_inline]] inline Triple<P> rate(const PackedGroups<P>& g, const Triple<P>& y, const Exponential<P>& v,
                                             const P& per_Mv)
{
    const P balance = g.c * v.minus_one + g.K * y.X + y.w + y.p;
    return {v.minus_one, -(balance * per_Mv), -(v.value * (y.p + g.beta * y.w))};
}

/// Σ_j table[i][j] U_j over the nonzero coefficients, which are constants of the program.
template <const auto& table, int i, class P, int... j>
[[gnu::always_inline]] inline void add_stages(Triple<P>& sum, const Triple<P>* U, std::integer_sequence<int, j...>)
{
    const auto add = [&]<int k>() __attribute__((always_inline))
    {
        if constexpr (table[i][k] != 0) {
            const P weight(table[i][k]);
            sum.X = sum.X + weight * U[k].X;
            sum.w = sum.w + weight * U[k].w;
            sum.p = sum.p + weight * U[k].p;
        }
    };
    (add.template operator()<j>(), ...);
}

/// Factors of I/(hγ) − J with J = [0 v 0; −K/(Mv) J_11 −1/(Mv); 0 J_21 −v], eliminated through the middle row.
template <class P>
struct Elimination {
    P hg, v, J21, x_share, p_share, per_gv, per_pivot;

    [[gnu::always_inline]] Elimination(const PackedGroups<P>& g, const Triple<P>& y, const Exponential<P>& e,
                                       const P& per_Mv, const P& w_rate, const P& h)
        : hg(h * P(rodas5p::gamma)), v(e.value)
    {
        const P diagonal = P(1.0) / hg;
        const P J11 = -((g.c * v + 1.0) * per_Mv) - w_rate;
        J21 = -(v * (y.p + g.beta * y.w + g.beta));
        per_gv = P(1.0) / (diagonal + v);
        x_share = g.K * per_Mv * hg;
        p_share = per_Mv * per_gv;
        per_pivot = P(1.0) / ((diagonal - J11) + x_share * v + p_share * J21);
    }
    [[gnu::always_inline]] Triple<P> solve(const Triple<P>& right) const
    {
        const P w = (right.w - x_share * right.X - p_share * right.p) * per_pivot;
        return {(right.X + v * w) * hg, w, (right.p + J21 * w) * per_gv};
    }
};

/// The step of every lane from y with its own h.
template <class P>
[[gnu::always_inline]] inline void rodas5p_step(const PackedGroups<P>& g, const Triple<P>& y, const P& h,
                                                PackedStep<P>& step)
{
    const auto e = exponential(y.w);
    const P per_Mv = g.per_M / e.value, per_h = P(1.0) / h;
    const Triple<P> start_rate = rate(g, y, e, per_Mv);
    const Elimination<P> matrix(g, y, e, per_Mv, start_rate.w, h);
    step.U[0] = matrix.solve(start_rate);
    Triple<P> stage;
    const auto advance = [&]<int i>() __attribute__((always_inline))
    {
        using Before = std::make_integer_sequence<int, i>;
        if constexpr (i < 6) {
            stage = y;
            add_stages<rodas5p::a, i>(stage, step.U, Before{});
        } else {  // rows 6 and 7 of the table: the stage before plus its U
            stage.X = stage.X + step.U[i - 1].X;
            stage.w = stage.w + step.U[i - 1].w;
            stage.p = stage.p + step.U[i - 1].p;
        }
        const auto ei = exponential(stage.w);
        const Triple<P> f = rate(g, stage, ei, g.per_M / ei.value);
        Triple<P> carried{P(0.0), P(0.0), P(0.0)};
        add_stages<rodas5p::c, i>(carried, step.U, Before{});
        step.U[i] = matrix.solve({f.X + carried.X * per_h, f.w + carried.w * per_h, f.p + carried.p * per_h});
    };
    [&]<int... i>(std::integer_sequence<int, i...>) __attribute__((always_inline))
    {
        (advance.template operator()<i + 1>(), ...);
    }
    (std::make_integer_sequence<int, rodas5p::stages - 1>{});
    const auto& last = step.U[rodas5p::stages - 1];
    step.end = {stage.X + last.X, stage.w + last.w, stage.p + last.p};
}

}  // namespace stickslip::lanes
