// What dense maps cost: CPU time with few points computed and with all, the share that is computed, and how far the two
// differ; then one row a law: how fast all its points are computed, and how many of them by lanes.
//   benchmark_dense_maps [points along an axis]
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "tests/analysis/simulation/dense/dense_map.h"
#include "tests/analysis/simulation/joints.h"

namespace {

using namespace stickslip;

constexpr double bound = 1e-4;

double cpu_seconds()
{
    timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return now.tv_sec + 1e-9 * now.tv_nsec;
}

void print_map(const char* name, Map map)
{
    map.prepare();
    const double begin = cpu_seconds();
    const auto dense = dense_rows(map, {}, bound);
    const double between = cpu_seconds();
    const auto every = computed_rows(map, {});
    const double end = cpu_seconds();
    const auto found = compare(dense, every);
    std::printf("%-30s %9zu %8.2f %% %9.2f s %9.2f s %8.1f %8zu %10.1e %10.1e\n", name, map.points(),
                100 * static_cast<double>(found.computed) / static_cast<double>(map.points()), between - begin,
                end - between, (end - between) / (between - begin), found.other_verdict, found.worst,
                found.share_at_rest);
}

void print_law(const char* name, Map map)
{
    map.prepare();
    const double begin = cpu_seconds();
    const auto rows = computed_rows(map, {});
    const double seconds = cpu_seconds() - begin;
    const auto lanes =
        std::count_if(rows.begin(), rows.end(), [](const auto& row) { return row.path == DecisionPath::lanes; });
    std::printf("%-30s %9zu %12.1f points/s %8.0f %% by lanes\n", name, rows.size(),
                static_cast<double>(rows.size()) / seconds,
                100 * static_cast<double>(lanes) / static_cast<double>(rows.size()));
}

Joint two_state_joint()
{
    Joint joint = example_joint(6e4, 10, 1e-3);
    auto& law = std::get<RateAndState>(joint.friction.law);
    law.B[0] = 1;
    law.B.push_back(0.84);
    law.L.push_back(law.L[0] / 0.048);
    return joint;
}

Joint lugre_joint()
{
    Joint joint = stribeck_joint(2e4, 0, 1e-3);
    LuGre law;
    law.sigma0 = 1e5, law.sigma1 = std::sqrt(1e5), law.sigma2 = 0.4;
    law.coulomb = 1, law.breakaway = 1.5, law.stribeck_velocity = 1e-3;
    joint.friction.law = law;
    return joint;
}

/// The example's friction on the link of two masses or on their motor, viscous friction on the other.
Joint two_mass_joint(bool on_motor)
{
    Joint joint = example_joint(6e4, 10, 1e-3);
    auto& m = joint.mechanism;
    m.model = Model::two_mass, m.motor_inertia = 0.5, m.link_inertia = 1;
    m.transmission.stiffness = 1e6, m.transmission.damping = 10;
    auto& f = joint.frictions;
    f.motor.law = f.link.law = CoulombViscous{0, 5};
    (on_motor ? f.motor : f.link).law = joint.friction.law;
    return joint;
}

Joint two_contacts(bool ageing)
{
    Joint joint = two_mass_joint(false);
    if (ageing) joint.friction.law = with_ageing(joint).friction.law;
    joint.frictions.motor.law = joint.frictions.link.law = joint.friction.law;
    return joint;
}

Joint sampled_joint()
{
    Joint joint = example_joint(6e4, 10, 1e-3);
    joint.control.period = 1e-3;
    return joint;
}

}  // namespace

int main(int argc, char** argv)
{
    const int n = argc > 1 ? std::atoi(argv[1]) : 300;
    const MapAxis gain{"control.k_p", 1e3, 1e6, n, true};
    std::printf("%-30s %9s %10s %11s %11s %8s %8s %10s %10s\n", "map, one core, CPU time", "points", "computed",
                "dense", "all", "ratio", "verdicts", "numbers", "at rest");
    print_map("slip law, k_v x k_p", {example_joint(6e4, 10, 1e-3), {{"control.k_v", 1, 1e4, n, true}, gain}});
    print_map("slip law, V0 x k_p", {example_joint(6e4, 10, 1e-3), {{"control.V0", 1e-5, 1e-2, n, true}, gain}});
    print_map("Stribeck, V0 x k_p", {stribeck_joint(2e4, 0, 1e-3), {{"control.V0", 2e-4, 2e-2, n, true}, gain}});

    std::printf("\nlaws: every point computed, k_p around the critical gain x V0\n");
    const std::vector<MapAxis> few{{"control.V0", 5e-4, 2e-3, 3, true}, {"control.k_p", 1e4, 2e5, 8, true}};
    print_law("slip law", {example_joint(6e4, 10, 1e-3), few});
    print_law("Stribeck", {stribeck_joint(2e4, 0, 1e-3), few});
    print_law("sampled loop, slip law", {sampled_joint(), few});
    print_law("sampled loop, ageing", {with_ageing(sampled_joint()), few});
    print_law("ageing", {with_ageing(example_joint(6e4, 10, 1e-3)), few});
    print_law("two states", {two_state_joint(), few});
    print_law("LuGre", {lugre_joint(), few});
    print_law("two masses, slip law on link", {two_mass_joint(false), few});
    print_law("two masses, slip law on motor", {two_mass_joint(true), few});
    print_law("two masses, slip law on both", {two_contacts(false), few});
    print_law("two masses, ageing on both", {two_contacts(true), few});
}
