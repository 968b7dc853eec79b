#include "render/page/html.h"
#include "render/page/typeset.h"
#include "render/render.h"
#include "tests/render/example_report.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using drawing::escape;
using drawing::fill;
using drawing::html_of_markup;
using drawing::json_string;
using drawing::policy_hash;
using drawing::readable;

namespace {

std::size_t count(const std::string& text, const std::string& part)
{
    std::size_t n = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}

/// A figure that needs no drawing, so that the page alone is tested.
RenderedFigure blank()
{
    RenderedFigure figure;
    figure.svg = "<svg/>";
    figure.csv = "a,b\n";
    figure.width = figure.height = 100;
    return figure;
}

Report one_figure()
{
    Report report = example::report();
    report.sections.resize(1);
    report.sections[0].figures.resize(1);
    return report;
}

const std::string attack = "</script><img src=x onerror=alert(1)>\"'&";

}  // namespace

TEST_CASE("text and mark-up are escaped", "[page]")
{
    CHECK(escape("<a href=\"x\">'&") == "&lt;a href=&quot;x&quot;&gt;&#39;&amp;");
    CHECK(html_of_markup("k_{p} < 10^{−6}") == "k<sub>p</sub>\u00a0&lt;\u00a010<sup>−6</sup>");
    CHECK(html_of_markup("x_{<b>}") == "x<sub>&lt;b&gt;</sub>");
    CHECK(json_string("</script>\"\\\n") == R"("\u003c/script\u003e\"\\\u000a")");
}

TEST_CASE("numbers stay with their units, minus signs are minus signs, exponents are powers of ten", "[page]")
{
    const std::pair<const char*, const char*> said[] = {
        {"is 53.9 kN/m at 1 mm/s, 30.4 % of it", "is 53.9\u00a0kN/m at 1\u00a0mm/s, 30.4\u00a0% of it"},
        {"from -36.7 N·s/m to 12 1/s", "from −36.7\u00a0N·s/m to 12\u00a01/s"},
        {"14 ± 5e-05 N·m", "14\u00a0±\u00a05×10^{−5}\u00a0N·m"},
        {"10^{−6} m²", "10^{−6}\u00a0m²"},
        {"1.11 × the gain; < 5 s", "1.11\u00a0× the gain; <\u00a05\u00a0s"},
        // names, options, dates, counts and words stay
        {"take gain-k_p or --set=-5 of 2026-11-23", "take gain-k_p or --set=-5 of 2026-11-23"},
        {"2 means, 3 seconds, 4 of 5 points, 6 markers", "2 means, 3 seconds, 4 of 5 points, 6 markers"},
        {"case-12 a1e5 x 2e5y", "case-12 a1e5 x 2e5y"},
        {"", ""}};
    for (const auto& [given, set] : said) CHECK(drawing::typeset(given) == set);
}

TEST_CASE("bars of a table are drawn, one for each row", "[page][slow]")
{
    Report report = example::report();
    Table table{"shares", {"where", "share"}, {{"motion", "90 %"}, {"command", "10 %"}}};
    table.bar_column = 1;
    table.bars = {{0.9, 0.8, 0.95}, {0.1, NAN, NAN}};
    report.sections[0].tables = {table};
    const std::string html = page(report, render(report));
    CHECK_THAT(html, Catch::Matchers::Contains("<rect class=\"part\" y=\"0\" width=\"90\""));
    CHECK_THAT(html, Catch::Matchers::Contains("M80 3V11M95 3V11M80 7H95"));
    table.bars.pop_back();
    report.sections[0].tables = {table};
    CHECK_THROWS_AS(page(report, render(report)), std::invalid_argument);
}

TEST_CASE("text to take along is shown as it is, and a whole file is folded away", "[page][slow]")
{
    Report report = example::report();
    report.snippets = {{"To paste", "viscous = -3   # <N>", ""}, {"The file", "[joint]\n", "joint.toml"}};
    const std::string html = page(report, render(report));
    CHECK_THAT(html, Catch::Matchers::Contains("<pre tabindex=\"0\">viscous = -3   # &lt;N&gt;</pre></div>"));
    CHECK_THAT(html, Catch::Matchers::Contains("<details class=\"snippet\" data-file=\"joint.toml\">"));
}

