// Two masses with a spring between them in the kernel: the equations of watched_job.h.
#pragma once
#include "analysis/simulation/lanes/one_of_two_masses.h"
#include "analysis/simulation/lanes/watched_model.h"

namespace stickslip::lanes {

template <class Link, class Motor>
struct Both {
    Link link;
    Motor motor;

    [[gnu::always_inline]] static Both zero() { return {Link::zero(), Motor::zero()}; }
    [[gnu::always_inline]] void add(const Both& y) { link.add(y.link), motor.add(y.motor); }
    template <class P>
    [[gnu::always_inline]] void add(const P& weight, const Both& y)
    {
        link.add(weight, y.link), motor.add(weight, y.motor);
    }
};

template <class P, class Link, class Motor>
struct TwoMasses : Watched {
    using State = Both<typename Link::State, typename Motor::State>;
    static constexpr int size = Link::size + Motor::size;
    static constexpr double slow = Link::slow;
    Link link;
    Motor motor;

    static State state(const P* y) { return {Link::state(y), Motor::state(y + Link::size)}; }
    static constexpr Job idle() { return harmless(WatchedLaw::slip_on_both); }
    void load(int lane, const WatchedGroups& g)
    {
        const auto& pair = g.pair;
        const double to_motor = 1 - pair.measured_link;
        hold(link, lane, g.M, pair.stiffness, pair.damping + (g.remembers_on_link() ? 0 : pair.link), -pair.stiffness,
             -pair.damping);
        hold(motor, lane, pair.motor_inertia, pair.stiffness + to_motor * g.K,
             pair.damping + to_motor * g.c + (g.remembers_on_motor() ? 0 : pair.motor),
             -pair.stiffness + pair.measured_link * g.K, -pair.damping + pair.measured_link * g.c);
        link.load(lane, pair.link, 1, 1);
        motor.load(lane, pair.motor, pair.share, pair.faster);
    }

  private:
    static void hold(Held<P>& held, int lane, double M, double K, double c, double K_other, double c_other)
    {
        held.per_M.set(lane, 1 / M);
        held.K.set(lane, K), held.c.set(lane, c);
        held.K_other.set(lane, K_other), held.c_other.set(lane, c_other);
    }
};

template <class Link, class Motor>
[[gnu::always_inline]] inline auto part(const Both<Link, Motor>& y, int k)
{
    constexpr int size = sizeof(Link) / sizeof(y.link.X);
    return k < size ? part(y.link, k) : part(y.motor, k - size);
}
template <class P, class Link, class Motor>
[[gnu::always_inline]] inline P stiffness_of(const TwoMasses<P, Link, Motor>& g, int k)
{
    return k == 0 ? g.link.K : k == Link::size ? g.motor.K : P(1.0);
}

/// A number or more of either mass.
template <class T>
struct OfEach {
    T link, motor;
};
template <class P>
struct AtBoth {
    OfEach<Exponential<P>> e;
    OfEach<P> per_Mv;
};
template <class P, class Link, class Motor, class State>
[[gnu::always_inline]] inline AtBoth<P> at_state(const TwoMasses<P, Link, Motor>& g, const State& y)
{
    const AtState<P> link = g.link.at(y.link), motor = g.motor.at(y.motor);
    return {{link.e, motor.e}, {link.per_Mv, motor.per_Mv}};
}

template <class P, class Link, class Motor>
[[gnu::always_inline]] inline auto rate(const TwoMasses<P, Link, Motor>& g,
                                        const Both<typename Link::State, typename Motor::State>& y,
                                        const OfEach<Exponential<P>>& e, const OfEach<P>& per_Mv)
{
    const P &S_l = e.link.minus_one, &S_m = e.motor.minus_one, &X_l = y.link.X, &X_m = y.motor.X;
    return Both<typename Link::State, typename Motor::State>{
        g.link.rate(y.link, {e.link, per_Mv.link}, g.link.carries(X_l, S_l, X_m, S_m)),
        g.motor.rate(y.motor, {e.motor, per_Mv.motor}, g.motor.carries(X_m, S_m, X_l, S_l))};
}

/// The rows of w_l and w_m remain, and w_m goes first.
template <class Link, class Motor, class P>
struct TwoMassElimination {
    typename Link::Row link;
    typename Motor::Row motor;
    P per_motor, share, per_pivot;

    [[gnu::always_inline]] auto solve(const Both<typename Link::State, typename Motor::State>& right) const
    {
        const P of_link = link.reduced(right.link, right.motor.X), of_motor = motor.reduced(right.motor, right.link.X);
        const P w_link = (of_link - share * of_motor) * per_pivot;
        const P w_motor = (of_motor - motor.by_other * w_link) * per_motor;
        return Both<typename Link::State, typename Motor::State>{link.solved(right.link, w_link),
                                                                 motor.solved(right.motor, w_motor)};
    }
};
template <class P, class Link, class Motor>
[[gnu::always_inline]] inline TwoMassElimination<Link, Motor, P> eliminate(
    const TwoMasses<P, Link, Motor>& g, const Both<typename Link::State, typename Motor::State>& y,
    const OfEach<Exponential<P>>& e, const OfEach<P>& per_Mv,
    const Both<typename Link::State, typename Motor::State>& rate, const P& h)
{
    const typename Link::Row link(g.link, y.link, {e.link, per_Mv.link}, e.motor.value, rate.link, h);
    const typename Motor::Row motor(g.motor, y.motor, {e.motor, per_Mv.motor}, e.link.value, rate.motor, h);
    const P per_motor = P(1.0) / motor.diagonal, share = link.by_other * per_motor;
    return {link, motor, per_motor, share, P(1.0) / (link.diagonal - share * motor.by_other)};
}

template <class P, template <class> class Friction>
using OnLink = TwoMasses<P, MemoryMass<P, Friction>, ViscousMass<P>>;
template <class P, template <class> class Friction>
using OnMotor = TwoMasses<P, ViscousMass<P>, MemoryMass<P, Friction>>;
template <class P, template <class> class Friction>
using OnBoth = TwoMasses<P, MemoryMass<P, Friction>, MemoryMass<P, Friction>>;

template <class P>
using SlipOnLink = RosenbrockModel<P, OnLink<P, SlipState>>;
template <class P>
using AgeingOnLink = RosenbrockModel<P, OnLink<P, AgeingState>>;
template <class P>
using SlipOnMotor = RosenbrockModel<P, OnMotor<P, SlipState>>;
template <class P>
using AgeingOnMotor = RosenbrockModel<P, OnMotor<P, AgeingState>>;
template <class P>
using SlipOnBoth = RosenbrockModel<P, OnBoth<P, SlipState>>;
template <class P>
using AgeingOnBoth = RosenbrockModel<P, OnBoth<P, AgeingState>>;

}  // namespace stickslip::lanes
