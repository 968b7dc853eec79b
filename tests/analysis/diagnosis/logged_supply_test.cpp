// A supply that is logged beside a motor: what its voltage says of the source.
#include "analysis/diagnosis/audit/audit.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "tests/analysis/diagnosis/small_machine.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

constexpr double supply = 24, k_t = 2;  // V, N/A

/// What the audit says of sources without current at these voltages and with this resistance, read to 10 mV.
Audit audited(const std::vector<double>& open_voltages, double resistance, std::vector<Case>& cases)
{
    Joint joint = test::nominal_joint();
    auto& a = joint.actuator;
    a.kind = ActuatorKind::dc_motor;
    a.k_t = a.k_e = k_t, a.resistance = 1, a.supply_voltage = supply;
    cases.clear();
    for (std::size_t i = 0; i < open_voltages.size(); ++i) {
        test::Machine machine;
        machine.effort_noise = 1e-3;
        Record record = test::record_of(machine, static_cast<unsigned>(i + 1), 4);
        for (const double effort : record.effort_measured) {
            const double voltage = open_voltages[i] - resistance * std::abs(effort / k_t);
            record.supply_voltage.push_back(std::round(100 * voltage) / 100);
        }
        std::vector<Note> notes;
        cases.push_back(prepare(record, joint, notes));
    }
    return audit(cases);
}

const AuditFinding* sag(const Audit& audit)
{
    const auto found = std::ranges::find(audit.findings, "supply-sag", &AuditFinding::effect);
    return found == audit.findings.end() ? nullptr : &*found;
}

}  // namespace

TEST_CASE("a logged supply that falls with the current has a resistance, whatever its voltage without one", "[gap]")
{
    for (const auto& voltages : {std::vector<double>{24}, std::vector<double>{23.2, 24.5}}) {
        std::vector<Case> cases;
        const auto found = audited(voltages, 0.4, cases);
        REQUIRE(sag(found));
        CHECK(sag(found)->value == Approx(0.4).epsilon(0.02));
        for (std::size_t i = 0; i < voltages.size(); ++i) {
            CHECK(cases[i].joint.actuator.supply_resistance == sag(found)->value);
            CHECK(cases[i].ticks.supply[0] == Approx(voltages[i]).margin(0.02));
        }
    }
}

TEST_CASE("a logged supply that is lower than the documented one all the time has no resistance", "[gap]")
{
    std::vector<Case> cases;
    CHECK_FALSE(sag(audited({23.5}, 0, cases)));
    CHECK(cases[0].ticks.supply[0] == Approx(23.5));
}
