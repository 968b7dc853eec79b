#include "analysis/diagnosis/diagnose.h"
#include "analysis/diagnosis/audit/audit.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/policy/ladder_verdict.h"
#include "analysis/diagnosis/verdict/locate_stages.h"
#include "tests/analysis/diagnosis/answers.h"
#include "tests/analysis/diagnosis/small_machine.h"
#include "tests/in_order.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

using namespace stickslip;
using namespace stickslip::gap;
using stickslip::test::Machine;
using stickslip::test::nominal_joint;
using stickslip::test::record_of;

namespace {

std::vector<Record> records_of(const Machine& m)
{
    return {record_of(m, 1), record_of(m, 2)};
}

}  // namespace

TEST_CASE("the gap is located in time, temperature and frequency", "[gap]")
{
    Record r = test::record_of({}, 1, 12);
    for (std::size_t k = 0; k < r.rows(); ++k) {
        r.temperature.push_back(20 + 15 * r.time[k] / 12);
        // a wobble of the reading late in the record, in the middle of a band
        if (r.time[k] > 9) r.position[k] += 2e-4 * std::sin(2 * M_PI * 3 * r.time[k]);
    }
    std::vector<Note> notes;
    const auto regimes = locate_regimes({prepare(r, test::nominal_joint(), notes)});
    const auto share = [&](const std::string& name) {
        const auto at = std::find_if(regimes.begin(), regimes.end(), [&](const Share& s) { return s.name == name; });
        REQUIRE(at != regimes.end());
        return at->share;
    };
    CHECK(share("late") > 0.95);
    CHECK(share("early") < 0.02);
    CHECK(share("warm") > 0.95);
    CHECK(share("cold") < 0.02);
    CHECK(share("1 to 5 Hz") > share("below 1 Hz"));
    CHECK(share("1 to 5 Hz") > share("above 5 Hz"));
    CHECK(share("below 1 Hz") + share("1 to 5 Hz") + share("above 5 Hz") == Approx(1));
    CHECK(share("light load") + share("heavy load") < 1.01);
    r.temperature.clear();
    for (const auto& s : locate_regimes({prepare(r, test::nominal_joint(), notes)})) CHECK(s.name != "warm");
}

TEST_CASE(
    "the catalogue holds its pinned names, each with bounds that hold its seeds and an edit that changes the joint",
    "[gap]")
{
    const std::set<std::string_view> pinned{"coulomb-level",
                                            "viscous",
                                            "stribeck",
                                            "asymmetric-friction",
                                            "load-dependent-friction",
                                            "presliding",
                                            "frictional-memory",
                                            "position-dependent-friction",
                                            "friction-drift",
                                            "inertia",
                                            "constant-load",
                                            "gravity",
                                            "cogging",
                                            "backlash",
                                            "compliance",
                                            "effort-gain",
                                            "saturation",
                                            "supply-sag",
                                            "actuator-lag",
                                            "delay",
                                            "velocity-filter",
                                            "gain-k_p",
                                            "gain-k_v",
                                            "gain-k_i",
                                            "feed-forward",
                                            "dead-zone",
                                            "quantisation",
                                            "sensor-offset",
                                            "periodic-disturbance"};
    std::set<std::string_view> found;
    for (const auto& e : effects()) {
        found.insert(e.name);
        INFO(e.name);
        CHECK(!e.source.empty());
        CHECK(!e.forms.empty());
        for (const auto& name : e.confusable) CHECK(effect_named(name) != nullptr);
        for (const auto& f : e.forms)
            for (const auto& seed : f.seeds) {
                REQUIRE(seed.size() == f.parameters.size());
                for (std::size_t i = 0; i < seed.size(); ++i)
                    if (f.parameters[i].grid == FrequencyGrid::none)
                        CHECK((seed[i] >= f.parameters[i].low && seed[i] <= f.parameters[i].high));
            }
    }
    CHECK(found == pinned);
}

TEST_CASE("the audit reads a wrong gain and a wrong filter off the command, to a thousandth", "[gap][slow]")
{
    Machine m;
    m.k_p *= 1.07;
    m.tau = 0.0051;
    std::vector<Note> notes;
    std::vector<Case> cases{prepare(record_of(m, 1), nominal_joint(), notes),
                            prepare(record_of(m, 2), nominal_joint(), notes)};
    const Audit found = audit(cases);
    CHECK(found.command_explained);
    REQUIRE(found.findings.size() == 2);
    CHECK(found.findings[0].effect == "velocity-filter");
    CHECK(found.findings[0].value == Approx(0.0051).epsilon(1e-3));
    CHECK(found.findings[1].effect == "gain-k_p");
    CHECK(found.findings[1].value == Approx(1.07).epsilon(1e-3));
}

