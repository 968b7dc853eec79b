// Lines that are broken between words where a person reads them: at the width of the terminal.
#pragma once
#include <cstddef>
#include <string>

namespace stickslip {

/// Of the terminal that standard output is; 0 where a program reads, or where the width is not known.
std::size_t terminal_columns();

/// One line as several of at most `columns` letters, `hang` spaces before those that follow. As it is where `columns`
/// is 0, or too few for the hang.
std::string folded(const std::string& line, std::size_t columns, std::size_t hang = 0);

/// The same for each line of a help text: descriptions of options stay in their column, examples stay whole.
std::string folded_help(const std::string& text, std::size_t columns);

}  // namespace stickslip
