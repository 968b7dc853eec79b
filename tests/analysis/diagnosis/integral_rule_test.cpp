// Rules by which controllers integrate.
#include <catch2/catch.hpp>
#include <cmath>
#include "analysis/diagnosis/audit/audit.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/fit/jumps.h"
#include "analysis/diagnosis/search/attribute.h"
#include "tests/analysis/diagnosis/record_rows.h"
#include "tests/analysis/diagnosis/small_machine.h"

using namespace stickslip;
using namespace stickslip::gap;
using stickslip::test::Machine;

TEST_CASE("an integral that does not count the present sample is no wrong gain", "[gap][slow]")
{
    const Record plain = test::record_of({}, 1, 4);
    const double tick = plain.time[1] - plain.time[0];
    constexpr double k_i = 12e3;  // 12 N/m a sample, of 1200 N/m
    const auto error = [&](std::size_t k) { return plain.reference_position[k] - plain.position[k]; };
    // `late`: the part of the present sample that is added after the command; `more`: of k_p
    const auto found = [&](double late, double more, Control& corrected) {
        Record r = plain;
        double sum = 0;
        for (std::size_t k = 0; k < plain.rows(); ++k) {
            r.effort_command[k] += k_i * (sum + (1 - late) * tick * error(k)) + more * 1200 * error(k);
            sum += tick * error(k);
        }
        Joint joint = test::nominal_joint();
        joint.control.k_i = k_i;
        std::vector<Note> notes;
        std::vector<Case> cases{prepare(r, joint, notes)};
        const auto answer = audit(cases);
        corrected = cases[0].joint.control;
        return answer;
    };
    Control corrected;
    for (const double late : {1.0, 0.5}) {
        const auto answer = found(late, 0, corrected);
        INFO(late);
        CHECK(answer.findings.empty());
        REQUIRE(answer.notes.size() == 1);
        CHECK(answer.notes[0].code == Note::Code::sample_of_integral);
        CHECK(answer.notes[0].values[1] == late);
        CHECK(corrected.k_p == Approx(1200 - late * k_i * tick).epsilon(1e-4));
    }
    CHECK(found(0, 0, corrected).findings.empty());
    const auto wrong = found(0, -0.03, corrected);
    REQUIRE(wrong.findings.size() == 1);
    CHECK(wrong.findings[0].effect == "gain-k_p");
}