TEST_CASE("text of unknown origin loses controls, marks of direction and broken bytes, and nothing else", "[page]")
{
    const std::string fine = "k_p = 2 µN·s/m, 日本, 𝜇, \n\t שלום";
    CHECK(readable(fine) == fine);
    using namespace std::string_literals;
    CHECK(readable("a\0b\x1b[31m\x7f"s) == "a\ufffdb\ufffd[31m\ufffd");
    CHECK(readable("safe\u202egpj.exe\u2066\u200f") == "safe\ufffdgpj.exe\ufffd\ufffd");
    CHECK(readable("\xff|\xc3|\xc0\xaf|\xed\xa0\x80|\xf4\x90\x80\x80") ==
          "\ufffd|\ufffd|\ufffd\ufffd|\ufffd\ufffd\ufffd|\ufffd\ufffd\ufffd\ufffd");
    CHECK(escape("\u202e<b>") == "\ufffd&lt;b&gt;");
    CHECK(json_string("\u202e") == "\"\ufffd\"");
}

TEST_CASE("what is filled in is not searched for tokens again", "[page]")
{
    CHECK(fill("a{{x}}b{{y}}", {{"x", "{{y}}"}, {"y", "1"}}) == "a{{y}}b1");
    CHECK_THROWS_AS(fill("{{z}}", {}), std::logic_error);
}

TEST_CASE("policy hashes match a published one", "[page]")
{
    // SHA-256 of nothing, as hexadecimal (FIPS 180-4 example values) and as browsers print it in policy reports.
    CHECK(policy_hash("e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855") ==
          "sha256-47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=");
}

TEST_CASE("no text of a report can become an element of the page", "[page]")
{
    Report report = one_figure();
    report.title = report.subtitle = report.verdict = attack;
    report.headlines = {{Headline::Tone::bad, attack, attack}};
    report.alerts = {{Headline::Tone::bad, attack}};
    report.not_checked = {attack};
    report.provenance = {{attack, attack}};
    Section& section = report.sections[0];
    section.title = section.text = attack;
    section.tables = {{attack, {attack}, {{attack}}}};
    section.figures[0].caption = section.figures[0].finding = attack;
    auto& map = std::get<StabilityMap>(section.figures[0].picture);
    map.x.symbol = map.y.symbol = attack;
    RenderedFigure figure = blank();
    figure.csv = attack + "\n";
    for (const bool missing : {false, true}) {
        figure.missing = missing ? attack : "";
        const std::string html = page(report, {figure});
        CHECK(count(html, "<img") == 0);
        CHECK(count(html, "</script>") == 2);  // the figure's data and the page's script, nothing else
    }
}

TEST_CASE("names among the headlines may wrap on a phone, numbers may not", "[page]")
{
    Report report = one_figure();
    report.headlines = {{Headline::Tone::bad, "backlash with sensor-offset", "cause"},
                        {Headline::Tone::bad, "5.4 floors", "gap"}};
    const std::string html = page(report, {blank()});
    CHECK(count(html, "<b class=\"words\">backlash with sensor-offset</b>") == 1);
    CHECK(count(html, "<b>5.4 floors</b>") == 1);
}

TEST_CASE("a page asks for nothing from outside", "[page]")
{
    const std::string html = page(one_figure(), {blank()});
    CHECK(count(html, "default-src 'none'") == 1);
    CHECK(count(html, "unsafe-inline") == 0);
    for (const char* outward : {"src=\"http", "href=\"http", "@import", "url("}) CHECK(count(html, outward) == 0);
}

TEST_CASE("a figure without a picture says why and keeps its numbers", "[page]")
{
    RenderedFigure figure = blank();
    figure.svg.clear();
    figure.missing = "no off-screen OpenGL";
    const std::string html = page(one_figure(), {figure});
    CHECK(count(html, "This picture was left out: no off-screen OpenGL.") == 1);
    CHECK(count(html, R"(<script type="application/json">)") == 1);
    CHECK(count(html, "class=\"sheet\"") == 0);
}

TEST_CASE("bad ids and missing figures are bad input", "[page]")
{
    Report report = one_figure();
    CHECK_THROWS_AS(page(report, {}), std::invalid_argument);
    for (const char* id : {"", "Upper", "a b", "\"x", "map", "summary"}) {  // "map" is the section's
        report.sections[0].figures[0].id = id;
        CHECK_THROWS_AS(page(report, {blank()}), std::invalid_argument);
    }
}

TEST_CASE("equal reports give equal bytes", "[page]")
{
    const Report report = one_figure();
    const auto first = render(report), second = render(report);
    CHECK(first[0].svg == second[0].svg);
    CHECK(page(report, first) == page(report, second));
}