TEST_CASE("a machine that is its document has no gap", "[gap]")
{
    const auto result = test::answer(nominal_joint(), records_of({}), test::in_order);
    CHECK(result.diagnosis.verdict == Verdict::no_gap);
    CHECK(result.diagnosis.effects.empty());
    CHECK(std::isnan(result.diagnosis.ceiling.share));  // there is nothing to explain
}

TEST_CASE("what is explainable beside a wrong gain is measured, and the gain is as sure everywhere", "[gap][ladder]")
{
    Machine m;
    m.k_p *= 1.07;
    DiagnosisOptions options;
    options.ensemble = 4;
    const auto d = test::answer(nominal_joint(), records_of(m), test::in_order, options).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    REQUIRE(d.ladder.size() == 1);
    CHECK(d.effects[0].names == std::vector<std::string>{"gain-k_p"});
    CHECK(d.ladder[0].probability == Approx(1 - policy::doubt_of_finding));
    CHECK(d.effects[0].probability == d.ladder[0].probability);
    CHECK(d.ceiling.share >= d.ladder[0].share);
    CHECK(d.ceiling.share < 1);
    CHECK(d.ceiling.share != d.ladder[0].share);  // the noise that is left is no copy of what the audit takes
}

TEST_CASE("more friction is named, sized and halves nothing but the gap", "[gap][slow]")
{
    Machine m;
    m.coulomb = 2.3;
    DiagnosisOptions options;
    options.ensemble = 4;
    const auto result = test::answer(nominal_joint(), records_of(m), test::in_order, options);
    const auto& d = result.diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    REQUIRE(!d.effects.empty());
    CHECK(d.effects[0].names == std::vector<std::string>{"coulomb-level"});
    CHECK(d.effects[0].parameters[0].value == Approx(0.3).epsilon(0.05));
    CHECK(d.effects[0].probability > 0.5);
    CHECK(d.overall.before > 2 * d.overall.after);
    CHECK(d.overall.after < 1.3);
}

TEST_CASE("an interrupted diagnosis says what was not looked at, keeps what was fitted and names nothing",
          "[gap][slow]")
{
    Machine m;
    m.coulomb = 9;
    const auto until = [&](DiagnosisStage last) {
        bool stop = false;
        DiagnosisOptions options;
        options.progress = [&](DiagnosisStage stage, double) { stop = stop || stage == last; };
        const auto run = [&](std::size_t n, const std::function<void(std::size_t)>& task) {
            if (stop) throw Interrupted();
            test::in_order(n, task);
        };
        return test::answer(nominal_joint(), records_of(m), run, options).diagnosis;
    };
    const Diagnosis early = until(DiagnosisStage::fitting_singles), delayed = until(DiagnosisStage::predicting_unseen);
    for (const auto* d : {&early, &delayed}) {
        CHECK(d->interrupted);
        CHECK(d->verdict == Verdict::unknown);
        CHECK_FALSE(d->signals.empty());
        REQUIRE(d->reasons.size() == 1);
        CHECK(std::isnan(d->overall.before));  // 0 would be no gap
        CHECK(std::isnan(d->overall.explained));
    }
    CHECK(early.effects.empty());
    CHECK(early.reasons[0].code == Note::Code::interrupted_located);
    CHECK(early.reasons[0].names.front() == "fitting-singles");
    CHECK(early.reasons[0].names.back() == "predicting-unseen");
    REQUIRE_FALSE(delayed.effects.empty());
    CHECK(delayed.effects[0].names == std::vector<std::string>{"coulomb-level"});
    CHECK(delayed.effects[0].probability <= 0.1);
    CHECK(delayed.reasons[0].code == Note::Code::interrupted_located);
    CHECK(delayed.reasons[0].names == std::vector<std::string>{"predicting-unseen"});
}

TEST_CASE("a wrong filter of the controller is the cause, and not the few per cent of the document beside it",
          "[gap][slow]")
{
    Machine m;
    m.tau = 0.0051;
    m.inertia = 1.2 * 1.04, m.coulomb = 2 * 0.96;
    DiagnosisOptions options;
    options.ensemble = 4;
    const auto d = test::answer(nominal_joint(), records_of(m), test::in_order, options).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    REQUIRE(!d.effects.empty());
    CHECK(d.effects[0].names == std::vector<std::string>{"velocity-filter"});
    CHECK(d.effects[0].probability > 0.9);
    const auto inertia = std::ranges::find(d.corrections, "inertia", &Correction::name);
    REQUIRE(inertia != d.corrections.end());
    CHECK(inertia->number.value == Approx(1.04).margin(0.01));
}

