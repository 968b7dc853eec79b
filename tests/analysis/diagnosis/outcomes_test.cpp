#include "analysis/diagnosis/outcomes/explain.h"
#include "analysis/diagnosis/outcomes/side.h"
#include "analysis/diagnosis/policy/outcomes_and_rigs.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

Joint sliding(const FrictionLaw& law, double k_p, double k_v, double V0, double m = 1)
{
    Joint joint;
    joint.mechanism.inertia = m;
    joint.control.k_p = k_p, joint.control.k_v = k_v, joint.control.V0 = V0;
    joint.friction.law = law;
    return joint;
}

RateAndState one_state(double A, double B, double L)
{
    RateAndState law;
    law.f0 = 60, law.A = A, law.V_star = 1e-3;
    law.B.push_back(B), law.L.push_back(L);
    return law;
}

/// k_cr = ((B − A − k_v V_0)/L)(1 + m V_0/(L C)), C = k_v + A/V_0: the closed form of (34)-(35) for one state.
double critical_gain(double A, double B, double L, double k_v, double V0, double m)
{
    const double C = k_v + A / V0;
    return B > C * V0 ? (B - A - k_v * V0) / L * (1 + m * V0 / (L * C)) : 0;
}

OutcomeTable table_by(const std::function<bool(double k_p, double k_v, double V0)>& sticks)
{
    OutcomeTable table{"rows.csv", {"control.k_p", "control.k_v", "control.V0"}, {}};
    for (double k_p : {8e3, 2e4, 4e4, 6e4, 1e5, 3e5})
        for (double k_v : {0.0, 60.0})
            for (double V0 : {3e-4, 1e-3, 6e-3})
                table.rows.push_back({{k_p, k_v, V0}, sticks(k_p, k_v, V0), not_set, table.rows.size() + 2});
    return table;
}

OutcomeTable memory_table()
{
    return table_by([](double k_p, double k_v, double V0) { return k_p < critical_gain(1, 1.5, 1e-5, k_v, V0, 1); });
}

/// A law with memory in two forms and one without: quick to fit.
std::span<const RivalLaw> some_rivals()
{
    static const auto some = [] {
        std::vector<RivalLaw> chosen;
        for (const auto& r : rival_laws())
            if (r.law == "rate-and-state" || r.law == "ageing" || r.law == "kinetic-static") chosen.push_back(r);
        return chosen;
    }();
    return some;
}

OutcomeAnswer answer_of(const Joint& nominal, const OutcomeTable& table)
{
    return explain(nominal, table, test::in_order, {}, some_rivals());
}

}  // namespace

TEST_CASE("a mass that breaks loose against kinetic friction swings as the closed form says", "[gap][outcomes]")
{
    // m v̇ = ΔF + ∫k_p (V_0 − v): v = V_0 − V_0 cos ωt + ΔF/(mω) sin ωt, least V_0 − √(V_0² + (ΔF/mω)²)
    for (double V0 : {1e-4, 1e-3, 1e-2})
        for (double drop : {0.0, 0.01, 0.5, 20.0}) {
            const double k = 2e4, m = 2, omega = std::sqrt(k / m);
            const auto joint = sliding(KineticStatic{50, 50 + drop}, k, 0, V0, m);
            const double least = V0 - std::hypot(V0, drop / (m * omega));
            INFO("V0 " << V0 << " drop " << drop);
            CHECK(least_velocity_after_release(joint) ==
                  Approx(least).margin(2e-3 * std::hypot(V0, drop / (m * omega))));
        }
    // damped: v = V_0 + e^{−ζωt}(a cos + b sin), sampled densely
    const double k = 2e4, k_v = 80, V0 = 1e-3, drop = 0.2, omega = std::sqrt(k), zeta = k_v / (2 * omega);
    const double damped = omega * std::sqrt(1 - zeta * zeta);
    double least = 1;
    for (double t = 0.6 / damped; t < 6.2 / damped; t += 1e-5 / damped) {
        const double a = -V0, b = (drop - zeta * omega * V0) / damped;
        least =
            std::min(least, V0 + std::exp(-zeta * omega * t) * (a * std::cos(damped * t) + b * std::sin(damped * t)));
    }
    CHECK(least_velocity_after_release(sliding(KineticStatic{50, 50 + drop}, k, k_v, V0)) ==
          Approx(least).margin(3e-6));
}

