// Two states under a rate-and-state law, and bristles, in the kernel: the equations of watched_job.h.
#pragma once
#include "analysis/simulation/lanes/rosenbrock_model.h"
#include "analysis/simulation/lanes/watched_program.h"

namespace stickslip::lanes {

/// What the laws have in common.
struct Watched {
    using Job = WatchedJob;
    using Answer = WatchedAnswer;
    using Program = WatchedProgram;
    /// A harmless problem for a lane without a job.
    static constexpr Job harmless(WatchedLaw law)
    {
        return {{law, 1, 1, 1, {1, 0, 1}, {1, 1, 1, 0, 1, 1, 1, 1}}, -1, 1, true, {}, {1, 1, 1, 1, 1, 1}, 0, {}};
    }
};

/// The first state stands in PackedGroups.
template <class P, template <class> class Friction>
struct TwoStates : PackedGroups<P, Friction>, Watched {
    using State = Quadruple<P>;
    static constexpr int size = 4;
    static constexpr double slow = near_rest_logarithm;
    Friction<P> second;
    P lambda;

    static State state(const P* y) { return {{y[0], y[1], y[2]}, y[1], y[3]}; }
    static constexpr Job idle() { return harmless(WatchedLaw::two_slip_states); }
    void load(int lane, const WatchedGroups& groups)
    {
        this->K.set(lane, groups.K);
        this->per_M.set(lane, 1 / groups.M);
        this->c.set(lane, groups.c);
        this->friction.set_beta(lane, groups.own[0]);
        second.set_beta(lane, groups.own[1]);
        lambda.set(lane, groups.own[2]);
    }
    [[gnu::always_inline]] static Triple<P> with_second(const State& y) { return {y.joint.X, y.w, y.z}; }
};

template <class P, template <class> class Friction>
[[gnu::always_inline]] inline Quadruple<P> rate(const TwoStates<P, Friction>& g, const Quadruple<P>& y,
                                                const Exponential<P>& v, const P& per_Mv)
{
    const PackedGroups<P, Friction>& first = g;
    Triple<P> r = rate(first, y.joint, v, per_Mv);
    r.w = r.w - y.z * per_Mv;
    return {r, r.w, g.lambda * g.second.rate(TwoStates<P, Friction>::with_second(y), v)};
}

/// The second state's row is eliminated before the others.
template <class P>
struct TwoStateElimination {
    Elimination<P> first;
    P by_w, per_gs, share;

    [[gnu::always_inline]] Quadruple<P> solve(const Quadruple<P>& right) const
    {
        Triple<P> r = right.joint;
        r.w = r.w - share * right.z;
        const auto u = first.solve(r);
        return {u, u.w, (right.z + by_w * u.w) * per_gs};
    }
};
template <class P, template <class> class Friction>
[[gnu::always_inline]] inline TwoStateElimination<P> eliminate(const TwoStates<P, Friction>& g, const Quadruple<P>& y,
                                                               const Exponential<P>& e, const P& per_Mv,
                                                               const Quadruple<P>& rate, const P& h)
{
    const auto second = TwoStates<P, Friction>::with_second(y);
    const P by_w = g.lambda * g.second.by_w(second, e);
    const P per_gs = P(1.0) / (P(1.0) / (h * P(rodas5p::gamma)) + g.lambda * g.second.decay(second, e));
    const P share = per_Mv * per_gs, J11 = -((g.c * e.value + 1.0) * per_Mv) - rate.w;
    return {Elimination<P>(h, e.value, g.K * per_Mv, J11 - share * by_w, per_Mv, g.friction.by_w(y.joint, e),
                           g.friction.decay(y.joint, e)),
            by_w, per_gs, share};
}

template <class P>
struct Bristles : Watched {
    using State = Triple<P>;
    static constexpr int size = 3;
    static constexpr double slow = near_rest - 1;
    P K, per_M, c, s, a, rho;

    static State state(const P* y) { return {y[0], y[1], y[2]}; }
    static constexpr Job idle() { return harmless(WatchedLaw::lugre); }
    void load(int lane, const WatchedGroups& groups)
    {
        K.set(lane, groups.K);
        per_M.set(lane, 1 / groups.M);
        c.set(lane, groups.c);
        s.set(lane, groups.own[0]);
        a.set(lane, groups.own[1]);
        rho.set(lane, groups.own[2]);
    }
};

/// e^{−ρ w (2 + w)}
template <class P, class State>
[[gnu::always_inline]] inline AtState<P> at_state(const Bristles<P>& g, const State& y)
{
    return {exponential(-(g.rho * (y.w * (y.w + 2.0)))), g.per_M};
}

/// p', written so that nothing is lost of it near steady sliding.
template <class P>
[[gnu::always_inline]] inline P bristle_rate(const Bristles<P>& g, const Triple<P>& y, const Exponential<P>& e)
{
    const P V = y.w + 1.0, lack = g.a * e.minus_one;
    return V * select(P(0.0) < V, lack - y.p, (lack + y.p) + 2.0) / (lack + 1.0);
}
template <class P>
[[gnu::always_inline]] inline Triple<P> rate(const Bristles<P>& g, const Triple<P>& y, const Exponential<P>& e,
                                             const P& per_M)
{
    const P bends = bristle_rate(g, y, e);
    return {y.w, -((g.c * y.w + g.K * y.X + y.p + g.s * bends) * per_M), bends};
}
template <class P>
[[gnu::always_inline]] inline Elimination<P> eliminate(const Bristles<P>& g, const Triple<P>& y,
                                                       const Exponential<P>& e, const P& per_M, const Triple<P>&,
                                                       const P& h)
{
    const P V = y.w + 1.0, direction = copysign(P(1.0), V), per_G = P(1.0) / (g.a * e.minus_one + 1.0);
    const P slope = -2.0 * (g.rho * V * (g.a * e.value));  // of G
    const P by_w = 1.0 - direction * (y.p + 1.0) * per_G * (1.0 - V * slope * per_G), decay = abs(V) * per_G;
    return {h, P(1.0), g.K * per_M, -((g.c + g.s * by_w) * per_M), (1.0 - g.s * decay) * per_M, by_w, decay};
}

template <class P>
using TwoSlipModel = RosenbrockModel<P, TwoStates<P, SlipState>>;
template <class P>
using TwoAgeingModel = RosenbrockModel<P, TwoStates<P, AgeingState>>;
template <class P>
using LuGreModel = RosenbrockModel<P, Bristles<P>>;

}  // namespace stickslip::lanes
