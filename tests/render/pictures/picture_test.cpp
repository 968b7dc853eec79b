#include "render/drawing/canvas.h"
#include "render/pictures/line_marks.h"
#include "render/pictures/line_scales.h"
#include "render/pictures/scene.h"
#include "render/render.h"
#include "tests/render/example_report.h"
#include "tests/render/well_formed.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <stdexcept>
#include <thread>

using namespace stickslip;
using oracle::fault_in_markup;

namespace {

Figure figure(Picture picture)
{
    return {"id", std::move(picture), "caption", "a finding with < and \"quotes\""};
}

bool holds(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

/// Runs one hidden test of this program in a process of its own, where neither a display nor an EGL vendor exists.
int run_without_gl(const std::string& tag)
{
    const std::string self = std::filesystem::read_symlink("/proc/self/exe");
    const std::string command = "env -u DISPLAY -u WAYLAND_DISPLAY __EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent.json '" +
                                self + "' -w NoTests '" + tag + "' >/dev/null 2>&1";  // no test is no success
    return std::system(command.c_str());
}

}  // namespace

TEST_CASE("every picture of a report is well-formed, described and has its numbers", "[picture][slow]")
{
    const Report report = example::report();
    const auto figures = render(report);
    REQUIRE(figures.size() == 4);
    std::size_t i = 0;
    for (const Section& section : report.sections)
        for (const Figure& f : section.figures) {
            INFO(f.id);
            const RenderedFigure& r = figures[i++];
            CHECK(r.svg.empty() != r.missing.empty());
            CHECK_FALSE(r.csv.empty());
            if (r.svg.empty()) continue;
            CHECK(fault_in_markup(r.svg) == "");
            CHECK(holds(r.svg, "aria-label=\"" + f.finding.substr(0, 10)));
            CHECK(r.plot.left > 0);
            CHECK(r.plot.left + r.plot.width < r.width);
            CHECK(r.plot.top + r.plot.height < r.height);
        }
    CHECK(fault_in_markup(page(report, figures)) == "");
}

TEST_CASE("arrays that do not fit are bad input", "[picture]")
{
    StabilityMap map = example::map(8, 6);
    map.abscissa.pop_back();
    CHECK_THROWS_AS(render(figure(map)), std::invalid_argument);
    map = example::map(8, 6);
    map.curves[0].x.pop_back();
    CHECK_THROWS_AS(render(figure(map)), std::invalid_argument);
    CriticalGainSurface surface = example::surface();
    surface.z.pop_back();
    CHECK_THROWS_AS(render(figure(surface)), std::invalid_argument);
    LineChart lines = example::lines();
    lines.lines[0].y.pop_back();
    CHECK_THROWS_AS(render(figure(lines)), std::invalid_argument);
}

TEST_CASE("odd maps are drawn too", "[picture]")
{
    StabilityMap nothing_known = example::map(6, 5);
    std::fill(nothing_known.abscissa.begin(), nothing_known.abscissa.end(), NAN);
    std::fill(nothing_known.region.begin(), nothing_known.region.end(), Region::undecided);
    nothing_known.curves.clear();
    CHECK(fault_in_markup(render(figure(nothing_known)).svg) == "");

    StabilityMap one_row = example::map(6, 5);
    one_row.y.values.resize(1);
    one_row.abscissa.resize(6);
    one_row.region.resize(6);
    CHECK(fault_in_markup(render(figure(one_row)).svg) == "");

    StabilityMap far_design = example::map(6, 5);
    far_design.design.x = 1e12;
    far_design.design.inside = false;
    CHECK(fault_in_markup(render(figure(far_design)).svg) == "");
}

TEST_CASE("line charts skip what a log axis cannot show", "[picture]")
{
    LineChart chart = example::lines();
    chart.lines[0].x[0] = 0;
    chart.lines[0].y[1] = -5;
    CHECK(fault_in_markup(render(figure(chart)).svg) == "");
    chart.lines.clear();
    chart.x_marks.clear();
    CHECK_THROWS_AS(render(figure(chart)), std::invalid_argument);
}

TEST_CASE("zero on a log axis lies on the lower edge and does not stretch it", "[picture]")
{
    LineChart chart;
    chart.title = "demand";
    chart.y_log = true;
    chart.lines = {{"falls to none", {1, 2, 3, 4}, {1e4, 1e2, 1e-12, 0}}, {"none", {1, 2, 3, 4}, {0, 0, 0, 0}}};
    const auto [x, y, below] = drawing::scales_of(chart);
    CHECK(y.low > 1e-3);
    CHECK(y.low < 1e2);
    CHECK(y.high > 1e4);
    const auto made = render(figure(chart));
    CHECK(fault_in_markup(made.svg) == "");
    // the second line runs along the edge and keeps its marks
    CHECK_THAT(made.svg, Catch::Matchers::Contains("#d55e00"));
    CHECK_THAT(made.csv, Catch::Matchers::Contains("none,4,0"));
    chart.lines.erase(chart.lines.begin(), chart.lines.begin() + 1);
    CHECK_THROWS_AS(render(figure(chart)), std::invalid_argument);
}

TEST_CASE("a line of a single sample is a mark, with air around it", "[picture]")
{
    LineChart chart;
    chart.title = "front and choice";
    chart.lines = {{"front", {1, 2, 3}, {3, 2, 1}}, {"choice", {3}, {5}}};
    const auto [x, y, below] = drawing::scales_of(chart);
    CHECK(x.high > 3);
    CHECK(y.high > 5);
    const auto made = render(figure(chart));
    CHECK(fault_in_markup(made.svg) == "");
    // one square in the chart, one in the legend
    std::size_t squares = 0;
    for (auto at = made.svg.find("#d55e00"); at != std::string::npos; at = made.svg.find("#d55e00", at + 1)) ++squares;
    CHECK(squares == 2);
    CHECK_THAT(made.csv, Catch::Matchers::Contains("choice,3,5"));
}

TEST_CASE("a mark is a datum: it stands on a sample", "[picture]")
{
    drawing::Polyline samples;
    for (int i = 0; i <= 40; ++i) samples.push_back({20.0 * i, 100 + 37.0 * (i % 7)});
    const drawing::Rectangle window{0, 0, 700, 400};
    for (std::size_t line = 0; line < 4; ++line) {
        const auto marks = drawing::marked_samples(samples, window, line);
        CHECK((marks.size() > 3 && marks.size() < 20));
        for (const auto& m : marks) CHECK(std::find(samples.begin(), samples.end(), m) != samples.end());
    }
    // of few samples each one is marked
    samples.resize(9);
    CHECK(drawing::marked_samples(samples, window, 2) == samples);
}

TEST_CASE("a second panel has its own scale and numbers, and a spike does not flatten what the axis is for",
          "[picture]")
{
    DetailedChart chart;
    chart.title = "record";
    chart.x_label = {"time", "s"}, chart.y_label = {"position", "m"}, chart.below_label = {"residual", "m"};
    chart.along_label = {"gain", "N/m"};
    chart.shown_share = 0.99;
    DetailedChart::Line measured{"measured", {}, {}}, residual{"after", {}, {}};
    for (int i = 0; i < 1000; ++i) {
        measured.x.push_back(i), measured.y.push_back(i % 10), measured.along.push_back(i);
        residual.x.push_back(i), residual.y.push_back(i == 3 ? 1e3 : 1e-3 * (i % 10));
    }
    chart.lines = {measured}, chart.below = {residual};
    const auto scales = drawing::scales_of(chart);
    CHECK(scales.y.high > 9);
    CHECK(scales.below.high < 0.1);
    const auto made = render(Figure{"two", chart, "caption", "finding"});
    CHECK(fault_in_markup(made.svg) == "");
    CHECK(made.panels.size() == 1);
    CHECK_THAT(made.csv, Catch::Matchers::StartsWith("line,time [s],position [m] | residual [m],gain [N/m]\n"));
    CHECK_THAT(made.csv, Catch::Matchers::Contains("measured,7,7,7\n"));
    CHECK_THAT(made.csv, Catch::Matchers::Contains("after,3,1000,\n"));
    chart.lines[0].along.pop_back();
    CHECK_THROWS_AS(render(Figure{"two", chart, "caption", "finding"}), std::invalid_argument);
}

TEST_CASE("threads that draw at once get what one thread gets", "[picture]")
{
    const Figure map = figure(example::map(20, 15)), lines = figure(example::lines());
    const std::string map_svg = render(map).svg, lines_svg = render(lines).svg;
    std::vector<std::string> maps(4), charts(4);
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < 4; ++i)
        threads.emplace_back([&, i] {
            maps[i] = render(map).svg;
            charts[i] = render(lines).svg;
        });
    for (auto& t : threads) t.join();
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(maps[i] == map_svg);
        CHECK(charts[i] == lines_svg);
    }
}