TEST_CASE("the distance to stick-slip is the relative change of settings that reaches the boundary", "[gap][outcomes]")
{
    // at low velocity k_cr = (B − A)/L whatever V_0: only k_p counts
    const auto law = one_state(1, 1.5, 1e-5);
    for (double change : {-0.05, -0.01, 0.01, 0.05}) {
        const double k_cr = critical_gain(1, 1.5, 1e-5, 0, 1e-5, 1);
        INFO(change);
        CHECK(distance_to_stick_slip(sliding(law, k_cr * (1 + change), 0, 1e-5)) == Approx(-change).epsilon(0.1));
    }
    CHECK(distance_to_stick_slip(sliding(KineticStatic{50, 51}, 2e4, 50, 1e-4)) > 0);
    CHECK(distance_to_stick_slip(sliding(CoulombViscous{50, 5}, 2e4, 0, 1e-4)) < 0);
}

TEST_CASE("rows of a boundary by the closed form are explained by memory, and the law of its state stays open",
          "[gap][outcomes][slow]")
{
    const auto nominal = sliding(CoulombViscous{60, 5}, 2e4, 0, 1e-3);
    const auto answer = answer_of(nominal, memory_table());
    const auto& d = answer.diagnosis;
    for (const auto& f : answer.laws)
        UNSCOPED_INFO(std::string(f.rival->law) << " " << f.total() << " wrong " << f.misjudged);
    CHECK(d.verdict == Verdict::gap);
    REQUIRE(!d.effects.empty());
    CHECK(d.effects[0].names == std::vector<std::string>{"frictional-memory"});
    CHECK(d.ambiguous_with == std::vector<std::vector<std::string>>{{"frictional-memory"}});
    CHECK(answer.laws[0].misjudged <= 3);
    CHECK(answer.nominal.misjudged >= 15);
    CHECK(d.effects[0].signature);
    // what the rows determine: (B − A)/L = 5e4 N/m
    const auto& v = answer.laws[0].values;
    CHECK((v[1] - v[0]) / v[2] == Approx(5e4).epsilon(0.25));
}

TEST_CASE("a joint that already explains the rows has no gap", "[gap][outcomes][slow]")
{
    auto table = memory_table();
    for (std::size_t i = 0; i < table.rows.size(); ++i) table.rows.erase(table.rows.begin() + static_cast<long>(i));
    const auto answer = answer_of(sliding(one_state(1, 1.5, 1e-5), 2e4, 0, 1e-3), table);
    CHECK(answer.diagnosis.verdict == Verdict::no_gap);
    CHECK(answer.nominal.misjudged == 0);
}

namespace {

constexpr double drop = 0.25;  // N, another one than any default

/// Kinetic/static friction started from rest sticks again where √(V_0² + (ΔF/mω)²) > V_0 outweighs damping: the exact
/// damped swing of 1 kg.
bool sticks_again(double k_p, double k_v, double V0)
{
    const double omega = std::sqrt(k_p), zeta = k_v / (2 * omega);
    if (zeta >= 1) return false;
    const double damped = omega * std::sqrt(1 - zeta * zeta), b = (drop - zeta * omega * V0) / damped;
    double least = 1;
    for (double t = 0.5; t < 6.3; t += 1e-3)
        least = std::min(least, V0 + std::exp(-zeta * omega * t / damped) * (-V0 * std::cos(t) + b * std::sin(t)));
    return least < 0;
}

}  // namespace

TEST_CASE("where nothing damps the amplitudes of kinetic and static friction are those of the closed form",
          "[gap][outcomes][slow]")
{
    // it breaks loose at ΔF/k before the middle and swings with √((ΔF/k)² + (V_0/ω)²) about it until it sticks again
    OutcomeTable table{"rows.csv", {"control.k_p", "control.k_v", "control.V0"}, {}};
    for (double k_p : {8e3, 4e4, 2e5})
        for (double k_v : {0.0, 40.0, 100.0})
            for (double V0 : {3e-4, 1e-3, 3e-3, 1e-2}) {
                const bool sticks = k_v == 0 || sticks_again(k_p, k_v, V0);
                const double amplitude = k_v == 0 ? std::hypot(drop / k_p, V0 / std::sqrt(k_p)) : not_set;
                table.rows.push_back({{k_p, k_v, V0}, sticks, amplitude, table.rows.size() + 2});
            }
    const auto answer = answer_of(sliding(CoulombViscous{60, 5}, 2e4, 0, 1e-3), table);
    for (const auto& f : answer.laws)
        UNSCOPED_INFO(std::string(f.rival->law) << " " << f.total() << " wrong " << f.misjudged);
    CHECK(answer.laws[0].rival->law == "kinetic-static");
    Outcomes exact = answer.outcomes;
    LawFit fit = judge_nominal_law(exact, sliding(KineticStatic{60, 60 + drop}, 2e4, 0, 1e-3));
    for (auto& joint : exact.joints) joint.friction.law = fit.law;
    confirm_by_motion(exact, fit);
    for (std::size_t i = 0; i < exact.size(); ++i)
        if (is_set(table.rows[i].amplitude)) CHECK(fit.amplitude[i] == Approx(table.rows[i].amplitude).epsilon(2e-3));
}

