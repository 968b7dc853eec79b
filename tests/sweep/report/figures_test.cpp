// The paper's page: every number met, every joint drawn.
#include "sweep/report/figures_report.h"
#include "sweep/report/linear_report.h"
#include "sweep/report/model_drawing.h"

#include <catch2/catch.hpp>

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
    const auto report = figures_report();
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

TEST_CASE("each lumped model is drawn with its own parts", "[figures]")
{
    for (const auto& model : paper_models()) {
        const auto svg = model_drawing(model.joint);
        CAPTURE(model.id);
        const auto has = [&](const char* text) { return svg.find(text) != std::string::npos; };
        CHECK(has("<svg"));
        CHECK(has("rate-and-state"));
        CHECK(has("reduction N = 10") == (model.id == "fig-5" || model.id.starts_with("fig-6")));
        CHECK(has("J<tspan") == (model.id == "fig-4"));
        CHECK(has("F<tspan") == (model.id != "fig-7a"));
    }
}

TEST_CASE("the page of a joint has the sections that the joint has", "[figures]")
{
    for (const auto& model : paper_models()) {
        const auto study = linear_study(model.joint);
        const auto report = linear_report(model.joint, linear_verdict(model.joint), {}, study);
        check_ids(report);
        std::set<std::string> ids;
        for (const auto& section : report.sections) ids.insert(section.id);
        CAPTURE(model.id);
        CHECK(ids.count("comparison") == 1);
        CHECK(ids.count("reductions") == (model.joint.mechanism.model == Model::single_mass ? 0 : 1));
        CHECK(ids.count("ramps") == (model.joint.control.kind == ControlKind::force ? 1 : 0));
    }
    Joint unset = paper_joint();
    unset.control.V0 = not_set;
    CHECK(linear_report(unset, linear_verdict(unset), {}, linear_study(unset)).tone == Headline::Tone::warning);
}