TEST_CASE("the photograph of a surface lies where the flat drawing puts it", "[surface]")
{
    const std::scoped_lock turn(drawing::drawing_mutex());
    const drawing::HeightField plane{{0, 0.5, 1}, {0, 1}, std::vector<double>(6, 0.4), {}, {}, {}};
    const drawing::Scene scene(plane, 30, 50, 400);
    const auto [photograph, missing] = scene.photograph(2);
    const auto& raster = photograph;  // Clang 14 captures no structured binding
    if (!missing.empty()) {
        WARN("skipped: no off-screen OpenGL here: " << missing);
        return;
    }
    REQUIRE(raster.width == 800);
    const auto alpha = [&](drawing::Point p) {  // of a point of the page
        const int column = static_cast<int>(2 * (p.x - 30)), row = static_cast<int>(2 * (p.y - 50));
        if (column < 0 || row < 0 || column >= raster.width || row >= raster.height) return 0;
        return static_cast<int>(raster.pixels[4 * (static_cast<std::size_t>(row) * raster.width + column) + 3]);
    };
    for (const double u : {0.0, 0.3, 0.7, 1.0})
        for (const double v : {0.0, 0.5, 1.0}) {
            const double inwards = 0.012;  // 3 px or so
            const auto in = scene.project(u + (0.5 - u) * inwards, v + (0.5 - v) * inwards, 0.4);
            CHECK(alpha(in) == 255);
            if (u != 0 && u != 1 && v != 0 && v != 1) continue;
            const auto out = scene.project(u - (0.5 - u) * inwards * 2, v - (0.5 - v) * inwards * 2, 0.4);
            if ((u == 0 || u == 1) && (v == 0 || v == 1)) CHECK(alpha(out) == 0);
        }
    // The box fills the window: the highest and lowest corner touch it.
    CHECK(scene.project(0, 1, 1).y == Approx(50).margin(8));
    CHECK(scene.project(1, 0, 0).y == Approx(scene.window().bottom()).margin(8));
}

