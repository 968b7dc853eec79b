#include "sweep/program/verbs/folded_text.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>

namespace stickslip {
namespace {

constexpr std::size_t least_room = 24;   ///< letters of a description, or folding helps nobody
constexpr std::size_t help_column = 30;  ///< CLI11's, where the descriptions of options begin

/// Letters, not bytes: UTF-8 goes on with 10xxxxxx.
std::size_t letters(const std::string& text)
{
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

/// Spaces after which the words of a line of help begin, so that what follows stands below them.
std::size_t hang_of(const std::string& line)
{
    const bool described = line.size() > help_column && line.starts_with("  ") && line[help_column - 1] == ' ';
    return described ? help_column : 2;
}

bool is_example(const std::string& line)
{
    const auto first = line.find_first_not_of(' ');
    if (first == std::string::npos) return false;
    const auto words = line.substr(first);
    return words.starts_with("stickslip ") || words.starts_with("Example") || words.starts_with("Usage");
}

}  // namespace

std::size_t terminal_columns()
{
    winsize size{};
    if (isatty(STDOUT_FILENO) == 0 || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0) return 0;
    return size.ws_col;
}

std::string folded(const std::string& line, std::size_t columns, std::size_t hang)
{
    if (columns < hang + least_room || letters(line) <= columns) return line;
    std::string text, now;
    std::size_t at = std::min(line.find_first_not_of(' '), line.size());
    now = line.substr(0, at);
    for (bool first = true; at < line.size(); first = false) {
        const auto gap = std::min(line.find(' ', at), line.size());
        const auto next = std::min(line.find_first_not_of(' ', gap), line.size());
        const std::string word = line.substr(at, gap - at);
        if (!first && letters(now) + letters(word) > columns) {
            now.erase(now.find_last_not_of(' ') + 1);
            text += now + "\n";
            now = std::string(hang, ' ');
        }
        now += word + line.substr(gap, next - gap);
        at = next;
    }
    return text + now;
}

std::string folded_help(const std::string& text, std::size_t columns)
{
    std::istringstream lines(text);
    std::string result;
    for (std::string line; std::getline(lines, line);)
        result += (is_example(line) ? line : folded(line, columns, hang_of(line))) + "\n";
    return result;
}

}  // namespace stickslip
