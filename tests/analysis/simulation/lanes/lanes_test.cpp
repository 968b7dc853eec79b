// The lanes against the reference, and their promise of equal bits.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "analysis/simulation/lanes/batch.h"
#include "analysis/simulation/lanes/functions.h"
#include "analysis/simulation/lanes/stribeck_batch.h"
#include "analysis/simulation/points.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/lanes/lanes_comparison.h"

using namespace stickslip;

namespace {

template <class Answer, class Job>
std::vector<Answer> answers_of(const std::vector<Job>& jobs, lanes::Instructions set)
{
    std::vector<Answer> answers(jobs.size());
    lanes::run(jobs.data(), answers.data(), jobs.size(), {}, set);
    return answers;
}

bool same_bits(double a, double b)
{
    return std::memcmp(&a, &b, sizeof a) == 0;
}

bool same_bits(const lanes::Answer& a, const lanes::Answer& b)
{
    return a.ending == b.ending && same_bits(a.w_min, b.w_min) && same_bits(a.w_max, b.w_max) &&
           same_bits(a.x_min, b.x_min) && same_bits(a.x_max, b.x_max) && same_bits(a.period, b.period) &&
           same_bits(a.rest_time, b.rest_time) && a.turns == b.turns;
}

bool same_bits(const lanes::StribeckAnswer& a, const lanes::StribeckAnswer& b)
{
    return a.ending == b.ending && same_bits(a.u_min, b.u_min) && same_bits(a.u_max, b.u_max) &&
           same_bits(a.x_min, b.x_min) && same_bits(a.x_max, b.x_max) && same_bits(a.period, b.period) &&
           same_bits(a.rest_time, b.rest_time) && a.turns == b.turns;
}

std::vector<lanes::Job> jobs_of(const std::vector<Joint>& joints)
{
    std::vector<lanes::Job> jobs;
    for (const auto& joint : joints) jobs.push_back(lanes::job(lanes::scaled(joint)->groups, true));
    return jobs;
}

std::vector<lanes::StribeckJob> stribeck_jobs(std::size_t count, unsigned seed)
{
    std::vector<lanes::StribeckJob> jobs;
    for (const auto& joint : random_stribeck_joints(count, seed))
        if (const auto s = lanes::stribeck_scaled(joint)) jobs.push_back(lanes::job(s->groups, true));
    return jobs;
}

template <class Answer, class Job>
void check_independence(const std::vector<Job>& jobs)
{
    const auto set = lanes::best_instructions();
    const auto forwards = answers_of<Answer>(jobs, set);
    const std::vector<Job> backwards(jobs.rbegin(), jobs.rend());
    const auto reversed = answers_of<Answer>(backwards, set);
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        CHECK(same_bits(forwards[i], reversed[jobs.size() - 1 - i]));
        if (i % 7 == 0) CHECK(same_bits(forwards[i], answers_of<Answer>(std::vector<Job>{jobs[i]}, set)[0]));
    }
}

template <class Answer, class Job>
void check_instruction_sets(const std::vector<Job>& jobs)
{
    const auto baseline = answers_of<Answer>(jobs, lanes::Instructions::baseline);
    for (const auto set : {lanes::Instructions::avx2, lanes::Instructions::avx512}) {
        if (set > lanes::best_instructions()) continue;
        const auto wide = answers_of<Answer>(jobs, set);
        for (std::size_t i = 0; i < jobs.size(); ++i) {
            CHECK(wide[i].ending == baseline[i].ending);
            // a decay has no period: what stands there is its last turn, which was followed roughly
            if (baseline[i].ending != lanes::Ending::decays)
                CHECK(wide[i].period == Approx(baseline[i].period).epsilon(1e-5));
        }
    }
}

void check_against_cvode(const std::vector<Joint>& joints, bool region, double least_share)
{
    int by_lanes = 0, undecided = 0;
    for (const auto& c : compare_with_cvode(joints, region)) {
        CHECK(c.same_outcome());
        CHECK(c.growth < 1e-5);
        CHECK(c.row_spectrum < 1e-5);
        CHECK(c.rest < 1e-6);
        CHECK(c.period < 1e-5);
        CHECK(c.amplitude < 1e-3);
        by_lanes += c.row.path == DecisionPath::lanes;
        undecided += c.undecided();
    }
    CHECK(undecided == 0);
    CHECK(by_lanes > least_share * static_cast<double>(joints.size()));
}

}  // namespace

