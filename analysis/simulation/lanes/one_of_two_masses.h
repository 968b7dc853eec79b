// One of two masses in the kernel, under a rate-and-state law with one state or viscous friction: its equations of
// watched_job.h.
#pragma once
#include "analysis/simulation/flows/near_rest.h"
#include "analysis/simulation/lanes/rosenbrock.h"

namespace stickslip::lanes {

/// Of the speed of a mass that springs drive below any speed: that of the reference, least_logarithm (flow.h), which
/// two_mass_joint.cpp checks.
inline constexpr double slowest_logarithm = -60;

/// X and w of a mass without memory.
template <class P>
struct Couple {
    P X, w;

    [[gnu::always_inline]] static Couple zero() { return {P(0.0), P(0.0)}; }
    [[gnu::always_inline]] void add(const Couple& y) { X = X + y.X, w = w + y.w; }
    [[gnu::always_inline]] void add(const P& weight, const Couple& y) { X = X + weight * y.X, w = w + weight * y.w; }
};
template <class P>
[[gnu::always_inline]] inline P part(const Couple<P>& y, int k)
{
    return k == 0 ? y.X : y.w;
}

/// What springs, dampers and the loop do to a mass, by its own displacement and speed and by those of the other one.
template <class P>
struct Held {
    P per_M, K, c, K_other, c_other;

    [[gnu::always_inline]] P carries(const P& X, const P& S, const P& X_other, const P& S_other) const
    {
        return (c * S + K * X) + (c_other * S_other + K_other * X_other);
    }
};

/// The row of w of one mass in I/(hγ) − J, its X and p eliminated, and how these follow from w.
template <class P>
struct MassRow {
    P hg, v, x_share, x_share_other;
    P diagonal, by_other;  ///< of its own w and of the other's

    [[gnu::always_inline]] MassRow(const Held<P>& held, const AtState<P>& at, const P& speed_other, const P& h)
        : hg(h * P(rodas5p::gamma)),
          v(at.e.value),
          x_share(at.per_Mv * held.K * hg),
          x_share_other(at.per_Mv * held.K_other * hg),
          diagonal(P(1.0) / hg + (at.per_Mv * held.c + x_share) * v),
          by_other((at.per_Mv * held.c_other + x_share_other) * speed_other)
    {
    }
    [[gnu::always_inline]] P left_of(const P& w, const P& X, const P& X_other) const
    {
        return w - x_share * X - x_share_other * X_other;
    }
};

/// A mass under viscous friction, which stands in c.
template <class P>
struct ViscousMass : Held<P> {
    using State = Couple<P>;
    static constexpr int size = 2;
    static constexpr double slow = near_rest - 1;

    [[gnu::always_inline]] static State state(const P* y) { return {y[0], y[1]}; }
    void load(int, double, double, double) {}
    [[gnu::always_inline]] AtState<P> at(const State& y) const { return {{P(1.0), y.w}, this->per_M}; }
    [[gnu::always_inline]] State rate(const State& y, const AtState<P>& at, const P& carried) const
    {
        return {y.w, -(carried * at.per_Mv)};
    }

    struct Row : MassRow<P> {
        [[gnu::always_inline]] Row(const ViscousMass& g, const State&, const AtState<P>& at, const P& speed_other,
                                   const State&, const P& h)
            : MassRow<P>(g, at, speed_other, h)
        {
        }
        [[gnu::always_inline]] P reduced(const State& right, const P& X_other) const
        {
            return this->left_of(right.w, right.X, X_other);
        }
        [[gnu::always_inline]] State solved(const State& right, const P& w) const
        {
            return {(right.X + w) * this->hg, w};
        }
    };
};

/// A mass under a rate-and-state law with one state.
template <class P, template <class> class Friction>
struct MemoryMass : Held<P> {
    using State = Triple<P>;
    static constexpr int size = 3;
    static constexpr double slow = near_rest_logarithm;
    Friction<P> friction;
    P share, faster;

    [[gnu::always_inline]] static State state(const P* y) { return {y[0], y[1], y[2]}; }
    void load(int lane, double beta, double share_here, double faster_here)
    {
        friction.set_beta(lane, share_here * beta);
        share.set(lane, share_here);
        faster.set(lane, faster_here);
    }
    [[gnu::always_inline]] AtState<P> at(const State& y) const
    {
        const auto e = exponential(max(y.w, P(slowest_logarithm)));
        return {e, this->per_M / e.value};
    }
    [[gnu::always_inline]] State rate(const State& y, const AtState<P>& at, const P& carried) const
    {
        const P balance = carried + (share * y.w + y.p);
        return {at.e.minus_one, -(balance * at.per_Mv), faster * friction.rate(y, at.e)};
    }

    struct Row : MassRow<P> {
        P by_w, per_gs, p_share;

        [[gnu::always_inline]] Row(const MemoryMass& g, const State& y, const AtState<P>& at, const P& speed_other,
                                   const State& rate, const P& h)
            : MassRow<P>(g, at, speed_other, h),
              by_w(g.faster * g.friction.by_w(y, at.e)),
              per_gs(P(1.0) / (P(1.0) / this->hg + g.faster * g.friction.decay(y, at.e))),
              p_share(at.per_Mv * per_gs)
        {
            const P by_speed = select(P(slowest_logarithm) < y.w, rate.w, P(0.0));
            this->diagonal = this->diagonal + g.share * at.per_Mv + by_speed + p_share * by_w;
        }
        [[gnu::always_inline]] P reduced(const State& right, const P& X_other) const
        {
            return this->left_of(right.w, right.X, X_other) - p_share * right.p;
        }
        [[gnu::always_inline]] State solved(const State& right, const P& w) const
        {
            return {(right.X + this->v * w) * this->hg, w, (right.p + by_w * w) * per_gs};
        }
    };
};

}  // namespace stickslip::lanes
