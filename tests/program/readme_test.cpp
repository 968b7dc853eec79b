// What the README shows is what the program prints.
#include "tests/program/said.h"

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

/// Every line of a shell block that calls the program, without its comment.
std::vector<std::string> shown_commands(const std::string& text)
{
    std::vector<std::string> commands;
    std::istringstream in(text);
    bool shell = false;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("```")) shell = line == "```sh";
        if (shell && line.starts_with("stickslip ")) commands.push_back(line.substr(10, line.find(" #") - 10));
    }
    return commands;
}

/// Arguments as words; those after -o move into a folder of the test.
std::string redirected(const std::string& arguments, const program::Folder& folder, bool& has_inputs)
{
    std::istringstream in(arguments);
    std::string moved, word, previous;
    while (in >> word) {
        const bool input = word.ends_with(".toml") || word.ends_with(".csv") || word.ends_with(".json");
        if (input && !std::filesystem::exists(std::string(SOURCE_ROOT) + "/" + word)) has_inputs = false;
        moved += " " + (previous == "-o" ? "'" + (folder / word) + "'" : word);
        previous = word;
    }
    return moved.substr(1);
}

}  // namespace

TEST_CASE("every command of the README runs and says what it said", "[program][slow]")
{
    int ran = 0;
    for (const auto& command : shown_commands(program::read(std::string(SOURCE_ROOT) + "/README.md"))) {
        program::Folder folder;
        bool has_inputs = true;  // a line about the reader's own files cannot run here
        const auto arguments = redirected(command, folder, has_inputs);
        const bool two_runs = arguments.starts_with("report before after");
        if (two_runs)
            for (const char* name : {"before", "after"})
                REQUIRE(stickslip("sweep examples/02-ball-screw/spec.toml -o '" + (folder / name) + "'").exit_code ==
                        0);
        if (!has_inputs) continue;
        const auto run = stickslip(two_runs ? "report '" + (folder / "before") + "' '" + (folder / "after") + "' -o '" +
                                                  (folder / "comparison") + "'"
                                            : arguments);
        INFO("stickslip " << arguments << "\n" << run.output);
        CHECK(run.exit_code == 0);
        ++ran;
        program::check_said("readme-" + std::to_string(ran) + "-" + arguments.substr(0, arguments.find(' ')),
                            run.output);
    }
    CHECK(ran >= 5);
}

TEST_CASE("the README's output is the program's", "[program][slow]")
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
