// How fast nonlinear outcomes are, as ratios in one run: lanes of each instruction set against plain CVODE, tuned CVODE
// and SciPy's LSODA on the same 200 points (5 V_0 × 5 k_v × 8 k_p, one third of them unstable), all at rtol 1e-8.
// Rounds are interleaved and ratios are medians over rounds of CPU time, since a shared machine's speed wanders.
//   benchmark_simulation [rounds] [LSODA stride]
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <thread>
#include <vector>

#include "analysis/simulation/lanes/batch.h"
#include "analysis/simulation/lanes/job.h"
#include "tests/benchmark/simulation_cvode.h"

namespace {

using namespace stickslip;
using namespace stickslip::benchmark;

constexpr double rtol = 1e-8;

std::vector<SlipJoint> points()
{
    std::vector<SlipJoint> all;
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 5; ++j)
            for (int k = 0; k < 8; ++k) {
                const double V0 = std::pow(10.0, i - 6), share = 1.5 * j / 4, k_v = share * (B - A) / V0;
                const double damping = share < 1 ? k_v : 0;
                const double k_cr = (B - A - damping * V0) / L * (1 + inertia * V0 / (L * (damping + A / V0)));
                all.push_back({V0, k_v, 0.2 * std::pow(25.0, k / 7.0) * k_cr});
            }
    return all;
}

double cpu_seconds(clockid_t clock = CLOCK_PROCESS_CPUTIME_ID)
{
    timespec now;
    clock_gettime(clock, &now);
    return now.tv_sec + 1e-9 * now.tv_nsec;
}

template <class Work>
double seconds_of(const Work& work)
{
    const double begin = cpu_seconds();
    work();
    return cpu_seconds() - begin;
}

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values.empty() ? 0 : values[values.size() / 2];
}

std::vector<lanes::Job> jobs_of(const std::vector<SlipJoint>& joints, std::size_t repeats, bool search)
{
    std::vector<lanes::Job> jobs;
    for (std::size_t r = 0; r < repeats; ++r)
        for (const auto& j : joints) jobs.push_back(lanes::job(groups_of(j), search));
    return jobs;
}

struct Tally {
    int decays = 0, cycles = 0, bistable = 0, left_over = 0;
    double steps = 0, turns = 0;
};

Tally tally(const std::vector<lanes::Answer>& answers)
{
    Tally t;
    for (const auto& a : answers) {
        t.decays += a.ending == lanes::Ending::decays;
        t.cycles += a.ending == lanes::Ending::cycle;
        t.bistable += a.ending == lanes::Ending::bistable;
        t.left_over += a.ending == lanes::Ending::left_over;
        t.steps += static_cast<double>(a.steps) / static_cast<double>(answers.size());
        if (a.ending == lanes::Ending::cycle) t.turns += a.turns;
    }
    if (t.cycles > 0) t.turns /= t.cycles;
    return t;
}

double lane_rate(const std::vector<lanes::Job>& jobs, std::vector<lanes::Answer>& answers, lanes::Instructions set)
{
    lanes::Settings settings;
    settings.rtol = rtol;
    const double s = seconds_of([&] { lanes::run(jobs.data(), answers.data(), jobs.size(), settings, set); });
    return static_cast<double>(jobs.size()) / s;
}

/// CPU points per second of SciPy's LSODA, 0 where SciPy is not there.
double lsoda_rate(const std::string& stride, std::string& note)
{
    const std::string script = SOURCE_ROOT "/tests/benchmark/simulation_lsoda.py";
    const std::string command = "OPENBLAS_NUM_THREADS=1 /usr/bin/python3 " + script + " " + stride;
    FILE* pipe = popen((command + " 2>/dev/null").c_str(), "r");
    double seconds = 0;
    int count = 0, failed = 0, oscillating = 0;
    const bool read = pipe && std::fscanf(pipe, "%lf %d %d %d", &seconds, &count, &failed, &oscillating) == 4;
    if (pipe) pclose(pipe);
    if (!read) return 0;
    note =
        std::to_string(oscillating) + " oscillate, " + std::to_string(failed) + " failed, of " + std::to_string(count);
    return count / seconds;
}

struct Seconds {
    double wall = 0, cpu = 0;  ///< cpu: of the thread that took most
};

/// The jobs in equal shares, one a thread.
Seconds in_threads(int threads, const std::vector<lanes::Job>& jobs, std::vector<lanes::Answer>& answers)
{
    const double begin = cpu_seconds(CLOCK_MONOTONIC);
    std::vector<std::thread> team;
    std::vector<double> cpu(static_cast<std::size_t>(threads));
    const std::size_t share = jobs.size() / cpu.size();
    for (std::size_t i = 0; i < cpu.size(); ++i)
        team.emplace_back([&, i] {
            lanes::Settings settings;
            settings.rtol = rtol;
            lanes::run(jobs.data() + i * share, answers.data() + i * share, share, settings,
                       lanes::best_instructions());
            cpu[i] = cpu_seconds(CLOCK_THREAD_CPUTIME_ID);
        });
    for (auto& t : team) t.join();
    return {cpu_seconds(CLOCK_MONOTONIC) - begin, *std::max_element(cpu.begin(), cpu.end())};
}

