#include "render/page/page_table.h"

#include "render/drawing/markup.h"
#include "render/page/html.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stickslip {
namespace {

using namespace drawing;

/// A share from 0 to 1 as a drawn bar, its interval as a whisker on it. The number stands beside it in words.
std::string bar(const ShareBar& b)
{
    if (!std::isfinite(b.share)) return "";
    constexpr double width = 100, height = 14;
    const auto at = [](double share) { return std::to_string(std::lround(width * std::clamp(share, 0.0, 1.0))); };
    const auto box = [](const char* name, const std::string& wide, double y, double high) {
        return "<rect class=\"" + std::string(name) + "\" y=\"" + std::to_string(std::lround(y)) + "\" width=\"" +
               wide + "\" height=\"" + std::to_string(std::lround(high)) + "\"/>";
    };
    std::string svg = "<svg class=\"bar\" width=\"100\" height=\"14\" viewBox=\"0 0 100 14\" aria-hidden=\"true\">" +
                      box("whole", at(1), 0, height) + box("part", at(b.share), 0, height);
    if (std::isfinite(b.low) && std::isfinite(b.high) && b.high > b.low)
        svg += "<path class=\"interval\" d=\"M" + at(b.low) + " 3V11M" + at(b.high) + " 3V11M" + at(b.low) + " 7H" +
               at(b.high) + "\"/>";
    return svg + "</svg>";
}

/// How many steps of shading there are; the style sheet has a class for each.
constexpr double shades = 5;

/// The first cell of a row that leads to a page of its own.
std::string leading_cell(const Table& t, const CellMarks& marks, std::size_t row)
{
    const std::string text = html_of_markup(t.rows[row][0]);
    return "<th scope=\"row\">" +
           (marks.links[row].empty() ? text : "<a href=\"" + escape(marks.links[row]) + "\">" + text + "</a>") +
           "</th>";
}

std::string opening_of_cell(const CellMarks& marks, std::size_t row, std::size_t column)
{
    if (marks.shares.empty() || !std::isfinite(marks.shares[row][column])) return "<td>";
    const double step = std::clamp(std::ceil(shades * marks.shares[row][column]), 1.0, shades);
    return "<td class=\"share" + std::to_string(std::lround(step)) + "\">";
}

/// One entry a row, where there are any.
template <class Entries>
void check_length(const Table& t, const Entries& entries, const char* what)
{
    if (!entries.empty() && entries.size() != t.rows.size())
        throw std::invalid_argument("table \"" + t.title + "\": " + std::to_string(t.rows.size()) + " rows and " +
                                    std::to_string(entries.size()) + " " + what);
}

}  // namespace

std::string table(const Table& t, const CellMarks& marks)
{
    std::string html = "<div class=\"table\" tabindex=\"0\" role=\"region\" aria-label=\"" +
                       escape(plain_text(t.title)) + "\"><table>\n<caption>" + html_of_markup(t.title) +
                       "</caption>\n<thead><tr>";
    for (const std::string& column : t.columns)
        html += column.empty() ? "<td></td>" : "<th scope=\"col\">" + html_of_markup(column) + "</th>";
    html += "</tr></thead>\n<tbody>\n";
    check_length(t, t.bars, "bars");
    check_length(t, marks.links, "links");
    check_length(t, marks.shares, "rows of shares");
    for (std::size_t row = 0; row < t.rows.size(); ++row) {
        html += marks.links.empty() ? "<tr>" : "<tr>" + leading_cell(t, marks, row);
        for (std::size_t column = marks.links.empty() ? 0 : 1; column < t.rows[row].size(); ++column) {
            const bool barred = !t.bars.empty() && column == t.bar_column;
            html += (barred ? "<td class=\"barred\">" + bar(t.bars[row]) : opening_of_cell(marks, row, column)) +
                    html_of_markup(t.rows[row][column]) + "</td>";
        }
        html += "</tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

}  // namespace stickslip