TEST_CASE("records that say nothing are answered with insufficient-data or refused, never with a cause", "[gap]")
{
    Record still = record_of({}, 1, 1);
    std::fill(still.position.begin(), still.position.end(), 0.5);
    CHECK(test::answer(nominal_joint(), {still}, test::in_order).diagnosis.verdict == Verdict::insufficient_data);

    Record backwards_in_time = record_of({}, 1, 1);
    std::swap(backwards_in_time.time[10], backwards_in_time.time[11]);
    CHECK_THROWS_AS(diagnose(nominal_joint(), {backwards_in_time}, test::in_order), std::invalid_argument);

    Record ten = record_of({}, 1, 0.01);
    CHECK(test::answer(nominal_joint(), {ten}, test::in_order).diagnosis.verdict == Verdict::insufficient_data);
}

TEST_CASE("a record in which nothing of the controller is as documented is suspected to be another joint's", "[gap]")
{
    Machine other;
    other.k_p = 1300, other.k_v = 55, other.tau = 0.006;
    const auto d = test::answer(nominal_joint(), {record_of(other, 1)}, test::in_order).diagnosis;
    CHECK(d.verdict == Verdict::insufficient_data);
    REQUIRE(d.reasons.size() == 1);
    CHECK(d.reasons[0].code == Note::Code::another_joint);
    CHECK(contradicts(d.reasons[0]));
    const auto& names = d.reasons[0].names;
    const auto k_p = std::find(names.begin(), names.end(), "gain-k_p.factor");
    REQUIRE(k_p != names.end());
    CHECK(d.reasons[0].values.at(static_cast<std::size_t>(k_p - names.begin())) == Approx(1.083).epsilon(1e-3));
}

TEST_CASE("a load with hysteresis is no cause of the catalogue, also where the document is a few per cent off",
          "[gap][slow]")
{
    Machine m;
    m.inertia = 1.2 * 1.05, m.coulomb = 2 * 0.95;
    m.amplitude = 10, m.bellows = 3, m.bellows_play = 0.12;
    DiagnosisOptions options;
    options.ensemble = 4;
    const auto d = test::answer(test::nominal_arm(), records_of(m), test::in_order, options).diagnosis;
    CHECK(d.verdict == Verdict::unknown);
    CHECK(std::ranges::any_of(d.reasons, [](const Note& note) { return note.code == Note::Code::nearer_force; }));
}

TEST_CASE("a number that takes as much as the cause beside it is named with it where the document is otherwise exact",
          "[gap][ladder][slow]")
{
    const auto answer = [](double inertia, double coulomb, double viscous) {
        Machine m;
        m.inertia = 1.2 * inertia, m.coulomb = 2 * coulomb, m.viscous = 1.5 * viscous;
        m.gravity = 0.4, m.amplitude = 3;
        DiagnosisOptions options;
        options.ensemble = 4;
        return test::answer(test::nominal_arm(), records_of(m), test::in_order, options).diagnosis;
    };
    const auto is_correction = [](const Diagnosis& d) {
        return std::ranges::any_of(d.corrections, [](const Correction& c) { return c.name == "inertia"; });
    };
    const auto sum = [](const Diagnosis& d) {
        double all = d.corrected_share + d.remainder.share;
        for (const auto& rung : d.ladder) all += rung.share;
        return all;
    };
    const auto far = answer(1.10, 1, 1);
    REQUIRE(far.verdict == Verdict::gap);
    CHECK(std::ranges::count(far.effects[0].names, "inertia") == 1);
    CHECK(far.effects[0].names.size() == 2);
    for (const auto& rung : far.ladder) UNSCOPED_INFO(rung.names[0] << " " << rung.names.size() << " " << rung.share);
    const auto rung = std::ranges::find(far.ladder, std::vector<std::string>{"inertia"}, &LadderRung::names);
    REQUIRE(rung != far.ladder.end());
    CHECK(rung->parameters.at(0).value == Approx(1.10).margin(0.01));
    CHECK_FALSE(is_correction(far));
    CHECK(sum(far) == Approx(1).margin(0.05));
    for (const auto& near : {answer(1.04, 1, 1), answer(1.10, 0.93, 1.1)}) {
        REQUIRE(near.verdict == Verdict::gap);
        CHECK(near.effects[0].names == std::vector<std::string>{"gravity"});
        CHECK(is_correction(near));
        CHECK(sum(near) == Approx(1).margin(0.05));
    }
}