TEST_CASE("a boundary that friction without memory makes is not called memory", "[gap][outcomes][slow]")
{
    OutcomeTable table{"rows.csv", {"control.k_p", "control.k_v", "control.V0"}, {}};
    for (double k_p : {8e3, 4e4, 2e5})
        for (double k_v : {10.0, 40.0, 100.0})
            for (double V0 : {3e-4, 1e-3, 3e-3, 1e-2})
                table.rows.push_back({{k_p, k_v, V0}, sticks_again(k_p, k_v, V0), not_set, table.rows.size() + 2});
    const auto answer = answer_of(sliding(CoulombViscous{60, 5}, 2e4, 0, 1e-3), table);
    for (const auto& f : answer.laws)
        UNSCOPED_INFO(std::string(f.rival->law) << " " << f.total() << " wrong " << f.misjudged);
    CHECK(answer.diagnosis.verdict == Verdict::gap);
    CHECK(answer.laws[0].rival->law == "kinetic-static");
    CHECK(answer.laws[0].values[0] == Approx(drop).epsilon(0.2));
    CHECK(answer.diagnosis.ambiguous_with.empty());
}

TEST_CASE("rows that contradict each other are said to, with their lines", "[gap][outcomes][slow]")
{
    auto table = memory_table();
    const auto rows = table.rows.size();
    for (std::size_t i = 0; i < rows; i += 2) {
        table.rows.push_back(table.rows[i]);
        table.rows.back().stick_slip = !table.rows[i].stick_slip;
        table.rows.back().line = 100 + i;
    }
    const auto answer = answer_of(sliding(CoulombViscous{60, 5}, 2e4, 0, 1e-3), table);
    CHECK(answer.diagnosis.verdict == Verdict::insufficient_data);
    CHECK(answer.contradictions == 18);
    const Note& why = answer.diagnosis.reasons.back();
    CHECK(why.code == Note::Code::rows_contradict);
    CHECK(why.values == std::vector<double>{18, static_cast<double>(table.rows.size())});
    CHECK(answer.diagnosis.notes.at(1).code == Note::Code::same_settings);
    CHECK(answer.diagnosis.notes.at(1).values == std::vector<double>{2, 100});
}

TEST_CASE("rows that go by no law leave every law improbable", "[gap][outcomes][slow]")
{
    // where a stiffer loop sticks again and again: no friction law does that
    const auto table = table_by([](double k_p, double, double) { return k_p == 8e3 || k_p == 4e4 || k_p == 1e5; });
    const auto d = answer_of(sliding(CoulombViscous{60, 5}, 2e4, 0, 1e-3), table).diagnosis;
    CHECK(d.verdict == Verdict::unknown);
    CHECK(d.ambiguous_with.empty());
    CHECK(d.effects.at(0).probability == Approx(0.1));
}

TEST_CASE("rows that cannot tell are not answered with a law", "[gap][outcomes]")
{
    const auto nominal = sliding(CoulombViscous{60, 5}, 2e4, 0, 1e-3);
    auto few = memory_table();
    few.rows.resize(6);
    CHECK(answer_of(nominal, few).diagnosis.verdict == Verdict::insufficient_data);
    auto one_sided = table_by([](double, double, double) { return true; });
    const auto sided = answer_of(nominal, one_sided).diagnosis;
    CHECK(sided.verdict == Verdict::insufficient_data);
    CHECK(sided.reasons.at(0).code == Note::Code::too_few_outcomes);
    Joint two = nominal;
    two.mechanism.model = Model::two_mass;
    CHECK_THROWS_WITH(answer_of(two, memory_table()), "rows.csv: table-of-many-bodies");
    auto wrong = memory_table();
    wrong.rows[4].settings[2] = 0;
    CHECK_THROWS_WITH(answer_of(nominal, wrong), "rows.csv:6:1: no-velocity");
}

TEST_CASE("guessing the middle amplitude costs as much as the amplitudes differ", "[gap][outcomes]")
{
    Outcomes o;
    o.table = table_by([](double, double, double) { return true; });
    o.joints.resize(o.table.rows.size());
    for (auto& row : o.table.rows) row.amplitude = 1e-4;
    CHECK(guessed_amplitudes(o) == Approx(0).margin(1e-12));
    // two sizes, far apart: every row that judges is wrong by as much as a row can be
    for (std::size_t i = 0; i < o.size(); i += 4) o.table.rows[i].amplitude = o.table.rows[i + 1].amplitude = 1;
    CHECK(guessed_amplitudes(o) == Approx(-policy::worst_amplitude * (36 - 4)));
    for (auto& row : o.table.rows) row.amplitude = not_set;
    CHECK(guessed_amplitudes(o) == 0);
}
