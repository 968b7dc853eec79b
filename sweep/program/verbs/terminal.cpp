#include "sweep/program/verbs/terminal.h"

#include "sweep/program/verbs/folded_text.h"
#include "sweep/words/plain_text.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

namespace stickslip {
namespace {

const char* code_of(Headline::Tone tone)
{
    switch (tone) {
        case Headline::Tone::good:
            return "\033[32m";
        case Headline::Tone::warning:
            return "\033[33m";
        case Headline::Tone::bad:
            return "\033[31m";
        case Headline::Tone::neutral:
            break;
    }
    return "";
}

bool colours()
{
    // no-color.org: set and not empty
    const auto set = [](const char* name, std::string_view unless) {
        const char* value = std::getenv(name);
        return value && value != unless;
    };
    static const bool wanted = isatty(STDOUT_FILENO) != 0 && !set("NO_COLOR", "") && set("TERM", "dumb");
    return wanted;
}

/// Letters, not bytes: for columns.
std::size_t letters(const std::string& text)
{
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

}  // namespace

std::string toned(const std::string& text, Headline::Tone tone)
{
    const std::string code = colours() ? code_of(tone) : "";
    return code.empty() ? text : code + text + "\033[0m";
}

std::string terminal_summary(const Report& report)
{
    const auto columns = terminal_columns();
    std::string text = toned(folded(plain_text(report.verdict), columns), report.tone) + "\n";
    for (const auto& alert : report.alerts)
        text += toned(folded("! " + plain_text(alert.text), columns, 2), alert.tone) + "\n";
    std::size_t widest = 0;
    for (const auto& headline : report.headlines) widest = std::max(widest, letters(plain_text(headline.value)));
    for (const auto& headline : report.headlines) {
        const auto value = plain_text(headline.value);
        const auto hang = widest + 4;
        // coloured after folding: colours are no letters
        const auto line = folded(
            "  " + value + std::string(widest + 2 - letters(value), ' ') + plain_text(headline.meaning), columns, hang);
        text += "  " + toned(value, headline.tone) + line.substr(2 + value.size()) + "\n";
    }
    return text;
}

void print_sentence(const std::string& text)
{
    fmt::print("{}\n", folded(plain_text(text), terminal_columns()));
}

void print_table(const Table& table)
{
    const auto length = [](const std::string& s) {
        return static_cast<std::size_t>(std::count_if(s.begin(), s.end(), [](char c) { return (c & 0xC0) != 0x80; }));
    };
    std::vector<std::vector<std::string>> rows{table.columns};
    rows.insert(rows.end(), table.rows.begin(), table.rows.end());
    std::vector<std::size_t> width(table.columns.size());
    for (auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) {
            row[i] = plain_text(row[i]);
            width[i] = std::max(width[i], length(row[i]));
        }
    fmt::print("\n{}\n", table.title);
    for (const auto& row : rows) {
        std::string line = " ";
        for (std::size_t i = 0; i < row.size(); ++i)
            line += " " + row[i] + std::string(width[i] - length(row[i]) + 1, ' ');
        line.erase(line.find_last_not_of(' ') + 1);
        fmt::print("{}\n", line);
    }
}

}  // namespace stickslip