TEST_CASE("a document that is usually off needs no cause, even where one explains to within noise",
          "[gap][ladder][slow]")
{
    Machine m;
    m.inertia = 1.2 * 0.98, m.coulomb = 2 * 0.98, m.viscous = 1.5 * 0.98;  // what a scale of 1.02 explains, too
    DiagnosisOptions options;
    options.ensemble = 4;
    const auto d = test::answer(nominal_joint(), records_of(m), test::in_order, options).diagnosis;
    for (const auto& cause : d.effects) UNSCOPED_INFO(cause.names[0] << " " << cause.probability);
    REQUIRE(d.verdict == Verdict::gap);
    const std::set<std::string> numbers{"inertia", "coulomb-level", "viscous", "constant-load"};
    for (const auto& name : d.effects.at(0).names) CHECK(numbers.contains(name));
    for (const auto& correction : d.corrections)
        if (correction.name == "inertia") CHECK(correction.number.value == Approx(0.98).margin(0.003));
}

TEST_CASE("what only hides in an encoder's steps is no cause beside a document that is usually off",
          "[gap][ladder][slow]")
{
    Machine m;
    m.inertia = 1.2 * 1.06, m.coulomb = 2 * 0.97, m.noise = 2e-5, m.quantum = 6e-4;
    Joint joint = nominal_joint();
    joint.sensor.position_noise = joint.sensor.encoder_quantum = 0;
    DiagnosisOptions options;
    options.ensemble = 4;
    const auto d = test::answer(joint, records_of(m), test::in_order, options).diagnosis;
    for (const auto& cause : d.effects)
        for (const auto& name : cause.names) UNSCOPED_INFO(name << " " << cause.probability);
    REQUIRE(d.verdict == Verdict::gap);
    CHECK(d.effects.at(0).names == std::vector<std::string>{"quantisation"});
}

TEST_CASE("an inertia that changes on the way is no document that is off", "[gap][ladder][slow]")
{
    Machine m;
    m.inertia = 1.2 * 1.02, m.coulomb = 2 * 1.05;
    m.picked_up = 0.3, m.picked_up_at = 2, m.amplitude = 3;
    DiagnosisOptions options;
    options.ensemble = 4;
    const auto d = test::answer(nominal_joint(), records_of(m), test::in_order, options).diagnosis;
    for (const auto& note : d.reasons) UNSCOPED_INFO(name_of(note.code));
    CHECK(d.verdict == Verdict::unknown);
    CHECK(std::ranges::any_of(d.reasons, [](const Note& note) { return note.signal == "inertia"; }));
}

TEST_CASE("a limit of the integral that no document tells is found without a logged command", "[gap][slow]")
{
    Machine m;
    m.k_i = 3 * m.k_p;
    m.integral_limit = 0.5 * m.coulomb;
    auto records = records_of(m);
    for (auto& r : records) r.effort_command.clear();
    Joint documented = nominal_joint();
    documented.control.k_i = m.k_i;
    DiagnosisOptions options;
    options.ensemble = 4;
    const auto d = test::answer(documented, records, test::in_order, options).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    REQUIRE(d.effects.at(0).names == std::vector<std::string>{"gain-k_i"});
    REQUIRE(d.effects[0].parameters[0].name == "gain-k_i.integral_limit");
    CHECK(d.effects[0].parameters[0].value == Approx(m.integral_limit).epsilon(0.02));
}

TEST_CASE("a dead zone that no document tells is found without a logged command, with its size", "[gap][slow]")
{
    Machine m;
    m.dead_zone = 8e-4;
    auto records = records_of(m);
    for (auto& r : records) r.effort_command.clear();
    DiagnosisOptions options;
    options.ensemble = 4;
    const auto d = test::answer(nominal_joint(), records, test::in_order, options).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    REQUIRE(d.effects[0].names == std::vector<std::string>{"dead-zone"});
    CHECK(d.effects[0].parameters[0].value == Approx(m.dead_zone).epsilon(0.02));
}

TEST_CASE("beside the small errors of a document a free force is no better than the cause", "[gap][slow]")
{
    Machine m;
    m.viscous = 8, m.coulomb = 2 * 0.9, m.one_way = 0.04, m.peak = 0.06;
    m.noise = 1.6e-4;  // all but hides them: the cause alone is accepted
    Joint documented = nominal_joint();
    documented.sensor.position_noise = m.noise;
    DiagnosisOptions options;
    options.ensemble = 4;
    const auto d = test::answer(documented, records_of(m), test::in_order, options).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    CHECK(d.effects[0].names == std::vector<std::string>{"viscous"});
}

TEST_CASE("on a straight guide a constant force is a load, not gravity of a lever", "[gap]")
{
    const Effect& gravity = *effect_named("gravity");
    const auto may = [&](const Joint& j) { return Candidate{{&gravity}, {&gravity.forms[0]}, 1}.applies(j); };
    CHECK_FALSE(may(nominal_joint()));
    CHECK(may(test::nominal_arm()));
    Joint documented = nominal_joint();
    documented.load.gravity_amplitude = 3;
    CHECK(may(documented));
}