void print_scaling(const std::vector<SlipJoint>& joints)
{
    std::puts("\ncost against size (three-region verdict, widest lanes, one thread), and two threads against one");
    for (const std::size_t size : {1000u, 10000u, 100000u, 1000000u}) {
        auto jobs = jobs_of(joints, size / joints.size(), true);
        std::vector<lanes::Answer> answers(jobs.size());
        const double rate = lane_rate(jobs, answers, lanes::best_instructions());
        std::printf("  %8zu points  %9.0f points/s  %6.2f us a point\n", jobs.size(), rate, 1e6 / rate);
        if (size != 100000u) continue;
        std::vector<double> by_clock, by_cpu;
        for (int i = 0; i < 5; ++i) {
            const auto one = in_threads(1, jobs, answers), two = in_threads(2, jobs, answers);
            by_clock.push_back(one.wall / two.wall / 2);
            by_cpu.push_back(one.cpu / two.cpu / 2);
        }
        std::printf(
            "           two threads: efficiency %.0f %% by CPU time of the slower thread, %.0f %% by the clock "
            "(medians of 5; the clock counts what else runs on the machine)\n",
            100 * median(by_cpu), 100 * median(by_clock));
    }
}

}  // namespace

// In one piece: the rows of one table.
int main(int argc, char** argv)
{
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 3;
    const std::string stride = argc > 2 ? argv[2] : "1";
    const auto joints = points();
    const auto plain_jobs = jobs_of(joints, 1, false), small = jobs_of(joints, 20, false),
               full = jobs_of(joints, 20, true);
    std::vector<lanes::Answer> answers(small.size());
    std::vector<lanes::Instructions> sets{lanes::Instructions::baseline};
    if (lanes::best_instructions() >= lanes::Instructions::avx2) sets.push_back(lanes::Instructions::avx2);
    if (lanes::best_instructions() >= lanes::Instructions::avx512) sets.push_back(lanes::Instructions::avx512);
    const char* names[] = {"lanes baseline", "lanes AVX2", "lanes AVX-512"};

    std::vector<double> lsoda, plain, tuned;
    std::vector<std::vector<double>> one(3), three(3);
    std::string lsoda_note;
    int judged[2][4] = {};
    for (int r = 0; r < rounds; ++r) {
        if (const double rate = lsoda_rate(stride, lsoda_note); rate > 0) lsoda.push_back(rate);
        plain.push_back(joints.size() / seconds_of([&] {
                            for (const auto& j : joints) ++judged[0][static_cast<int>(plain_cvode(j, rtol))];
                        }));
        TunedCvode solver(rtol);
        tuned.push_back(joints.size() / seconds_of([&] {
                            for (const auto& job : plain_jobs) ++judged[1][static_cast<int>(solver.judge(job))];
                        }));
        for (const auto set : sets) {
            one[static_cast<int>(set)].push_back(lane_rate(small, answers, set));
            three[static_cast<int>(set)].push_back(lane_rate(full, answers, set));
        }
    }
    const auto ratio = [&](const std::vector<double>& fast, const std::vector<double>& slow) {
        std::vector<double> r;
        for (std::size_t i = 0; i < std::min(fast.size(), slow.size()); ++i) r.push_back(fast[i] / slow[i]);
        return median(r);
    };
    std::printf("200 points, rtol 1e-8, one core, %d rounds, CPU time\n", rounds);
    std::printf("%-34s %10.1f points/s  (%s)\n", "SciPy LSODA", median(lsoda),
                lsoda.empty() ? "not installed" : lsoda_note.c_str());
    const char* methods[] = {"plain CVODE", "tuned CVODE"};
    const std::vector<double>* rates[] = {&plain, &tuned};
    for (int i = 0; i < 2; ++i)
        std::printf("%-34s %10.1f points/s  (%d oscillate, %d failed, %d unsure)\n", methods[i], median(*rates[i]),
                    judged[i][1] / rounds, judged[i][2] / rounds, judged[i][3] / rounds);
    std::printf("%-34s %10s %14s %14s %14s\n", "", "points/s", "x LSODA", "x plain CVODE", "x tuned CVODE");
    for (const auto set : sets) {
        const int i = static_cast<int>(set);
        const std::vector<double>* kinds[] = {&one[i], &three[i]};
        const char* labels[] = {", one disturbance", ", three regions"};
        for (int k = 0; k < 2; ++k)
            std::printf("%-34s %10.0f %14.0f %14.0f %14.0f\n", (std::string(names[i]) + labels[k]).c_str(),
                        median(*kinds[k]), ratio(*kinds[k], lsoda), ratio(*kinds[k], plain), ratio(*kinds[k], tuned));
    }
    for (const auto* jobs : {&small, &full}) {
        lane_rate(*jobs, answers, sets.back());
        const auto t = tally(answers);
        std::printf("%s: %d decay, %d cycle, %d bistable, %d left over; %.0f lane steps a point, %.1f turns a cycle\n",
                    jobs == &small ? "one disturbance" : "three regions", t.decays / 20, t.cycles / 20, t.bistable / 20,
                    t.left_over / 20, t.steps, t.turns);
    }
    print_scaling(joints);
}
