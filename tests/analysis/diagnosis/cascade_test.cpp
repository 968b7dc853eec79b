// A cascade has gains under other names: what is known of a sum of gains holds of it, too.
#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/fit/candidate_numbers.h"
#include "analysis/diagnosis/fit/effect.h"
#include "tests/analysis/diagnosis/record_rows.h"
#include "tests/analysis/diagnosis/small_machine.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

/// The nominal joint with its sum of gains as a velocity loop inside a position loop.
Joint as_cascade(Joint joint)
{
    auto& c = joint.control;
    c.structure = Structure::cascade;
    c.velocity_gain = c.k_v, c.position_gain = c.k_p / c.k_v;
    c.k_p = not_set, c.k_v = 0;
    return joint;
}

}  // namespace

TEST_CASE("a measured effort between unlogged ticks is judged under a cascade, too", "[gap]")
{
    // it was not judged at all: masses, friction and gains that were wrong by one factor explained the motion alone
    test::Machine m;
    m.effort_noise = 0.02;
    Record r = test::every_nth_row(test::record_of(m, 1, 3), 2);
    r.effort_command.clear();
    std::vector<Note> notes;
    const Joint sum = test::nominal_joint();
    const double floor = prepare(r, sum, notes).effort_sigma;
    CHECK(floor > 0);
    CHECK(prepare(r, as_cascade(sum), notes).effort_sigma == Approx(floor));
}

TEST_CASE("gains that are off are those that a cascade has", "[gap]")
{
    Joint cascade = as_cascade(test::nominal_joint());
    const double position_gain = cascade.control.position_gain, velocity_gain = cascade.control.velocity_gain;
    const double larger = 1.25;
    for (const char* name : {"gain-k_p", "gain-k_v"}) {
        const auto& form = effect_named(name)->forms[0];
        REQUIRE((!form.applies || form.applies(cascade)));
        form.apply(cascade, &larger);
    }
    CHECK(cascade.control.position_gain == Approx(larger * position_gain));
    CHECK(cascade.control.velocity_gain == Approx(larger * velocity_gain));
}
