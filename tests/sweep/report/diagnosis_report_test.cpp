#include "sweep/report/pages/diagnosis_report.h"
#include "sweep/words/diagnosis_first_screen.h"
#include "sweep/words/diagnosis_text.h"

#include "sweep/files/json/diagnosis_json.h"
#include "sweep/report/figures/ladder_drawing.h"
#include "sweep/report/figures/moved_boundary.h"
#include "sweep/report/figures/where_drawing.h"
#include "sweep/words/cause_text.h"
#include "sweep/words/diagnosis_tables.h"

#include <catch2/catch.hpp>

#include <set>

using namespace stickslip;
using Catch::Matchers::Contains;

namespace {

Joint joint_with(const RateAndState& law)
{
    Joint j;
    j.mechanism.inertia = 1;
    j.control.k_p = 2e4;
    j.control.V0 = 1e-3;
    j.friction.law = law;
    return j;
}

RateAndState slip_law(double L)
{
    RateAndState law;
    law.f0 = 60;
    law.A = 1;
    law.B.size = law.L.size = 1;
    law.B[0] = 1.5;
    law.L[0] = L;
    law.V_star = 1e-3;
    return law;
}

Diagnosis named()
{
    Diagnosis d;
    d.verdict = Verdict::gap;
    d.records = {{"a.csv", "held-out"}, {"b.csv", "held-out"}};
    Cause c;
    c.names = {"frictional-memory"};
    c.probability = 0.9;
    d.effects = {c};
    d.signals = {{"command", 0.1, {0.05, 0.2}, 1, 0.1, "N"}, {"motion", 0.9, {0.8, 0.95}, 2, 0.1, "N"}};
    d.overall = {5, 1.2, 1, 0.98, {0.95, 0.99}};
    d.usual_speed = 1e-2;
    d.notes = {
        {Note::Code::no_effort, "a.csv"}, {Note::Code::no_effort, "b.csv"}, {Note::Code::irregular_rows, "b.csv"}};
    return d;
}

Report page_of(const Diagnosis& d, const Joint& before, const Joint& after)
{
    const auto moved = moved_boundary(before, after, reported_velocity(before, d.usual_speed));
    return diagnosis_report(d, before, after, moved, {}, {});
}

nlohmann::ordered_json json_of(const Diagnosis& d, const Joint& before, const Joint& after)
{
    return diagnosis_json(d, {own_windows(before, d.usual_speed), own_windows(after, d.usual_speed)});
}

nlohmann::ordered_json windows_at(const Joint& joint, double velocity)
{
    return windows_json(own_windows(joint, velocity));
}

Section moved(const Joint& before, const Joint& after, double velocity, const std::string& with)
{
    return moved_section(moved_boundary(before, after, velocity), units_of(before), with);
}

}  // namespace

TEST_CASE("causes that the records cannot distinguish are all named in the first sentence", "[report]")
{
    Diagnosis d = named();
    d.effects[0].names = {"saturation", "constant-load"};
    CHECK_THAT(diagnosis_sentence(d), Contains("The gap comes from saturation with constant load: on"));
    d.ambiguous_with = {{"saturation", "sensor-offset"}};
    CHECK_THAT(diagnosis_sentence(d),
               Contains("The gap comes from one of saturation with constant load, saturation with sensor offset, "
                        "which these records cannot distinguish: on"));
    d = named();
    d.ambiguous_with = {{"frictional-memory"}};  // the same cause
    CHECK_THAT(diagnosis_sentence(d), Contains("The gap comes from frictional memory: on"));
    CHECK_THAT(diagnosis_sentence(d), Contains("cannot distinguish it from frictional memory by another law"));
}

