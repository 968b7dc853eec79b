// How many linear answers a core gives in a second. Prints, asserts nothing about time.
#include <cstdio>
#include <ctime>
#include <functional>

#include "analysis/stability/critical_gain.h"
#include "analysis/stability/joint_crossings.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/joint/sample_joints.h"

using namespace stickslip;

namespace {

/// Time of the core, not of the clock on the wall: other programs on the machine do not count.
double core_seconds()
{
    return double(std::clock()) / CLOCKS_PER_SEC;
}

/// Answers per second, k_p swept over three decades so that no two answers are the same.
void measure(const char* name, Joint joint, int count, const std::function<double(const Joint&)>& answer)
{
    double sum = 0;
    const double start = core_seconds();
    for (int i = 0; i < count; ++i) {
        joint.control.k_p = 1e3 * std::pow(10, 3.0 * i / count);
        sum += answer(joint);
    }
    const double time = core_seconds() - start;
    std::printf("%-58s %12.0f /s   (checksum %g)\n", name, count / time, sum);
}

/// Critical gains per second by the closed form alone, over velocity gains, for a friction that is linearised already.
void measure_closed_form(const Joint& joint, int count)
{
    const auto friction = linearise(joint.friction, joint.control.V0);
    double sum = 0;
    const double start = core_seconds();
    for (int i = 0; i < count; ++i)
        if (const auto critical = critical_gain(joint.mechanism.inertia, 1e-6 * i, friction))
            sum += critical->k_p + critical->omega;
    const double time = core_seconds() - start;
    std::printf("%-58s %12.0f /s   (checksum %g)\n", "single mass, one state: closed form alone", count / time, sum);
}

}  // namespace

int main()
{
    const auto row = [](const Joint& j) { return double(linear_point(j).state_variable_stable); };
    const auto verdict = [](const Joint& j) { return double(is_stable(linear_joint(j, j.control.V0))); };
    const auto abscissa = [](const Joint& j) { return spectral_abscissa(linear_joint(j, j.control.V0)); };
    const auto gains = [](const Joint& j) {
        return double(rational_crossings(linear_joint(j, j.control.V0), Gain::k_p).size());
    };
    measure_closed_form(samples::single_mass(1), 100'000'000);
    measure("single mass, one state: row of a sweep", samples::single_mass(1), 1'000'000, row);
    measure("single mass, one state: stability verdict", samples::single_mass(1), 500'000, verdict);
    measure("three masses, nine states: stability verdict", samples::nine_states(), 200'000, verdict);
    measure("three masses, nine states: spectral abscissa", samples::nine_states(), 20'000, abscissa);
    measure("three masses, nine states: all crossings in k_p", samples::nine_states(), 20'000, gains);
    measure("three masses, nine states: row of a sweep", samples::nine_states(), 10'000, row);
    const auto sampled = [](Joint joint, double delay) {
        joint.control.period = 1e-3;
        joint.control.delay = delay;
        joint.control.velocity_estimate.form = EstimateForm::backward_difference;
        return joint;
    };
    measure("single mass, sampled, one tick late: row of a sweep", sampled(samples::single_mass(1), 1e-3), 50'000, row);
    measure("single mass, sampled, 250 ticks late: row of a sweep", sampled(samples::single_mass(1), 0.25), 50, row);
    measure("three masses, sampled, one tick late: row of a sweep", sampled(samples::nine_states(), 1e-3), 10'000, row);
    Joint lagging = samples::single_mass(1);
    lagging.friction.law = samples::time_lag(Stribeck{10, 0, 1, 1e-2, 2});
    measure("single mass, time lag: row of a sweep", lagging, 200, row);
    measure("single mass, time lag, sampled: row of a sweep", sampled(lagging, 1e-3), 50, row);
}
