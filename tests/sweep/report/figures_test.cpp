// The paper's page: every number met, every joint drawn.
#include "sweep/report/figures/loop_figures.h"
#include "sweep/report/figures/model_drawing.h"
#include "sweep/report/pages/figures_report.h"
#include "sweep/report/pages/linear_report.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>

using namespace stickslip;

namespace {

/// Sections and figures share one space of anchors.
void check_ids(const Report& report)
{
    std::set<std::string> ids;
    for (const auto& section : report.sections) {
        CHECK(ids.insert(section.id).second);
        for (const auto& figure : section.figures) {
            CAPTURE(figure.id);
            CHECK(ids.insert(figure.id).second);
            CHECK_FALSE(figure.finding.empty());
        }
    }
}

/// A logarithmic axis draws nothing at or below zero.
void check_log_axes(const Figure& figure)
{
    const auto* chart = std::get_if<LineChart>(&figure.picture);
    if (!chart) return;
    CAPTURE(figure.id);
    for (const auto& line : chart->lines) {
        const auto below = [](double v) { return v < 0; };
        CHECK((!chart->x_log || std::none_of(line.x.begin(), line.x.end(), below)));
        CHECK((!chart->y_log || std::none_of(line.y.begin(), line.y.end(), below)));
    }
}

}  // namespace

TEST_CASE("every number of the paper is met", "[figures]")
{
    const auto numbers = paper_numbers();
    CHECK(numbers.size() >= 16);
    for (const auto& n : numbers) {
        CAPTURE(n.equation, n.statement);
        CHECK(n.computed == Approx(n.printed).epsilon(figure_tolerance));
    }
}

TEST_CASE("the page of the paper has every figure once", "[figures]")
{
    const auto report = figures_report(paper_answer());
    check_ids(report);
    CHECK(report.tone == Headline::Tone::good);
    std::set<std::string> ids;
    for (const auto& section : report.sections)
        for (const auto& figure : section.figures) ids.insert(figure.id);
    for (const char* id : {"fig-1a", "fig-1b", "fig-2", "fig-3", "regions", "crossing", "root-locus", "armstrong"})
        CHECK(ids.count(id) == 1);
}

TEST_CASE("reductions of Figs. 4 to 7 keep the boundary roughly where it was", "[figures]")
{
    // the paper's joint has k_cr = 55 kN/m; its motor adds 0.1 kg behind springs of 1 and 2 MN/m
    const auto models = paper_models();
    REQUIRE(models.size() == 6);
    for (const auto& model : models) {
        if (model.id == "fig-7a") continue;  // its k_p is the transmission
        const auto verdict = linear_verdict(model.joint);
        CAPTURE(model.id);
        REQUIRE(verdict.state_variable.stable_intervals.size() == 1);
        CHECK(verdict.state_variable.stable_intervals[0].low == Approx(5.2e4).epsilon(0.1));
    }
}

TEST_CASE("each lumped model is drawn with its own parts and numbers", "[figures]")
{
    for (const auto& model : paper_models()) {
        const auto drawing = model_drawing(model.joint);
        CAPTURE(model.id);
        std::string words;
        for (const auto& label : drawing.labels) words += label.text + "\n";
        for (const auto& note : drawing.notes) words += note + "\n";
        const auto has = [&](const char* text) { return words.find(text) != std::string::npos; };
        CHECK(drawing.boxes.size() == (model.id == "fig-5" ? 3 : model.id.starts_with("fig-7") ? 1 : 2));
        CHECK(has("A = 1 N, B = 1.5 N, L = 10 µm, V* = 1 mm/s"));
        CHECK(has("coulomb-viscous, F_{c} = ") == !model.id.starts_with("fig-7"));
        CHECK(has("reduction N = 10") == (model.id == "fig-5" || model.id.starts_with("fig-6")));
        CHECK(has("J_{tr} = ") == (model.id == "fig-4"));
        CHECK(has("F_{m}") == (model.id != "fig-7a"));
        CHECK(has("normal_load") == false);
        // nothing hangs over the edge
        for (const auto& label : drawing.labels)
            CHECK((label.x > 0 && label.x < drawing.width && label.y < drawing.height));
        for (const auto& line : drawing.lines)
            for (const auto& [x, y] : line) CHECK((x >= 0 && x <= drawing.width && y >= 0 && y <= drawing.height));
    }
    // further terms are named where they are not at rest, and a ramp says its rate
    Joint joint = paper_joint();
    joint.friction.normal_load = 2;
    joint.control.kind = ControlKind::force;
    joint.control.force_rate = 60;
    joint.control.V0 = not_set;
    const auto drawing = model_drawing(joint);
    REQUIRE(drawing.notes.size() == 2);
    CHECK(drawing.notes[0].find("slides at V_{0} = 3 mm/s: the force rises by 60 N/s") != std::string::npos);
    CHECK(drawing.notes[1].find("normal_load = 2") != std::string::npos);
}