TEST_CASE("the first sentence is as sure as the cause", "[report][gap]")
{
    Diagnosis d = named();
    CHECK_THAT(diagnosis_sentence(d), Contains("The gap comes from frictional memory: on"));
    d.effects[0].probability = 0.7;
    CHECK_THAT(diagnosis_sentence(d), Contains("The gap probably comes from frictional memory (70 %): on"));
    d.effects.push_back(d.effects[0]);
    d.effects[0].probability = 0.49, d.effects[1].probability = 0.03, d.effects[1].names = {"stribeck"};
    CHECK_THAT(diagnosis_sentence(d), Contains("The likeliest cause of the gap is frictional memory (49 %; that it is "
                                               "none of those listed: 48 %): on"));
    const auto page = [&] { return page_of(d, joint_with(slip_law(1e-5)), joint_with(slip_law(2e-5))); };
    CHECK(page().verdict == "Likeliest, not certain (49 %): Friction depends on past motion.");
    CHECK_THAT(page().headlines[2].meaning, Contains("48 % that the cause is not listed"));
    // what two causes that nothing distinguishes have together counts
    d.effects[1].probability = 0.45, d.ambiguous_with = {{"stribeck"}};
    CHECK_THAT(diagnosis_sentence(d),
               Contains("The gap comes from one of frictional memory, Stribeck friction, which"));
}

TEST_CASE("the probabilities of an answer make one, with that of none of its causes", "[report][gap]")
{
    Diagnosis d = named();
    d.effects.push_back(d.effects[0]);
    d.effects[0].probability = 0.49, d.effects[1].probability = 0.03;
    const auto json = json_of(d, joint_with(slip_law(1e-5)), joint_with(slip_law(2e-5)));
    double sum = json.at("none_of_these");
    for (const auto& effect : json.at("effects")) sum += effect.at("probability").get<double>();
    CHECK(sum == Approx(1));
    CHECK(causes_table(d).rows.back()[1] == "0.480");
    d.effects.clear(), d.verdict = Verdict::no_gap;
    CHECK(json_of(d, joint_with(slip_law(1e-5)), joint_with(slip_law(2e-5))).at("none_of_these").is_null());
}

TEST_CASE("the first screen of a diagnosis says where, what, how much and how sure", "[report]")
{
    const auto r = page_of(named(), joint_with(slip_law(1e-5)), joint_with(slip_law(2e-5)));
    REQUIRE(r.headlines.size() == 4);
    const char* questions[] = {"cause:", "how much:", "how sure:", "location:"};
    for (std::size_t i = 0; i < 4; ++i) CHECK(r.headlines[i].meaning.starts_with(questions[i]));
    CHECK(r.headlines[0].value == "frictional memory");
    CHECK(r.headlines[1].value == "− 76 %");
    CHECK(r.headlines[2].value == "90 %");
    CHECK(r.headlines[3].value == "motion");
    CHECK(r.verdict == "Friction depends on past motion.");
    // anchors of a page are its own
    std::set<std::string> ids;
    for (const auto& section : r.sections) {
        CHECK(ids.insert(section.id).second);
        for (const auto& figure : section.figures) CHECK(ids.insert(figure.id).second);
    }
    CHECK(ids.count("moved-boundary") == 1);
    CHECK(r.not_checked == std::vector<std::string>{"2 of 2 records: no effort was measured: inertia, gain and torque "
                                                    "constant can be distinguished by friction and load only.",
                                                    "b.csv: irregular sampling; every row is used at its own time."});
}

TEST_CASE("the share that a cause explains is that of its own rungs", "[report]")
{
    Diagnosis d = named();
    d.ladder.resize(2);
    d.ladder[0].names = {"frictional-memory"}, d.ladder[0].share = 0.6;
    d.ladder[1].names = {"gravity"}, d.ladder[1].share = 0.2;  // not named
    d.corrected_share = 0.15;                                  // by numbers of the document
    d.remainder.share = 0.05;
    const auto shown = [](const Diagnosis& it) {
        return page_of(it, joint_with(slip_law(1e-5)), joint_with(slip_law(2e-5))).headlines[1].value;
    };
    CHECK(shown(d) == "60 %");
    d.effects[0].names = {"frictional-memory", "gravity"};
    CHECK(shown(d) == "80 %");
}

