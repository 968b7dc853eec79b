// Frictional memory that no encoder of the records resolves.
#include "analysis/diagnosis/verdict/unresolved_memory.h"
#include "analysis/results/contradictions.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

Diagnosis named(std::vector<std::string> names, double L)
{
    Diagnosis d;
    d.verdict = Verdict::gap;
    Cause first, second;
    first.names = std::move(names), first.probability = 0.94, first.form = "slip", first.misfit = 1.2;
    FittedParameter slip;
    slip.name = "frictional-memory.L", slip.value = L;
    first.parameters = {slip};
    second.names = {"stribeck"}, second.probability = 0.01;
    d.effects = {first, second};
    LadderRung rung;
    rung.names = {"frictional-memory"}, rung.probability = 0.97;
    d.ladder = {rung};
    doubt_unresolved_memory(std::vector<Case>{[] {
                                Case c;
                                c.joint.sensor.encoder_quantum = 1e-5, c.joint.sensor.position_noise = 2e-6;
                                return c;
                            }()},
                            Scales{}, d);
    CHECK(contradictions_in(d).empty());
    return d;
}

}  // namespace

TEST_CASE("a memory within the encoder's steps may as well be a curve of friction over velocity", "[gap]")
{
    using Names = std::vector<std::string>;
    const auto within = named({"frictional-memory"}, 1.2e-5);
    CHECK(within.effects[0].probability == Approx(0.47));
    REQUIRE(within.effects.size() == 2);
    CHECK(within.effects[1].names == Names{"stribeck"});
    CHECK(within.effects[1].probability == Approx(0.47));
    CHECK(within.effects[1].misfit == 1.2);
    CHECK(within.ambiguous_with == std::vector<Names>{{"stribeck"}});
    CHECK(within.ladder[0].ambiguous_with == std::vector<Names>{{"stribeck"}});
    CHECK(within.ladder[0].probability == Approx(0.485));

    for (const double slip : {2e-4, 2e-3}) {
        const auto resolved = named({"frictional-memory"}, slip);
        CHECK(resolved.effects[0].probability == 0.94);
        CHECK(resolved.ambiguous_with.empty());
    }

    // beside a curve that is named already the memory may be none
    const auto beside = named({"stribeck", "frictional-memory", "gravity"}, 1.2e-5);
    CHECK(beside.ambiguous_with == std::vector<Names>{{"stribeck", "gravity"}});
    CHECK(beside.ladder[0].ambiguous_with.empty());
}
