#include "sweep/words/diagnosis_tables.h"
#include "sweep/words/effect_words.h"

#include <catch2/catch.hpp>

using namespace stickslip;

TEST_CASE("an effect is called by words, and a path of a joint file by itself", "[words]")
{
    CHECK(effect_words("frictional-memory") == "frictional memory");
    CHECK(effect_words("gain-k_p") == "position gain");
    CHECK(effect_words("load-dependent-friction") == "load-dependent friction");
    CHECK(effect_words("control.velocity_estimate.tau") == "control.velocity_estimate.tau");
    CHECK(together({"stribeck", "dead-zone"}) == "Stribeck friction with dead zone");
}

TEST_CASE("a row of the gap has the unit that suits what it was before", "[words]")
{
    Diagnosis d;
    d.gap = {{"position", "m", 1.785e-4, 1.035e-5, 1.031e-5, 1}, {"effort_measured", "N", 9.413, 3.773, 3.756, 1}};
    d.overall.before = 10.22, d.overall.after = 1.004, d.overall.floor = 1;
    const Table t = gap_table(d);
    CHECK(t.rows[0] == std::vector<std::string>{"position", "178.5 µm", "10.35 µm", "10.31 µm", "100 %"});
    CHECK(t.rows[1][0] == "measured effort");
    CHECK(t.rows[1][1] == "9.413 N");
}

TEST_CASE("shares in multiples of the noise need no column of ones", "[words]")
{
    const Table t = shares_table("By regime", {{"stuck", 0.2, {0.1, 0.3}, 2.166, 1, "floors"}});
    CHECK(t.columns.back() == "RMS, × the prediction floor");
    CHECK(t.rows[0].back() == "2.17");
    const Table stages = shares_table("By stage", {{"effort", 0.2, {0.1, 0.3}, 0.8216, 0.825, "N"}});
    CHECK(stages.rows[0].back() == "825 mN");
}

TEST_CASE("how records are held out is no gap in what was checked", "[words]")
{
    Diagnosis d;
    d.notes = {{Note::Code::held_out_in_turn}, {Note::Code::no_effort}};
    CHECK(gathered_notes(d).size() == 1);
    CHECK(method_text(d) == "Every record is held out in turn and predicted from a fit to the others.");
}