TEST_CASE("packs: e^w and e^w − 1 against libm", "[lanes]")
{
    for (double w = -699.3; w < 700; w += 0.37) {
        const auto e = lanes::exponential(lanes::Pack<2, 2>(w));
        CHECK(e.value[1] == Approx(std::exp(w)).epsilon(1e-15));
    }
    for (double w = 1e-300; w < 3; w *= 1.7)
        for (const double sign : {-1.0, 1.0}) {
            const auto e = lanes::exponential(lanes::Pack<2, 2>(sign * w));
            CHECK(e.minus_one[2] == Approx(std::expm1(sign * w)).epsilon(1e-15));
        }
}

TEST_CASE("an answer depends on its job alone, not on lane, neighbours or order", "[lanes]")
{
    auto both_laws = jobs_of(random_joints(60, 11));
    for (const auto& job : jobs_of(random_ageing_joints(60, 15))) both_laws.push_back(job);
    check_independence<lanes::Answer>(both_laws);
    check_independence<lanes::StribeckAnswer>(stribeck_jobs(90, 13));
    // heavy joints plunge towards rest in steps of 1e-16 L/V_0 and less, wherever others stand at that moment
    std::vector<lanes::Job> heavy;
    for (int i = 0; i < 60; ++i) {
        const double V0 = 1e-2 * std::pow(10, i / 59.0), k_p = 1e5 * std::pow(10, (7 * i % 60) / 59.0);
        heavy.push_back(lanes::job(lanes::scaled(example_joint(k_p, 10, V0))->groups, true));
    }
    check_independence<lanes::Answer>(heavy);
}

TEST_CASE("every instruction set gives the same outcomes", "[lanes]")
{
    check_instruction_sets<lanes::Answer>(jobs_of(random_joints(100, 12)));
    check_instruction_sets<lanes::Answer>(jobs_of(random_ageing_joints(100, 16)));
    check_instruction_sets<lanes::StribeckAnswer>(stribeck_jobs(150, 14));
}

TEST_CASE("joints of equal groups have equal rows but for their units", "[lanes]")
{
    const Joint one = example_joint(20000, 10, 1e-3);
    Joint other = one;  // twice the forces, three times the length
    auto& law = std::get<RateAndState>(other.friction.law);
    law.A *= 2, law.B[0] *= 2, law.f0 *= 2, law.L[0] *= 3;
    other.mechanism.inertia *= 6, other.control.k_p *= 2.0 / 3, other.control.k_v *= 2;
    const Joint both[] = {one, other};
    PointResult points[2];
    nonlinear_points(both, {}, points);
    CHECK(points[0].path == DecisionPath::lanes);
    CHECK(points[1].period == Approx(3 * points[0].period).epsilon(1e-14));
    CHECK(points[1].amplitude == Approx(3 * points[0].amplitude).epsilon(1e-14));
    CHECK(points[1].velocity_max == points[0].velocity_max);
    CHECK(points[1].growth_rate == Approx(points[0].growth_rate / 3).epsilon(1e-14));
}

TEST_CASE("what lanes do not cover falls to the reference and says so", "[lanes]")
{
    Joint stribeck = stribeck_joint(1e4, 0, 1e-3);
    std::get<Stribeck>(stribeck.friction.law).c4 = 1.5;
    const Joint joints[] = {stribeck, example_joint(20000, 0, 1e-3)};
    PointResult points[2];
    nonlinear_points(joints, {}, points);
    CHECK(points[0].path == DecisionPath::cvode);
    CHECK(points[0].outcome == Outcome::stick_slip);
    CHECK(points[1].path == DecisionPath::lanes);
}

TEST_CASE("a search does not end on the cycle that repels", "[lanes]")
{
    // of a map of the bistable strip: its neighbours' cycles have 69.96 and 68.48 µm, the repelling one has 40.75 µm
    const Joint joint = example_joint(5e3 * std::pow(10, 221 / 399.0), 40 + 12 * 293 / 399.0, 1e-2);
    PointResult row = linear_point(joint);
    nonlinear_points({&joint, 1}, {}, {&row, 1});
    CHECK(row.path == DecisionPath::lanes);
    CHECK(row.region == Region::bistable);
    const auto by_cvode = nonlinear_verdict(joint, {});
    CHECK(row.amplitude == Approx(by_cvode.amplitude).epsilon(1e-5));
    CHECK(row.amplitude == Approx(69.2265e-6).epsilon(1e-5));
}