TEST_CASE("the waterfall marks what can be explained, and says nothing of it where that is not known", "[report]")
{
    Diagnosis d = named();
    d.ladder = {{{"frictional-memory"}, 0.81}};
    const auto mark = [&] {
        const Figure figure = ladder_figure(d);
        const auto& drawing = std::get<LineDrawing>(figure.picture);
        const auto found =
            std::ranges::find(drawing.labels, "not explainable left of this line", &LineDrawing::Label::text);
        return found == drawing.labels.end() ? std::optional<LineDrawing::Label>() : *found;
    };
    constexpr double text_width = 190;  // of the words, in the units of the drawing
    for (const double share : {0.02, 0.3, 0.6, 1.0}) {
        d.ceiling.share = share;
        const auto label = mark();
        REQUIRE(label);
        const bool leftwards = label->anchor == LineDrawing::Anchor::right;
        CHECK((leftwards ? label->x - text_width : label->x) > 0);
        CHECK((leftwards ? label->x : label->x + text_width) < 760);
    }
    d.ceiling.share = not_set;  // of a rig
    CHECK_FALSE(mark());
    CHECK_THAT(ladder_figure(d).caption, !Contains("corrected") && !Contains("whiskers"));
}

TEST_CASE("a diagnosis whose cause makes held-out data worse is not written", "[report]")
{
    Diagnosis d = named();
    const Joint j = joint_with(slip_law(1e-5));
    CHECK_NOTHROW(json_of(d, j, j));
    d.overall.after = 5.1;
    CHECK_THROWS_AS(json_of(d, j, j), std::logic_error);
    d.verdict = Verdict::unknown;
    CHECK_NOTHROW(json_of(d, j, j));
}

TEST_CASE("the page shows that the stable gains move with the length of the memory", "[report]")
{
    // k_cr of the quasi-static slip law is (B − A)/L
    const auto section = moved(joint_with(slip_law(1e-5)), joint_with(slip_law(2e-5)), 1e-6, "with frictional-memory");
    CHECK_THAT(section.text, Contains("above 50 kN/m in the nominal joint and above 25 kN/m with"));
    REQUIRE(section.figures.size() == 1);
    CHECK(std::get<LineChart>(section.figures[0].picture).lines.size() == 2);
}

TEST_CASE("the page shows both ends of the window that ticks leave, in the gains of a geared motor", "[report]")
{
    Joint plain = joint_with(slip_law(1e-5));
    plain.control.period = 1e-3;
    const auto sampled = moved(plain, joint_with(slip_law(1e-5)), 1e-3, "without ticks");
    CHECK_THAT(sampled.text, Contains("MN/m in the nominal joint and above"));
    REQUIRE(sampled.figures.size() == 1);
    CHECK(std::get<LineChart>(sampled.figures[0].picture).lines.size() == 3);

    Joint cascade = plain;  // the same gains, as a velocity loop inside a position loop
    cascade.control.structure = Structure::cascade;
    cascade.control.velocity_gain = plain.control.k_v = 40;
    cascade.control.position_gain = 500, plain.control.k_p = 40 * 500;
    cascade.control.k_p = not_set;
    CHECK(moved(cascade, cascade, 1e-3, "as it is").text == moved(plain, plain, 1e-3, "as it is").text);
    CHECK(windows_at(cascade, 1e-3)["stable_k_p"].dump() == windows_at(plain, 1e-3)["stable_k_p"].dump());

    Joint rigid = plain;
    rigid.mechanism.model = Model::two_mass;
    rigid.mechanism.motor_inertia = 0.3, rigid.mechanism.link_inertia = 1;
    rigid.mechanism.transmission = {.stiffness = 1e7, .damping = 100};
    rigid.frictions.motor.law = CoulombViscous{1, 1};
    rigid.frictions.link = plain.friction;
    Joint geared = rigid;  // the same bodies behind a gear of 10, as their motor counts them
    geared.mechanism.motor_inertia /= 100;
    geared.mechanism.transmission.ratio = 10;
    geared.frictions.motor.law = CoulombViscous{0.1, 0.01};
    geared.control.k_p /= 100, geared.control.k_v /= 100;
    const double unit = 100;
    const auto at_joint = windows_at(rigid, 1e-3), at_motor = windows_at(geared, 1e-3);
    REQUIRE(at_joint["stable_k_p"].size() >= 1);
    CHECK(at_motor["stable_k_p"][0][0].get<double>() * unit ==
          Approx(at_joint["stable_k_p"][0][0].get<double>()).epsilon(1e-6));
    CHECK(at_motor["spectral_abscissa"].get<double>() ==
          Approx(at_joint["spectral_abscissa"].get<double>()).epsilon(1e-6));
}

