// What the README shows is what the program prints.
#include "tests/program/run.h"

#include <catch2/catch.hpp>

#include <sstream>

using program::stickslip;

namespace {

/// Blocks announced by `<!-- output of: stickslip ARGUMENTS -->` and the lines that follow in a fenced block.
struct Shown {
    std::string arguments;
    std::vector<std::string> lines;
};

std::vector<Shown> shown_outputs(const std::string& text)
{
    constexpr std::string_view announcement = "<!-- output of: stickslip ";
    std::vector<Shown> blocks;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with(announcement)) continue;
        Shown shown{line.substr(announcement.size(), line.find(" -->") - announcement.size()), {}};
        std::getline(in, line);  // the fence
        while (std::getline(in, line) && line != "```") shown.lines.push_back(line);
        blocks.push_back(std::move(shown));
    }
    return blocks;
}

}  // namespace

TEST_CASE("the README's output is the program's", "[program]")
{
    const auto blocks = shown_outputs(program::read(std::string(SOURCE_ROOT) + "/README.md"));
    REQUIRE_FALSE(blocks.empty());
    for (const auto& shown : blocks) {
        program::Folder folder;
        const bool writes = shown.arguments.starts_with("sweep") || shown.arguments.starts_with("diagnose");
        const auto run = stickslip(shown.arguments + (writes ? " -o '" + (folder / "out") + "'" : ""));
        INFO("stickslip " << shown.arguments << "\n" << run.output);
        CHECK(run.exit_code == 0);
        for (const auto& line : shown.lines) CHECK_THAT(run.output, Catch::Matchers::Contains(line));
    }
}