TEST_CASE("close to the linear boundary the linear theory ends the search for cycles", "[lanes]")
{
    // a turn loses a hundred-thousandth of the amplitude and more; the slip law's cycles begin at the boundary there,
    // and at the last two, whose boundary is subcritical, a larger one coexists up to 1.27 times the critical gain
    const auto row_of = [](const Joint& joint) {
        PointResult row = linear_point(joint);
        nonlinear_points({&joint, 1}, {}, {&row, 1});
        return row;
    };
    for (const double V0 : {1e-4, 1e-3})
        for (const double above : {1e-5, 1e-4, 1e-3, 1e-2}) {
            const double k_cr = linear_point(example_joint(1, 0, V0)).k_cr;
            const auto row = row_of(example_joint(k_cr * (1 + above), 0, V0));
            CAPTURE(V0, above);
            CHECK(row.path == DecisionPath::lanes);
            CHECK(row.outcome == Outcome::stable_sliding);
            CHECK(row.region != Region::bistable);
            CHECK(row.reason == Reason::none);
        }
    for (const double above : {1e-3, 1e-1}) {
        const double k_cr = linear_point(example_joint(1, 47.5, 1e-2)).k_cr;
        CHECK(row_of(example_joint(k_cr * (1 + above), 47.5, 1e-2)).region == Region::bistable);
    }
}

TEST_CASE("lanes leave the ghost of a fold behind", "[lanes]")
{
    // heavy joints without a critical gain: a turn near the ghost loses next to nothing, and secants led back out for
    // ever
    const double gains[][3] = {
        {0.0125893, 39.8107, 23713.7}, {0.0501187, 12.5893, 50118.7}, {0.0794328, 8.91251, 37583.7}};
    for (const auto& [V0, k_v, k_p] : gains) {
        CAPTURE(V0, k_v, k_p);
        const Joint joint = example_joint(k_p, k_v, V0);
        PointResult row = linear_point(joint);
        nonlinear_points({&joint, 1}, {}, {&row, 1});
        CHECK(row.path == DecisionPath::lanes);
        CHECK(row.outcome == Outcome::stable_sliding);
        CHECK(row.region != Region::bistable);
        CHECK(nonlinear_verdict(joint, {}).region == NonlinearRegion::stable);
    }
}

TEST_CASE("lanes close cycles that hardly attract", "[lanes]")
{
    // next to the linear boundary a turn leaves 0.997 of a distance and more
    const double gains[][3] = {{2.51189e-3, 22.3872, 70794.6},
                               {1e-2, 2.81838, 501187},
                               {2.51189e-2, 17.7828, 237137},
                               {1.25893e-2, 25.1189, 237137}};
    for (const auto& [V0, k_v, k_p] : gains) {
        CAPTURE(V0, k_v, k_p);
        const Joint joint = example_joint(k_p, k_v, V0);
        PointResult row = linear_point(joint);
        nonlinear_points({&joint, 1}, {}, {&row, 1});
        CHECK(row.path == DecisionPath::lanes);
        NonlinearOptions exact;
        exact.rtol = 1e-11;
        const auto by_cvode = nonlinear_verdict(joint, exact);
        CHECK(row.outcome == by_cvode.outcome);
        CHECK(row.amplitude == Approx(by_cvode.amplitude).epsilon(1e-5));
        CHECK(row.period == Approx(by_cvode.period).epsilon(1e-6));
    }
}

TEST_CASE("lanes of the ageing law: small inertia makes the boundary subcritical", "[lanes]")
{
    // dimensionless M = 10^-1.5 with β = 1.5: cycles coexist up to 1.00584 k_cr (computed with a continuation program),
    // subcritical below M = 1/(3 + 2 √(β + 3)) = 0.138
    const auto region = [](double M, double above) {
        const double K_cr = 0.5 * (1 + M);
        const Joint joint = with_ageing(dimensionless_joint(K_cr * above, M, 1.5, 0));
        PointResult row = linear_point(joint);
        nonlinear_points({&joint, 1}, {}, {&row, 1});
        CAPTURE(M, above);
        CHECK(row.path == DecisionPath::lanes);
        return row.region;
    };
    const double M = std::pow(10, -1.5);
    CHECK(region(M, 0.999) == Region::unstable);
    CHECK(region(M, 1.0057) == Region::bistable);
    CHECK(region(M, 1.0060) == Region::memory_only);
    CHECK(region(0.2, 1.0005) == Region::memory_only);
}