TEST_CASE("a joint for which the linear theory has no verdict is said to have none", "[report]")
{
    Joint broken = joint_with(slip_law(1e-5));
    broken.mechanism.inertia = not_set;
    for (const auto& after : {broken, joint_with(slip_law(not_set))}) {
        const auto section = moved(joint_with(slip_law(1e-5)), after, 1e-3, "with the cause");
        CHECK_THAT(section.text, Contains("no verdict for the joint with the cause"));
        REQUIRE(section.tables[0].rows.size() == 4);
        CHECK(section.tables[0].rows[0][2].starts_with("no verdict: "));
    }
    CHECK(moved(broken, broken, 0, "with the cause").tables.empty());
    CHECK_NOTHROW(page_of(named(), broken, broken));
}

TEST_CASE("every share of a table has its bar", "[report]")
{
    const Table t = shares_table("By stage", named().signals);
    REQUIRE(t.bars.size() == t.rows.size());
    CHECK(t.columns[t.bar_column] == "share of the gap");
    CHECK((t.bars[1].share == 0.9 && t.bars[1].low == 0.8 && t.bars[1].high == 0.95));
    CHECK(causes_table(named()).bars.size() == causes_table(named()).rows.size());
}

TEST_CASE("a cause is said in words, with the numbers as a joint file states them", "[report]")
{
    // Janot, Gautier and Brunot 2019: viscous 166.7 and 240.4 N·s/m in the two directions
    Joint before, after;
    CoulombViscous law;
    law.coulomb = 20, law.viscous = 203.5;
    before.friction.law = after.friction.law = law;
    after.friction.asymmetry.viscous = -36.8, after.friction.asymmetry.coulomb = 2.9;
    Cause c;
    c.names = {"asymmetric-friction"};
    c.parameters = {{"asymmetric-friction.coulomb", 2.9, 5.8, "N"},
                    {"asymmetric-friction.viscous", -36.8, 1.6, "N·s/m"}};
    CHECK(
        cause_text(c, before, after) ==
        "Friction differs between the directions: viscous 166.7 ± 1.6 N·s/m in the positive direction and 240.3 ± 1.6 "
        "N·s/m in the negative one; Coulomb not measurably different (2.9 ± 5.8 N half the difference).");
    c.names = {"gain-k_p"};
    before.control.k_p = 2e4, after.control.k_p = 1e4;
    CHECK(cause_text(c, before, after) ==
          "The position gain in the controller is not the documented one: 10 kN/m instead of 20 kN/m.");
    c.names = {"cogging"}, c.parameters = {{"cogging.sine", 4, 0.1, "N"}};
    auto& wave = after.load.cogging;
    wave.amplitude = 4, wave.periods = 100, wave.second_amplitude = 2, wave.second_phase = 1;
    CHECK_THAT(cause_text(c, before, after),
               Catch::EndsWith(": amplitude 4 N, periods 100 1/m, second amplitude 2 N."));
}

TEST_CASE("the drawing of where says every stage, judged or not, and its table every regime", "[report]")
{
    Diagnosis d = named();
    d.regimes = {{"stuck", 0.2, {0.1, 0.3}, 1, 1, "floors"},
                 {"low speed", 0.7, {0.6, 0.8}, 1, 1, "floors"},
                 {"sliding", 0.1, {0, 0.2}, 1, 1, "floors"},
                 {"reversal", 0.4, {0.3, 0.5}, 1, 1, "floors"}};
    const auto figure = where_figure(d);
    const auto& drawing = std::get<LineDrawing>(figure.picture);
    CHECK(drawing.boxes.size() == 3);
    std::multiset<std::string> words;
    for (const auto& l : drawing.labels) {
        words.insert(l.text);
        CHECK((l.x >= 0 && l.x <= drawing.width && l.y >= 0 && l.y <= drawing.height));
    }
    for (const char* word : {"command", "effort", "motion", "not judged", "10 %", "90 %"})
        CHECK(words.count(word) == 1);
    for (const char* word : {"stuck", "reversal", "40 %"}) CHECK(words.count(word) == 0);  // no share is drawn twice
    const Joint j = joint_with(slip_law(1e-5));
    for (const auto& s : page_of(d, j, j).sections)
        if (s.id == "where") {
            REQUIRE(s.tables.size() == 2);
            CHECK((s.tables[0].bars.empty() && s.tables[1].bars.size() == 4));
        }
    CHECK(figure.finding == "Shares of the gap along the chain: command 10 %, motion 90 %.");
}