TEST_CASE("the page of a joint has the sections that the joint has", "[figures][slow]")
{
    for (const auto& model : paper_models()) {
        const auto report = linear_report(
            model.joint, answer_joint(model.joint, linear_verdict(model.joint), {}, linear_study(model.joint)));
        check_ids(report);
        std::set<std::string> ids;
        for (const auto& section : report.sections) ids.insert(section.id);
        CAPTURE(model.id);
        CHECK(ids.count("model") == 1);
        CHECK(ids.count("comparison") == 1);
        CHECK(ids.count("reductions") == (model.joint.mechanism.model == Model::single_mass ? 0 : 1));
        CHECK(ids.count("ramps") == (model.joint.control.kind == ControlKind::force ? 1 : 0));
    }
    Joint unset = paper_joint();
    unset.control.V0 = not_set;
    const auto undecided = linear_report(unset, answer_joint(unset, linear_verdict(unset), {}, linear_study(unset)));
    CHECK(undecided.tone == Headline::Tone::warning);
    CHECK(undecided.sections.front().id == "model");
}

TEST_CASE("the root locus of a lag crosses the axis at the ends of its windows", "[figures]")
{
    // a lag of 5 ms on a slope of −100 N·s/m: crossings at ωτ = π/2 and 3π/2, k_p = m ω² ± ω |f_ss'|
    Joint joint = paper_joint();
    TimeLag law;
    law.lag = 5e-3;
    law.curve.law = Stribeck{1, 0, 100 * 1e-3 * std::exp(1.0), 1e-3, 1};
    joint.friction.law = law;
    const auto figures = loop_figures(sampled_root_locus(joint, 2e4, 2e6), Units(Motion::prismatic));
    REQUIRE(figures.size() == 1);
    CHECK(figures[0].finding.find("130.1 kN/m, 794 kN/m") != std::string::npos);
    const auto& lines = std::get<DetailedChart>(figures[0].picture).lines;
    REQUIRE(lines.size() >= 2);
    CHECK(lines[0].name.find("sliding is stable") != std::string::npos);
    // no root to the right among those of the stable gains, but the last step from the boundary
    CHECK(std::none_of(lines[0].x.begin(), lines[0].x.end(), [](double x) { return x > 20; }));
    CHECK(std::any_of(lines[1].x.begin(), lines[1].x.end(), [](double x) { return x > 20; }));
    std::set<int> crossed;
    for (const auto& line : lines)
        for (std::size_t i = 1; i < line.x.size(); ++i)
            if (line.x[i - 1] * line.x[i] <= 0 && line.y[i] > 0)
                crossed.insert(static_cast<int>(std::lround(line.y[i] * 5e-3 / M_PI_2)));
    CHECK(crossed.count(1) == 1);
    CHECK(crossed.count(3) == 1);
    CHECK(crossed.count(2) == 0);
}

TEST_CASE("a joint that moves backwards has the page of one that moves forwards", "[figures][slow]")
{
    for (const double gain : {1.0, -1.0}) {
        Joint joint;
        joint.mechanism.inertia = 1;
        joint.friction.law = Stribeck{.c0 = 8, .c1 = 20, .c2 = 6, .c3 = 2e-3};
        joint.control.k_p = gain * 20e3, joint.control.k_v = gain * 500;
        joint.actuator.effort_gain = gain;
        std::vector<Report> pages;
        for (const double V0 : {1e-3, -1e-3}) {
            joint.control.V0 = V0;
            const auto study = linear_study(joint);
            pages.push_back(linear_report(joint, answer_joint(joint, linear_verdict(joint), {}, study)));
        }
        REQUIRE(pages[0].sections.size() == pages[1].sections.size());
        for (std::size_t i = 0; i < pages[0].sections.size(); ++i) {
            CAPTURE(gain, pages[0].sections[i].id);
            CHECK(pages[0].sections[i].figures.size() == pages[1].sections[i].figures.size());
        }
        for (const auto& section : pages[1].sections)
            for (const auto& figure : section.figures) check_log_axes(figure);
    }
}