// more of them, with figures: benchmark_simulation_accuracy
TEST_CASE("lanes against CVODE at rtol 1e-11: random joints", "[lanes][slow]")
{
    check_against_cvode(random_joints(30, 21), false, 0.9);
    check_against_cvode(random_joints(15, 22), true, 0.9);
    check_against_cvode(random_ageing_joints(30, 25), false, 0.9);
    check_against_cvode(random_ageing_joints(15, 26), true, 0.9);
    check_against_cvode(random_stribeck_joints(60, 23), false, 0.7);
    check_against_cvode(random_stribeck_joints(60, 24), true, 0.7);
}

TEST_CASE("lanes against CVODE at rtol 1e-11: disturbances of stated kind and size", "[lanes][slow]")
{
    // two joints beside each other's fold (the bistable strip), so that both ends of a disturbance are met
    std::vector<Joint> strip;
    for (const double k_p : {19600.0, 21000.0, 23500.0, 26000.0}) strip.push_back(example_joint(k_p, 47.5, 1e-2));
    int reached = 0, decayed = 0, by_lanes = 0, asked = 0;
    const auto compare = [&](const std::vector<Joint>& joints, const Disturbance& disturbance) {
        for (const auto& c : compare_with_cvode(joints, true, disturbance)) {
            CAPTURE(static_cast<int>(disturbance.kind), disturbance.size);
            CHECK(c.same_outcome());
            CHECK(c.overshoot < 1e-4);
            CHECK(c.period < 1e-5);
            CHECK(c.amplitude < 1e-3);
            (c.row.outcome == Outcome::stable_sliding ? decayed : reached) += 1;
            by_lanes += c.row.path == DecisionPath::lanes;
            ++asked;
        }
    };
    using enum DisturbanceKind;
    for (const double share : {0.3, 3.0, 30.0}) {
        compare(strip, {position, share * 1e-5});
        compare(strip, {offset, -share * 1e-5});
        compare(strip, {velocity, 0.03 * share * 1e-2});
        compare(strip, {impulse, 0.03 * share * 1e-2});
        compare(strip, {state, 0.05 * share});
        compare(strip, {start, 0.9 / share});
    }
    CHECK(reached > 10);
    CHECK(decayed > 10);
    const auto joints = random_joints(8, 31);
    for (const auto kind : {position, velocity, impulse, offset, state, start})
        compare(joints, {kind, kind == start ? 0.1 : kind == state ? 0.2 : 1e-5});
    CHECK(10 * by_lanes > 8 * asked);
    const auto ageing = random_ageing_joints(8, 33);
    for (const auto kind : {position, velocity, impulse, offset, state, start})
        compare(ageing, {kind, kind == start ? 0.1 : kind == state ? 0.2 : 1e-5});
    const auto stribeck = random_stribeck_joints(12, 32);
    for (const auto kind : {position, velocity, impulse, offset, start}) compare(stribeck, {kind, 1e-4});
}

TEST_CASE("stick-slip of a Stribeck joint with its sticking in closed form", "[lanes]")
{
    // fixed steps of 2 µs by the classical Runge-Kutta method, rest in closed form, written apart from the program
    Joint joint = stribeck_joint(27868.50771, 0, 0.004577163113);
    joint.mechanism.inertia = 2.368116353;
    auto& law = std::get<Stribeck>(joint.friction.law);
    law.c0 = 3.822399009, law.c1 = 7.530392332, law.c2 = 0.1090494649, law.c3 = 0.003558268387;
    const auto by_cvode = nonlinear_verdict(joint, {});  // shooting once went on through V = 0 and found a reversal
    CHECK(by_cvode.outcome == Outcome::stick_slip);
    CHECK(by_cvode.period == Approx(0.0580574710).epsilon(1e-6));
    PointResult row = linear_point(joint);
    nonlinear_points({&joint, 1}, {}, {&row, 1});
    CHECK(row.path == DecisionPath::lanes);
    CHECK(row.outcome == Outcome::stick_slip);
    CHECK(row.period == Approx(0.0580574710).epsilon(1e-8));
    CHECK(row.velocity_max == Approx(0.0093087604).epsilon(1e-8));
    CHECK(row.velocity_min == 0);
}