TEST_CASE("flat pictures need no OpenGL at all", "[picture]")
{
    CHECK(run_without_gl("[draw-flat]") == 0);
}

TEST_CASE("a surface without OpenGL is left out with a reason", "[surface]")
{
    CHECK(run_without_gl("[draw-surface]") == 0);
}

TEST_CASE("child: flat pictures", "[.][draw-flat]")
{
    const RenderedFigure map = render(figure(example::map(20, 15)));
    const RenderedFigure lines = render(figure(example::lines()));
    REQUIRE(map.missing.empty());
    REQUIRE(lines.missing.empty());
    std::ifstream file("/proc/self/maps");
    const std::string mapped{std::istreambuf_iterator<char>(file), {}};
    for (const char* driver : {"libEGL_mesa", "libGLX_mesa", "_dri.so", "libgallium"})
        CHECK_FALSE(holds(mapped, driver));
}

TEST_CASE("child: a surface where no EGL vendor is", "[.][draw-surface]")
{
    const RenderedFigure surface = render(figure(example::surface()));
    CHECK(surface.svg.empty());
    CHECK(surface.missing == "this machine offers no off-screen OpenGL (EGL without a surface)");
    CHECK_FALSE(surface.csv.empty());
}

TEST_CASE("a drawing is well-formed whatever its words are, and has no numbers", "[picture]")
{
    LineDrawing drawing;
    drawing.title = "<script>alert(1)</script> \"k_{p}\" & 'more'";
    drawing.width = 760, drawing.height = 200;
    drawing.lines = {{{10, 10}, {700, 10}, {700, 150}}};
    drawing.boxes = {{20, 40, 120, 60}};
    drawing.rings = {{300, 100, 6}};
    drawing.labels = {{80, 70, drawing.title, LineDrawing::Anchor::left},
                      {700, 180, "k_{tr}", LineDrawing::Anchor::right}};
    drawing.notes = {"</svg><img src=x onerror=alert(1)>", std::string(400, 'x') + " wraps " + std::string(90, 'y')};
    const Figure f = figure(drawing);
    const RenderedFigure r = render(f);
    REQUIRE(r.missing.empty());
    CHECK(fault_in_markup(r.svg) == "");
    CHECK_FALSE(holds(r.svg, "<script"));
    CHECK_FALSE(holds(r.svg, "<img"));
    CHECK(r.csv.empty());
    CHECK(r.width == 900);  // that of the charts
    CHECK(png(r).size() > 1000);

    Report report;
    report.sections = {{"one", "One", "", {f}, {}}};
    const std::string html = page(report, {r});
    CHECK_FALSE(holds(html, "<script type=\"application/json\">"));  // no table of numbers is offered
    CHECK_FALSE(holds(html, "<img"));

    drawing.width = 1e9;
    CHECK_THROWS_AS(render(figure(drawing)), std::invalid_argument);
    drawing.width = std::nan("");
    CHECK_THROWS_AS(render(figure(drawing)), std::invalid_argument);
}
