#include "analysis/diagnosis/verdict/sheet_values.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "tests/analysis/diagnosis/small_machine.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

/// Asymmetric friction that was fitted as half differences of 0.3 N and −0.4 N·s/m, with these variances.
std::vector<SheetValue> of_half_differences(double of_coulomb, double of_viscous, double shared)
{
    Prepared p;
    std::vector<Note> notes;
    p.cases.push_back(prepare(test::record_of({}, 1, 2), test::nominal_joint(), notes));
    p.documented.push_back(p.cases[0].joint);
    p.scales = Scales{};
    Attribution a;
    const Effect* e = effect_named("asymmetric-friction");
    a.candidate = {{e}, {&e->forms[0]}, 1};
    a.x.fill(to_fit(a.candidate, {0.3, -0.4}));
    Quality q;
    q.covariance = Eigen::MatrixXd(2, 2);
    q.covariance << of_coulomb, shared, shared, of_viscous;
    return sheet_values(p, a, q, 0);
}

}  // namespace

TEST_CASE("a half difference is told as the numbers of both directions", "[gap]")
{
    // documented: 2 N and 1.5 N·s/m; in scales of one
    const auto v = of_half_differences(0.01, 0.04, 0);
    REQUIRE(v.size() == 4);
    CHECK(v[0].key == "Coulomb level, positive direction");
    CHECK(v[0].value == Approx(2.3));
    CHECK(v[1].value == Approx(1.7));
    CHECK(v[2].value == Approx(1.1));
    CHECK(v[3].value == Approx(1.9));
    CHECK(v[0].unit == "N");
    CHECK(v[2].unit == "N·s/m");
    // one standard error of 0.1 N: 1.96 times that on either side
    CHECK(v[0].interval.low == Approx(2.3 - 0.196));
    CHECK(v[1].interval.high == Approx(1.7 + 0.196));
    CHECK(v[2].interval.high == Approx(1.1 + 0.392));
    CHECK(v[0].pinned);
}

TEST_CASE("a number whose interval is as wide as the number is large is not pinned by the records", "[gap]")
{
    const auto v = of_half_differences(4, 0.01, 0);
    CHECK_FALSE(v[0].pinned);  // ± 3.9 N around 2.3 N
    CHECK_FALSE(v[1].pinned);
    CHECK(v[2].pinned);
}

TEST_CASE("errors of a number that hang together with those of a correction are carried through", "[gap]")
{
    Prepared p;
    std::vector<Note> notes;
    p.cases.push_back(prepare(test::record_of({}, 1, 2), test::nominal_joint(), notes));
    p.documented.push_back(p.cases[0].joint);
    Attribution a;
    const Effect *level = effect_named("coulomb-level"), *uneven = effect_named("asymmetric-friction");
    a.candidate = {{level, uneven}, {&level->forms[0], &uneven->forms[0]}, 1};
    a.x.fill(to_fit(a.candidate, {0.1, 0.3, 0}));
    Quality q;
    q.covariance = Eigen::MatrixXd::Zero(3, 3);
    q.covariance(0, 0) = q.covariance(1, 1) = 1;
    q.covariance(0, 1) = q.covariance(1, 0) = -1;  // only their sum is known
    const auto v = sheet_values(p, a, q, 1);
    REQUIRE(v.size() == 4);
    CHECK(v[0].value == Approx(2 + 0.1 + 0.3));
    CHECK(v[0].interval.high - v[0].interval.low == Approx(0).margin(1e-6));
    CHECK(v[1].interval.high - v[1].value == Approx(1.96 * 2));
}

TEST_CASE("of two masses the sheet tells the inertia that was changed", "[gap]")
{
    Prepared p;
    std::vector<Note> notes;
    p.cases.push_back(prepare(test::record_of({}, 1, 2), test::nominal_joint(), notes));
    auto& m = p.cases[0].joint.mechanism;
    m.model = Model::two_mass;
    m.motor_inertia = 0.5, m.link_inertia = 3, m.transmission.stiffness = 1e4;
    p.documented.push_back(p.cases[0].joint);
    const Effect* inertia = effect_named("inertia");
    for (const auto& form : inertia->forms) {
        if (!form.applies(p.documented[0])) continue;
        CAPTURE(form.name);
        Attribution a;
        a.candidate = {{inertia}, {&form}, 1};
        a.x.fill(to_fit(a.candidate, {1.5}));
        const auto v = sheet_values(p, a, {}, 0);
        REQUIRE(v.size() == 1);
        CHECK(v[0].value == Approx(1.5 * (form.name == "link" ? 3 : 0.5)));
        CHECK(v[0].key == std::string(form.name) + " inertia");
    }
}

