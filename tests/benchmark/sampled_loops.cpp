// How fast outcomes of a sampled loop are, as a ratio in one run: the product's points against plain CVODE, started
// anew at each tick, on the same 200 points of the joint of a 1 kHz loop with one tick of dead time (k_p 20 to 100
// kN/m, two thirds of them stick-slip), both at rtol 1e-8. Rounds are interleaved and the ratio is the median over
// rounds of CPU time, since a shared machine's speed wanders.
//   benchmark_sampled_loops [rounds] [CVODE stride]
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "analysis/simulation/points.h"
#include "analysis/stability/verdict.h"
#include "tests/benchmark/simulation_cvode.h"

namespace {

using namespace stickslip;
using benchmark::Judged;

constexpr double rtol = 1e-8, T = 1e-3, V0 = 1e-3, k_v = 10;
constexpr int count = 200, late_ticks = 1;

double gain(int i)
{
    return 20e3 + 80e3 * i / (count - 1);
}

Joint joint_of(double k_p)
{
    RateAndState law;
    law.f0 = benchmark::f0, law.A = benchmark::A, law.V_star = benchmark::V_star;
    law.B.push_back(benchmark::B), law.L.push_back(benchmark::L);
    Joint joint;
    joint.mechanism.inertia = benchmark::inertia;
    joint.control.k_p = k_p, joint.control.k_v = k_v, joint.control.V0 = V0;
    joint.control.period = T, joint.control.delay = late_ticks * T;
    joint.control.velocity_estimate.form = EstimateForm::backward_difference;
    joint.friction.law = law;
    return joint;
}

/// What a user would write first: x, ln V, θ in SI units, Jacobian by differences, the solver started anew where the
/// force jumps; fifty turns, then a look at the amplitude.
class TickedCvode {
  public:
    TickedCvode() : solver_(&rate)
    {
        double* tolerance = NV_DATA_S(solver_.tolerance);
        tolerance[0] = rtol * benchmark::L, tolerance[1] = tolerance[2] = rtol;
        CVodeSVtolerances(solver_.cvode, rtol, solver_.tolerance);
        CVodeSetUserData(solver_.cvode, &force_);
    }

    Judged judge(double k_p)
    {
        using namespace benchmark;
        const double steady = f0 + (A - B) * std::log(V0 / V_star);
        double* s = NV_DATA_S(solver_.y);
        s[0] = 0, s[1] = std::log((1 + kick) * V0);
        s[2] = -B * std::log(V0 / V_star) - A * std::log(1 + kick);
        double before = s[0], late[late_ticks], swing = 0;
        std::fill_n(late, late_ticks, steady);
        const double turn = natural_turn(groups_of({V0, k_v, k_p})) * L / V0;
        const long ticks = std::lround(watched_turns * turn / T);
        for (long k = 0; k < ticks; ++k) {
            force_ = late[k % late_ticks];
            late[k % late_ticks] = steady - k_p * s[0] - k_v * (s[0] - before) / T;
            before = s[0];
            double t = 0;
            CVodeReInit(solver_.cvode, 0, solver_.y);
            CVodeSetStopTime(solver_.cvode, T);
            if (CVode(solver_.cvode, T, solver_.y, &t, CV_NORMAL) < 0) return Judged::failed;
            if (k > 0.6 * static_cast<double>(ticks)) swing = std::max(swing, std::abs(s[1] - std::log(V0)));
        }
        return swing > large_swing ? Judged::oscillates : Judged::decays;
    }

  private:
    static int rate(double, N_Vector y, N_Vector out, void* force)
    {
        using namespace benchmark;
        const double *s = NV_DATA_S(y), V = std::exp(s[1]), log = s[1] - std::log(V_star);
        double* d = NV_DATA_S(out);
        d[0] = V - V0;
        d[1] = (*static_cast<double*>(force) - (f0 + A * log + s[2])) / (inertia * V);
        d[2] = -(V / L) * (s[2] + B * log);
        return 0;
    }

    double force_ = 0;
    CvodeSolver solver_;
};

double cpu_seconds()
{
    timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv)
{
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 3, stride = argc > 2 ? std::atoi(argv[2]) : 10;
    std::vector<Joint> joints;
    for (int i = 0; i < count; ++i) joints.push_back(joint_of(gain(i)));
    std::vector<double> plain, one, three, one_ratio, three_ratio;
    std::vector<PointResult> rows(count);
    int oscillating[2] = {}, unlike = 0, bistable = 0, open = 0;
    for (int r = 0; r < rounds; ++r) {
        std::vector<Judged> judged;
        double begin = cpu_seconds();
        TickedCvode solver;
        for (int i = 0; i < count; i += stride) judged.push_back(solver.judge(gain(i)));
        plain.push_back(static_cast<double>(judged.size()) / (cpu_seconds() - begin));
        for (const bool region : {false, true}) {
            NonlinearOptions options;
            options.rtol = rtol;
            options.region = region;
            for (int i = 0; i < count; ++i) rows[i] = linear_point(joints[i]);
            begin = cpu_seconds();
            nonlinear_points(joints, options, rows);
            (region ? three : one).push_back(count / (cpu_seconds() - begin));
        }
        one_ratio.push_back(one.back() / plain.back()), three_ratio.push_back(three.back() / plain.back());
        if (r > 0) continue;
        for (int i = 0; i < count; ++i) {
            const bool ends_in_cycle = rows[i].outcome != Outcome::stable_sliding;
            oscillating[1] += ends_in_cycle;
            bistable += rows[i].region == Region::bistable;
            open += rows[i].reason != Reason::none;
            if (i % stride != 0) continue;
            const bool by_cvode = judged[i / stride] == Judged::oscillates;
            oscillating[0] += by_cvode;
            unlike += by_cvode != ends_in_cycle;
        }
    }
    std::printf("%d points of a 1 kHz loop, rtol 1e-8, one core, %d rounds, CPU time\n", count, rounds);
    std::printf("%-34s %10.2f points/s  (%d of %d oscillate)\n", "plain CVODE, anew at each tick", median(plain),
                oscillating[0], (count + stride - 1) / stride);
    std::printf("%-34s %10.1f points/s  x plain CVODE %8.1f\n", "points, one disturbance", median(one),
                median(one_ratio));
    std::printf("%-34s %10.1f points/s  x plain CVODE %8.1f\n", "points, three regions", median(three),
                median(three_ratio));
    std::printf("%d oscillate, %d bistable, %d undecided; %d of CVODE's points have another outcome\n", oscillating[1],
                bistable, open, unlike);
}
