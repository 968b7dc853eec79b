#include "render/drawing/canvas.h"
#include "tests/render/well_formed.h"

#include <catch2/catch.hpp>

#include <functional>
#include <mutex>
#include <regex>

using namespace stickslip::drawing;
using stickslip::oracle::fault_in_markup;

namespace {

std::string drawing_of(const std::function<void(Canvas&)>& draw)
{
    Canvas canvas(200, find_fonts());
    draw(canvas);
    return canvas.svg(100, "title", "what it shows");
}

}  // namespace

TEST_CASE("the oracle for well-formed text finds faults", "[canvas]")
{
    CHECK(fault_in_markup("<a b=\"c\"><d/>&amp;</a>").empty());
    for (const char* bad : {"<a>", "<a></b>", "<a b=c></a>", "a & b", "<a b=\"<\"></a>", "a > b", "<a b=\"&x\"></a>"})
        CHECK_FALSE(fault_in_markup(bad).empty());
}

TEST_CASE("a drawing is well-formed, whatever its words are", "[canvas]")
{
    const std::scoped_lock turn(drawing_mutex());
    Canvas canvas(200, find_fonts());
    canvas.text({10, 20}, "<&\"'> k_{p} 10^{−6} µ", {}, Across::left, Along::baseline);
    canvas.area({{1, 1}, {5, 1}, {5, 5}}, theme::ink);
    canvas.image({0, 0, 10, 10}, {1, 1, 3, {1, 2, 3}});
    const std::string svg = canvas.svg(100, "a < b & \"c\"", "d > e & 'f' \"g\"");
    CHECK(fault_in_markup(svg) == "");
    CHECK(svg.find("viewBox=\"0 0 2000 1000\"") != std::string::npos);
}

TEST_CASE("drawings bring no ids that could meet in one page", "[canvas]")
{
    const std::scoped_lock turn(drawing_mutex());
    const std::string svg = drawing_of([](Canvas& c) {
        c.line({{0, 0}, {9, 9}}, {theme::ink, 1, {3, 2}});
        c.text({10, 20}, "word", {13, theme::ink, true, 90, true}, Across::centre, Along::middle);
        c.image({0, 0, 10, 10}, {1, 1, 3, {1, 2, 3}});
    });
    CHECK_FALSE(std::regex_search(svg, std::regex(R"(\sid=|url\(#|xlink:href|style=)")));
}

TEST_CASE("lines lie where they were put, from the top left, in tenths of a pixel", "[canvas]")
{
    const std::scoped_lock turn(drawing_mutex());
    const std::string svg = drawing_of([](Canvas& c) { c.line({{12.3, 4}, {50, 60.5}}, {from_hex(0x112233), 1.5}); });
    CHECK(std::regex_search(
        svg, std::regex(R"(stroke="#112233"[^>]*stroke-width="15"[^>]*points="\s*123,40\s+500,605\s*")")));
}

TEST_CASE("text is as wide as its parts and wraps at spaces", "[canvas]")
{
    const std::scoped_lock turn(drawing_mutex());
    Canvas canvas(200, find_fonts());
    const TextStyle style{20};
    const double k = canvas.text_width("k", style);
    // DejaVu Sans: advance of k 1186, of a space 651, of 2048 units an em.
    CHECK(k == Approx(20 * 1186.0 / 2048).margin(0.15));
    CHECK(canvas.text_width(" ", style) == Approx(20 * 651.0 / 2048).margin(0.15));
    CHECK(canvas.text_width("k_{k}", style) == Approx(k * 1.72).margin(0.15));
    const double words = canvas.text_width("one two", style);
    CHECK(canvas.wrap("one two three", style, words + 1) == std::vector<std::string>{"one two", "three"});
    CHECK(canvas.wrap("unbreakable", style, 1) == std::vector<std::string>{"unbreakable"});
    CHECK(canvas.wrap("", style, 100).empty());
}

TEST_CASE("letters are outlines, so no reader needs the typeface", "[canvas]")
{
    const std::scoped_lock turn(drawing_mutex());
    const std::string svg = drawing_of([](Canvas& c) { c.text({10, 20}, "x", {}, Across::left, Along::baseline); });
    CHECK(svg.find("<text") == std::string::npos);
    CHECK(svg.find("font") == std::string::npos);
}

TEST_CASE("a machine without the typeface is told what to install", "[canvas]")
{
    const Fonts fonts = find_fonts({"/nowhere", "/neither"});
    CHECK(fonts.regular.empty());
    CHECK(fonts.missing ==
          "the typeface DejaVu Sans was not found in /nowhere, /neither (Debian: install fonts-dejavu-core)");
    CHECK(find_fonts().missing.empty());
}
