#include "render/drawing/markup.h"
#include "render/marked_page.h"
#include "render/page/figure_data.h"
#include "render/page/html.h"
#include "render/page/line_data.h"
#include "render/page/page_table.h"
#include "render/page/sources.h"

#include <set>
#include <stdexcept>

namespace stickslip {
namespace {

using namespace drawing;

const char* tone_class(Headline::Tone tone)
{
    switch (tone) {
        case Headline::Tone::good:
            return "good";
        case Headline::Tone::warning:
            return "warning";
        case Headline::Tone::bad:
            return "bad";
        case Headline::Tone::neutral:
            break;
    }
    return "neutral";
}

/// A reader who cannot see the colour or the sign hears the word.
std::string spoken_tone(Headline::Tone tone)
{
    return R"(<span class="sign" aria-hidden="true"></span>)" +
           std::string(tone == Headline::Tone::bad || tone == Headline::Tone::warning
                           ? R"(<span class="spoken">Attention: </span>)"
                           : "");
}

/// Ids become anchors and names of files, so nothing but [a-z0-9-] passes, and nothing twice.
class Ids {
  public:
    const std::string& take(const std::string& id)
    {
        if (id.empty() || id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") != std::string::npos)
            throw std::invalid_argument("report id \"" + id + "\": expected a-z, 0-9 and -, at least one");
        if (!taken_.insert(id).second) throw std::invalid_argument("report id \"" + id + "\" is used twice");
        return id;
    }

  private:
    std::set<std::string> taken_;
};

/// A number stays on one line with its unit; names may wrap where the screen is narrow.
std::string headline_value(const std::string& value)
{
    const bool number = value.find_first_of("0123456789") != std::string::npos;
    return (number ? "<b>" : "<b class=\"words\">") + html_of_markup(value) + "</b>";
}

std::string headlines(const std::vector<Headline>& list)
{
    if (list.empty()) return "";
    std::string html = "<ul class=\"cards\">\n";
    for (const Headline& h : list)
        html += std::string("<li class=\"card ") + tone_class(h.tone) + "\">" + headline_value(h.value) + "<span>" +
                html_of_markup(h.meaning) + "</span></li>\n";
    return html + "</ul>\n";
}

std::string alerts(const std::vector<Alert>& list)
{
    if (list.empty()) return "";
    std::string html = "<ul class=\"alerts\" aria-label=\"Alerts\">\n";
    for (const Alert& a : list)
        html += std::string("<li class=\"alert ") + tone_class(a.tone) + "\">" + spoken_tone(a.tone) + "<span>" +
                html_of_markup(a.text) + "</span></li>\n";
    return html + "</ul>\n";
}

std::string paragraphs(const std::vector<std::string>& list)
{
    std::string html;
    for (const std::string& text : list) html += "<p class=\"finding\">" + html_of_markup(text) + "</p>\n";
    return html;
}

/// What is only copied stands open; a whole file, to be saved, is folded away.
std::string snippets(const std::vector<Snippet>& list)
{
    std::string html;
    for (const Snippet& s : list) {
        const std::string title = html_of_markup(s.title), text = "<pre tabindex=\"0\">" + escape(s.text) + "</pre>";
        html += s.file.empty() ? "<div class=\"snippet\"><p>" + title + "</p>" + text + "</div>\n"
                               : "<details class=\"snippet\" data-file=\"" + escape(s.file) + "\"><summary>" + title +
                                     "</summary>" + text + "</details>\n";
    }
    return html;
}

/// What a reader can do with a picture on the page.
std::string how_to_read(const Picture& picture)
{
    const auto* map = std::get_if<StabilityMap>(&picture);
    const auto* field = std::get_if<FieldMap>(&picture);
    const auto* panels = std::get_if<StabilityPanels>(&picture);
    const auto* plain = std::get_if<LineChart>(&picture);
    const auto* more = std::get_if<DetailedChart>(&picture);
    if (plain || more)
        return std::string(more && more->played ? "Press Play to see it move. " : "") +
               "Point at a line, or focus the chart and use the arrow keys, to read its values" +
               ((plain ? plain->lines.size() : more->lines.size()) > 1 ? "; up and down change the line." : ".");
    if (!map && !field && !panels) return "";
    std::string text = "Point at the chart, or focus it and use the arrow keys, to read its values.";
    if (!(map ? map->command : field ? field->command : panels->command).empty())
        text += " Click, or press Enter, for the command that reproduces a place" +
                std::string(map && !map->motions.empty() ? " and a motion near it." : ".");
    if (map && !map->layers.empty()) text += " The slider moves along the third axis.";
    return text;
}

std::string figure(const Figure& f, const RenderedFigure& rendered, int number)
{
    const std::string numbers = figure_data(f, rendered);
    const std::string data = (numbers.empty() ? "" : "<script type=\"application/json\">" + numbers + "</script>\n") +
                             "<div class=\"tools\"></div>\n";
    const std::string picture = rendered.missing.empty()
                                    ? "<div class=\"stage\"><div class=\"sheet\">" + rendered.svg + "</div></div>"
                                    : "<p class=\"left-out\">This picture was left out: " + escape(rendered.missing) +
                                          (numbers.empty() ? ".</p>" : ". Its numbers are here.</p>");
    const std::string help = rendered.missing.empty() ? how_to_read(f.picture) : "";
    const std::string how_to = help.empty() ? "" : " <span class=\"how-to\">" + help + "</span>";
    return fill(figure_html.text, {{"id", f.id},
                                   {"picture", picture},
                                   {"number", std::to_string(number)},
                                   {"caption", html_of_markup(f.caption)},
                                   {"how-to", how_to},
                                   {"tools", data}});
}

std::string heading(const std::string& id, const std::string& title)
{
    return "<h2><a href=\"#" + id + "\">" + title + "</a></h2>\n";
}

std::string not_checked(const std::vector<std::string>& list)
{
    if (list.empty()) return "";
    std::string html = "<section class=\"not-checked\" id=\"not-checked\">\n" +
                       heading("not-checked", "What was not checked") + "<ul>\n";
    for (const std::string& item : list) html += "<li>" + html_of_markup(item) + "</li>\n";
    return html + "</ul>\n</section>\n";
}

std::string provenance(const std::vector<std::pair<std::string, std::string>>& list)
{
    if (list.empty()) return "";
    std::string html =
        "<section class=\"provenance\" id=\"provenance\">\n" + heading("provenance", "Provenance") + "<dl>\n";
    for (const auto& [name, value] : list) html += "<dt>" + escape(name) + "</dt><dd>" + escape(value) + "</dd>\n";
    return html + "</dl>\n</section>\n";
}

std::string link_to(const PageAbove& above)
{
    if (above.address.empty()) return "";
    return "<a href=\"" + escape(above.address) + "\">" + html_of_markup(above.title) + "</a> · ";
}

std::string contents_line(const std::string& id, const std::string& title)
{
    return "<li><a href=\"#" + id + "\">" + title + "</a></li>\n";
}

}  // namespace

std::string page(const Report& report, const std::vector<RenderedFigure>& figures)
{
    return marked_page(report, figures, {});
}

std::string marked_page(const Report& report, const std::vector<RenderedFigure>& figures, const TableMarks& marks,
                        const PageAbove& above)
{
    std::size_t wanted = 0;
    for (const Section& section : report.sections) wanted += section.figures.size();
    if (figures.size() != wanted)
        throw std::invalid_argument("the report has " + std::to_string(wanted) + " figures, but " +
                                    std::to_string(figures.size()) + " were rendered");
    Ids ids;
    for (const char* own : {"summary", "not-checked", "provenance"}) ids.take(own);
    std::string sections, contents = contents_line("summary", "Summary");
    std::size_t next = 0;
    for (const Section& section : report.sections) {
        const std::string title = html_of_markup(section.title);
        sections += "<section id=\"" + ids.take(section.id) + "\">\n" + heading(section.id, title);
        contents += contents_line(section.id, title);
        if (!section.text.empty()) sections += "<p class=\"prose\">" + html_of_markup(section.text) + "</p>\n";
        for (const Figure& f : section.figures) {
            ids.take(f.id);
            sections += figure(f, figures[next], static_cast<int>(next) + 1);
            ++next;
        }
        for (const Table& t : section.tables) {
            const auto marked = marks.find(t.title);
            sections += table(t, marked == marks.end() ? CellMarks{} : marked->second);
        }
        sections += "</section>\n";
    }
    if (!report.not_checked.empty()) contents += contents_line("not-checked", "What was not checked");
    if (!report.provenance.empty()) contents += contents_line("provenance", "Provenance");

    bool zoom = false;
    for (const Section& section : report.sections)
        for (const Figure& f : section.figures) zoom = zoom || zoomable(f.picture);
    const auto hash = [zoom](const Source& source) {
        return zoom ? " '" + policy_hash(source.sha256) + "'" : std::string();
    };
    const auto inlined = [zoom](const char* tag, const Source& source) {
        return zoom ? "<" + std::string(tag) + ">" + std::string(source.text) + "</" + tag + ">\n" : std::string();
    };
    return fill(page_html.text, {{"zoom-style-hash", hash(dygraph_min_css)},
                                 {"zoom-script-hash", hash(dygraph_min_js)},
                                 {"zoom-style", inlined("style", dygraph_min_css)},
                                 {"zoom-script", inlined("script", dygraph_min_js)},
                                 {"style-hash", policy_hash(page_css.sha256)},
                                 {"script-hash", policy_hash(page_js.sha256)},
                                 {"style", std::string(page_css.text)},
                                 {"script", std::string(page_js.text)},
                                 {"title-text", escape(plain_text(report.title))},
                                 {"title", html_of_markup(report.title)},
                                 {"subtitle", link_to(above) + html_of_markup(report.subtitle)},
                                 {"tone", tone_class(report.tone)},
                                 {"verdict", html_of_markup(report.verdict)},
                                 {"headlines", headlines(report.headlines)},
                                 {"alerts", alerts(report.alerts)},
                                 {"findings", paragraphs(report.findings) + snippets(report.snippets)},
                                 {"contents", contents},
                                 {"sections", sections},
                                 {"not-checked", not_checked(report.not_checked)},
                                 {"provenance", provenance(report.provenance)}});
}

}  // namespace stickslip