TEST_CASE("an experiment that would tell nothing is not proposed as one", "[report]")
{
    Diagnosis d = named();
    d.next_experiment = {TestMotion::falling_sine, {{"stribeck", "frictional-memory"}}, 0.1, {0, 1}, {0, 1}};
    const Joint j = joint_with(slip_law(1e-5));
    const auto said = [&] {
        for (const auto& s : page_of(d, j, j).sections)
            if (s.id == "next") return s;
        return Section{};
    };
    CHECK_THAT(said().text,
               Contains("No motion that was tried would distinguish Stribeck friction from frictional memory"));
    CHECK(said().figures.empty());
    d.next_experiment.distance = 12;
    CHECK_THAT(said().text, Contains("differ by 12.0 noise standard deviations"));
    CHECK(said().figures.size() == 1);
}

TEST_CASE("a page without a gap shows no shares of noise, and a suspicion is said once", "[report]")
{
    const Joint j = joint_with(slip_law(1e-5));
    Diagnosis fine = named();
    fine.verdict = Verdict::no_gap;
    fine.effects.clear();
    fine.reasons = {{Note::Code::within_noise}};
    const auto page = page_of(fine, j, j);
    CHECK(page.alerts.empty());
    CHECK(page.headlines[0].value == "none");
    CHECK(page.headlines.back().value == "none");
    for (const auto& s : page.sections) CHECK(s.id != "where");

    Diagnosis foreign;
    foreign.reasons = {
        {.code = Note::Code::unit_by_travel, .record = "a.csv", .names = {"degrees", "deg", "rad"}, .values = {90}}};
    foreign.notes = {foreign.reasons[0], {.text = "a column was ignored"}};
    const auto refused = page_of(foreign, j, j);
    CHECK_THAT(refused.verdict, Contains("contradict each other"));
    CHECK(refused.alerts.size() == 1);
    CHECK(refused.not_checked == std::vector<std::string>{"A column was ignored."});
    CHECK(refused.subtitle.empty());
}

TEST_CASE("numbers that the records do not pin are said to be so, others stand with their interval", "[report]")
{
    const Joint j = joint_with(slip_law(1e-5));
    Diagnosis d = named();
    REQUIRE_FALSE(d.effects.empty());
    CHECK(values_table(d).rows.empty());
    d.effects[0].values = {{"viscous slope, positive direction", 166.9, {166.1, 167.7}, "N·s/m", true},
                           {"Coulomb level, positive direction", 2.9, {-9, 15}, "N", false}};
    const auto rows = values_table(d).rows;
    REQUIRE(rows.size() == 2);
    CHECK(rows[0][1] == "166.9 (166.1 … 167.7) N·s/m");
    CHECK(rows[1][1] == "not pinned by these records");
    bool on_page = false;
    for (const auto& section : page_of(d, j, j).sections)
        for (const auto& table : section.tables) on_page |= table.rows == rows;
    CHECK(on_page);
}

TEST_CASE("a value stands with the decimals of its interval, in the unit that suits it", "[report]")
{
    SheetValue v{"gravity amplitude", 14.00002, {13.9999, 14.0001}, "N·m"};
    v.pinned = true;
    CHECK(value_text(v) == "14.00002 (13.99990 … 14.00010) N·m");
    v.value = 0.09001, v.interval = {0.08996, 0.09005};
    CHECK(value_text(v) == "90.010 (89.960 … 90.050) mN·m");
    v.interval = {0.09001, 0.09001};
    CHECK(value_text(v) == "90.01 (90.01 … 90.01) mN·m");
}