TEST_CASE("the sheet has a number for every cause, whatever its form", "[gap]")
{
    for (const auto& effect : effects())
        for (const auto& form : effect.forms) {
            INFO(effect.name << " " << form.name);
            CHECK(has_sheet_value(effect, form));
        }
}

TEST_CASE("the sheet tells sizes in the units of a data sheet", "[gap]")
{
    const auto told = [](const char* name, std::size_t form, const std::vector<double>& numbers) {
        Prepared p;
        std::vector<Note> notes;
        p.cases.push_back(prepare(test::record_of({}, 1, 2), test::nominal_joint(), notes));
        p.documented.push_back(p.cases[0].joint);
        const Effect* e = effect_named(name);
        Attribution a;
        a.candidate = {{e}, {&e->forms[form]}, 1};
        a.x.fill(to_fit(a.candidate, numbers));
        Quality q;
        q.covariance = 1e-6 * Eigen::MatrixXd::Identity(a.x[0].size(), a.x[0].size());
        return std::pair{sheet_values(p, a, q, 0), p.documented[0]};
    };
    const auto [late, documented] = told("delay", 0, {4});
    REQUIRE(late.size() == 1);
    CHECK(late[0].key == "dead time of the command");
    CHECK(late[0].value == Approx(documented.control.delay + 4e-3));
    CHECK(late[0].unit == "s");
    const auto gain = told("gain-k_p", 0, {1.5}).first;
    REQUIRE(gain.size() == 1);
    CHECK(gain[0].value == Approx(1.5 * documented.control.k_p));
    CHECK(gain[0].unit == "N/m");
    const auto loose = told("backlash", 0, {0.02, 0.4, 500, 0.3, 0.2}).first;
    REQUIRE(loose.size() == 1);
    CHECK(loose[0].value == Approx(0.02));
    CHECK(loose[0].unit == "m");
    const auto rubbing = told("load-dependent-friction", 0, {0.14}).first;
    REQUIRE(rubbing.size() == 1);
    CHECK(rubbing[0].value == Approx(0.14));
    CHECK(rubbing[0].unit.empty());
    const auto coarse = told("quantisation", 0, {1e-3}).first;
    REQUIRE(coarse.size() == 1);
    CHECK(coarse[0].pinned);  // the grid on which readings lie is read off
    CHECK(coarse[0].interval.low == coarse[0].interval.high);
}

TEST_CASE("a motor's gain is a factor, a drive's gain an effort per unit of its signal", "[gap]")
{
    Prepared p;
    std::vector<Note> notes;
    p.cases.push_back(prepare(test::record_of({}, 1, 2), test::nominal_joint(), notes));
    const Effect* gain = effect_named("effort-gain");
    Attribution a;
    a.candidate = {{gain}, {&gain->forms[0]}, 1};
    a.x.fill(to_fit(a.candidate, {1.2}));
    p.documented.push_back(p.cases[0].joint);
    const auto drive = sheet_values(p, a, {}, 0);
    REQUIRE(drive.size() == 1);
    CHECK(drive[0].value == Approx(1.2 * p.documented[0].actuator.effort_gain));
    CHECK(drive[0].unit == "N");
    auto& motor = p.cases[0].joint.actuator;
    motor.kind = ActuatorKind::dc_motor, motor.k_t = motor.k_e = 0.05, motor.resistance = 1;
    p.documented[0] = p.cases[0].joint;
    const auto factor = sheet_values(p, a, {}, 0);
    REQUIRE(factor.size() == 1);
    CHECK(factor[0].value == Approx(1.2));
    CHECK(factor[0].unit.empty());
}

TEST_CASE("a number that differs between records is known as well as they agree", "[gap]")
{
    Prepared p;
    std::vector<Note> notes;
    for (const double coulomb : {2.0, 2.2}) {  // N
        Joint joint = test::nominal_joint();
        std::get<CoulombViscous>(joint.friction.law).coulomb = coulomb;
        p.cases.push_back(prepare(test::record_of({}, 1, 2), joint, notes));
        p.cases.back().number = p.cases.size() - 1;
        p.documented.push_back(joint);
    }
    p.scales = Scales{};
    Attribution a;
    const Effect* e = effect_named("coulomb-level");
    a.candidate = {{e}, {&e->forms[0]}, 2};
    a.x.fill(to_fit(a.candidate, {0.3}));
    Quality q;
    q.covariance = Eigen::MatrixXd::Constant(1, 1, 1e-8);
    const auto v = sheet_values(p, a, q, 0);
    REQUIRE(!v.empty());
    CHECK(v[0].value == Approx(2.4));
    // 2.3 and 2.5 N: the mean has a standard error of 0.1 N
    CHECK(v[0].interval.low == Approx(2.4 - 0.196).epsilon(1e-3));
    CHECK(v[0].interval.high == Approx(2.4 + 0.196).epsilon(1e-3));
}
