// A joint of one to three bodies about steady sliding: the linear system of Figs. 4-7.
#pragma once
#include <array>
#include <complex>

#include "analysis/joint/joint.h"
#include "analysis/joint/spring.h"
#include "analysis/results/point.h"
#include "analysis/stability/linear_friction.h"

namespace stickslip {

inline constexpr int max_bodies = 3;

/// The spring whose effort loads the friction of a body.
inline int spring_of(int body)
{
    return body == 0 ? 0 : body - 1;
}

/// A joint beside this one that the mass matrix couples to its link, under its own linear loop: on the link it acts
/// like −(m_jk s²)²/D_k(s), D_k = m_kk s² + c s + k.
struct LinearNeighbour {
    double inertia = 0, coupling = 0, damping = 0, stiffness = 0;
};

/// M s² x + K x + D s x + (f_v − G) s x + k_c w x_link + u (k_p + k_v s) x_measured = disturbance, all in joint
/// coordinates. Bodies in order motor, transmission, link. u: the loop's force per body: 1 on the motor for position
/// control; for force control, where k_p and k_v are the finger between link and surface, 1 on the link and the force
/// gain on the motor, which feeds the finger's force back. w: the same for the contact stiffness k_c.
struct LinearJoint {
    int bodies = 1;
    std::array<double, max_bodies> inertia{};
    std::array<double, max_bodies - 1> stiffness{}, damping{};  ///< between neighbours
    std::array<double, max_bodies> contact{};                   ///< k_c w
    std::array<double, max_bodies> actuated{};                  ///< u
    /// Friction per effort that the spring before a body carries (the motor: the one behind it), with the effort's
    /// sign: carried_i (k + c s)(x_m − x_{m+1}) on body i. It is no force between the two, so that K is not symmetric.
    std::array<double, max_bodies> carried{};
    int measured = 0;
    double k_p = 0, k_v = 0;
    std::array<LinearFriction, max_bodies> friction;
    ShortList<LinearNeighbour, max_neighbours> neighbour;
    /// What a moving normal load takes out of the state of the link's friction, as inertia and as slope at low
    /// frequency: not part of the velocity-only theory, which has no state.
    double state_inertia = 0, state_slope = 0;

    int link() const { return bodies - 1; }
    int states() const;     ///< 2 a body and a neighbour, and those of the frictions
    bool rational() const;  ///< no delays and tables: finitely many roots

    /// K_ik without the loop, contact included.
    double stiffness_at(int i, int k) const
    {
        return chain(stiffness, i, k) + by_load(stiffness, i, k) + (k == link() ? contact[i] : 0);
    }
    double damping_at(int i, int k) const { return chain(damping, i, k) + by_load(damping, i, k); }

  private:
    double by_load(const std::array<double, max_bodies - 1>& springs, int i, int k) const
    {
        if (carried[i] == 0) return 0;
        const int before = spring_of(i);
        return k == before ? carried[i] * springs[before] : k == before + 1 ? -carried[i] * springs[before] : 0;
    }
    double chain(const std::array<double, max_bodies - 1>& springs, int i, int k) const
    {
        if (i == k) return (i > 0 ? springs[i - 1] : 0) + (i < bodies - 1 ? springs[i] : 0);
        return i - k == 1 ? -springs[k] : k - i == 1 ? -springs[i] : 0;
    }
};

/// One body of a joint: its inertia reflected to joint coordinates, its friction at its own side, its displacement per
/// joint displacement (the N of Fig. 4 for the motor, 1 for the link), and its steady velocity per V_0 in joint
/// coordinates: 1, but above it behind the springs that a force ramp goes on stretching, 1 + k/k_tr.
struct Body {
    double inertia;
    const Friction* friction;
    double ratio;
    double speed = 1;

    /// Its own steady sliding velocity, at its own side.
    double velocity(double V0) const { return ratio * speed * V0; }
};

/// The bodies of a joint in joint order, with the springs and dampers between them in joint coordinates.
struct Chain {
    int bodies = 0;
    std::array<Body, max_bodies> body{};
    std::array<double, max_bodies - 1> stiffness{}, cubic{}, damping{};

    Spring spring(int i) const { return {stiffness[i], cubic[i]}; }
};

/// Reflects every model to joint coordinates: Fig. 4 → Fig. 5 by the table of §3 (M'_m = N² M_m, M_tr = J_tr/d²,
/// k'_m-tr = N² k_m-tr). The frictions of `joint` are referred to, not copied.
Chain chain_of(const Joint& joint);

/// μ of a normal load that moves: normal.mu, or the steady friction at V per friction.normal_load where that is a
/// force.
double friction_per_load(const Joint& joint, double V);

/// What the loop and the springs carry in steady sliding at V (joint side), with friction that grows with it:
/// effort[0] that of the loop on the motor, effort[i] of the spring before body i. From the link up,
/// T = f + μ|T| + what the next one carries; `load` is the constant load counted, in the direction of motion.
std::array<double, max_bodies> carried_efforts(const Joint& joint, double V, double load);

/// The joint about steady sliding of all its bodies at V (joint side; the motor slides at N V and its friction comes
/// back N² times as large: δf'_m = N δf_m(N ẋ')).
LinearJoint linear_joint(const Joint& joint, double V);

/// The same with each friction replaced by its steady-state curve: the velocity-only theory, (20)-(21).
LinearJoint velocity_only(LinearJoint joint);

}  // namespace stickslip
