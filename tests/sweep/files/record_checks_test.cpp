// What looks wrong about a record that reads well, by the signals themselves.
#include "sweep/files/records/record_checks.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace stickslip;

namespace {

Joint proportional(double k_p)
{
    Joint joint;
    joint.mechanism.motion = Motion::revolute;
    joint.mechanism.inertia = 0.05;
    joint.control.k_p = k_p;
    joint.control.period = 1e-3;
    return joint;
}

/// Logged by a controller with k_p = 20 N·m/rad and this limit, while the joint swings about its reference.
Record logged(double limit)
{
    Record r;
    for (int k = 0; k < 2000; ++k) {
        const double t = 1e-3 * k;
        r.time.push_back(t);
        r.reference_position.push_back(0);
        r.position.push_back(std::sin(9 * t));
        r.effort_command.push_back(std::clamp(-20 * r.position.back(), -limit, limit));
    }
    return r;
}

bool of_another_joint(const Record& record, const Joint& joint)
{
    const auto found = files::suspicions(record, joint);
    return std::any_of(found.begin(), found.end(),
                       [](const Note& n) { return n.code == Note::Code::gains_of_another_joint; });
}

}  // namespace

TEST_CASE("a command at its limit does not make a record one of another joint", "[record]")
{
    CHECK_FALSE(of_another_joint(logged(100), proportional(20)));
    CHECK(of_another_joint(logged(100), proportional(200)));
    CHECK_FALSE(of_another_joint(logged(1), proportional(20)));
    CHECK(of_another_joint(logged(1), proportional(200)));
}
