// A rate-and-state law with one state behind a held force, as lanes step it between two ticks: in the units of job.h
//   X' = e^w − 1,   M e^w w' = F − (c (e^w − 1) + w + p),   p' as there,
// with F the effort that has arrived, in excess of steady sliding, and c the drag of the drive; behind a lag F is a
// state z, τ z' = F − z.
#pragma once
#include "analysis/simulation/lanes/rosenbrock.h"

namespace stickslip::lanes {

/// Force and drag change from piece to piece; K of the groups is 0, since no spring acts within a tick.
template <class P, template <class> class Friction>
struct HeldForce : PackedGroups<P, Friction> {
    static constexpr int size = 3;
    using State = Triple<P>;
    P force;

    void set_lag(int, double) {}
    static State state(const P* y) { return {y[0], y[1], y[2]}; }
};

template <class P, template <class> class Friction>
struct LaggingForce : PackedGroups<P, Friction> {
    static constexpr int size = 4;
    using State = Quadruple<P>;
    P force, per_lag;

    void set_lag(int lane, double lag) { per_lag.set(lane, 1 / lag); }
    static State state(const P* y) { return {{y[0], y[1], y[2]}, y[1], y[3]}; }
};

template <class P, template <class> class Friction>
[[gnu::always_inline]] inline Triple<P> rate(const HeldForce<P, Friction>& g, const Triple<P>& y,
                                             const Exponential<P>& v, const P& per_Mv)
{
    const PackedGroups<P, Friction>& sliding = g;
    Triple<P> r = rate(sliding, y, v, per_Mv);
    r.w = r.w + g.force * per_Mv;
    return r;
}
template <class P, template <class> class Friction>
[[gnu::always_inline]] inline Elimination<P> eliminate(const HeldForce<P, Friction>& g, const Triple<P>& y,
                                                       const Exponential<P>& e, const P& per_Mv, const Triple<P>& rate,
                                                       const P& h)
{
    return Elimination<P>(g, y, e, per_Mv, rate.w, h);
}

template <class P, template <class> class Friction>
[[gnu::always_inline]] inline Quadruple<P> rate(const LaggingForce<P, Friction>& g, const Quadruple<P>& y,
                                                const Exponential<P>& v, const P& per_Mv)
{
    const PackedGroups<P, Friction>& sliding = g;
    Triple<P> r = rate(sliding, y.joint, v, per_Mv);
    r.w = r.w + y.z * per_Mv;
    return {r, r.w, (g.force - y.z) * g.per_lag};
}

/// The lag's row stands alone and is solved first.
template <class P>
struct LagElimination {
    Elimination<P> joint;
    P per_Mv, per_gl;

    [[gnu::always_inline]] Quadruple<P> solve(const Quadruple<P>& right) const
    {
        const P z = right.z * per_gl;
        Triple<P> r = right.joint;
        r.w = r.w + per_Mv * z;
        const auto u = joint.solve(r);
        return {u, u.w, z};
    }
};
template <class P, template <class> class Friction>
[[gnu::always_inline]] inline LagElimination<P> eliminate(const LaggingForce<P, Friction>& g, const Quadruple<P>& y,
                                                          const Exponential<P>& e, const P& per_Mv,
                                                          const Quadruple<P>& rate, const P& h)
{
    return {Elimination<P>(g, y.joint, e, per_Mv, rate.w, h), per_Mv,
            P(1.0) / (P(1.0) / (h * P(rodas5p::gamma)) + g.per_lag)};
}

template <class P>
using HeldSlip = HeldForce<P, SlipState>;
template <class P>
using HeldAgeing = HeldForce<P, AgeingState>;
template <class P>
using LaggingSlip = LaggingForce<P, SlipState>;
template <class P>
using LaggingAgeing = LaggingForce<P, AgeingState>;

}  // namespace stickslip::lanes
