// §4 and §5 of the paper.
#include "analysis/stability/comparison.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/resolution.h"
#include "analysis/stability/steady.h"
#include "sweep/study/paper/paper_parts.h"

#include <cmath>

namespace stickslip {
namespace {

void add_regions(PaperStability& s)
{
    Joint joint = paper_joint();
    Slice& slice = s.regions;
    slice.x = {"control.k_p", "k_{p}", "position gain", Quantity::stiffness, true, log_steps(1e3, 1e6, 121)};
    slice.y = {"control.k_v", "k_{v}", "velocity gain", Quantity::damping, false, {}};
    for (int i = 0; i <= 120; ++i) slice.y.values.push_back(7.5 * i);
    for (const double k_v : slice.y.values)
        for (const double k_p : slice.x.values) {
            joint.control.k_p = k_p;
            joint.control.k_v = k_v;
            const auto point = linear_point(joint);
            slice.abscissa.push_back(point.spectral_abscissa);
            slice.region.push_back(point.region);
        }
    constexpr int mesh = 96;
    s.boundaries.curves = chart_boundaries(paper_joint(), slice.x, slice.y, mesh);
}

void add_crossing_condition(PaperStability& s)
{
    const Joint joint = paper_joint();
    const auto linear = linear_joint(joint, commanded_velocity(joint));
    for (int i = 0; i <= 300; ++i) {
        s.kernel.x.push_back(i);
        s.kernel.y.push_back(transfer(linear.friction[0], {0, double(i)}).real());
    }
    s.f_v = linear.friction[0].f_v;
    s.crossing_omega = linear_verdict(joint).state_variable.crossings.at(0).omega;
}

/// §5: the damping that each theory asks of Armstrong's joint as velocity goes to zero.
void add_demanded_damping(PaperStability& s)
{
    Joint joint = paper_joint();
    Friction curve;
    curve.law = Stribeck{58, 0, 2, 5e-3, 2};
    constexpr double least_shown = 0.1, soft_spring = 2e4, stiff_spring = 5.2e4;  // N·s/m, N/m
    const auto shown = [](double k_v) { return k_v > least_shown ? k_v : missing; };
    const auto by_gauss = [&](double V) { return shown(-steady_slope(linearise(curve, V))); };
    const auto with_memory = [&](double k_p) {
        return [&, k_p](double V) {
            joint.control.V0 = V;
            joint.control.k_p = k_p;
            return shown(compare_theories(joint).k_v_demanded_memory());
        };
    };
    const auto add = [](Samples& line, double V, double k_v) { line.x.push_back(V), line.y.push_back(k_v); };
    for (const double V : log_steps(1e-5, 1e-1, 161)) {
        add(s.gauss, V, by_gauss(V));
        add(s.logarithm, V, shown(-steady_slope(linearise(joint.friction, V))));
        add(s.soft, V, with_memory(soft_spring)(V));
        add(s.stiff, V, with_memory(stiff_spring)(V));
    }
    smooth(s.gauss, by_gauss);
    smooth(s.stiff, with_memory(stiff_spring));
}

/// §5: ramps of force through springs.
void add_ramps(PaperStability& s)
{
    Joint joint = paper_joint();
    joint.control.kind = ControlKind::force;
    for (const double rate : log_steps(0.1, 1e4, 101)) {
        const auto stable = stable_springs(joint, rate, 1e3, 1e7, Theory::state_variable);
        s.critical_spring.x.push_back(rate);
        s.critical_spring.y.push_back(stable.empty() ? missing : stable.front().low);
    }
}

}  // namespace

PaperStability paper_stability()
{
    PaperStability s;
    add_regions(s);
    add_crossing_condition(s);
    s.locus = sampled_root_locus(paper_joint(), 1e3, 1e7);
    add_demanded_damping(s);
    add_ramps(s);
    return s;
}

}  // namespace stickslip
