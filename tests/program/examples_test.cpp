// Every spec under examples/ runs and says what it said before. `STICKSLIP_UPDATE=1 tests_program "[examples]"` stores
// what they say now.
#include "tests/program/run.h"

#include <catch2/catch.hpp>

#include <set>

using program::Folder;
using program::stickslip;

namespace {

const std::string root = SOURCE_ROOT;

/// The lines of a summary that do not name files or times.
std::string lasting_lines(const std::string& output)
{
    std::istringstream in(output);
    std::string kept;
    for (std::string line; std::getline(in, line);)
        if (line.find("computed now") == std::string::npos && !line.starts_with("results:") &&
            !line.starts_with("report:"))
            kept += line + "\n";
    return kept;
}

std::set<std::string> example_specs()
{
    std::set<std::string> specs;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root + "/examples")) {
        const auto name = entry.path().filename().string();
        if (name.starts_with("spec") && name.ends_with(".toml"))
            specs.insert(std::filesystem::relative(entry.path(), root).string());
    }
    return specs;
}

}  // namespace

TEST_CASE("every example runs and says what it said", "[program][examples]")
{
    const auto specs = example_specs();
    REQUIRE(specs.size() >= 4);
    for (const auto& spec : specs) {
        Folder folder;
        const auto run = stickslip("sweep " + spec + " -o '" + (folder / "out") + "'");
        INFO(spec << "\n" << run.output);
        CHECK(run.exit_code == 0);
        const auto path = std::filesystem::path(spec);
        const auto kept = root + "/tests/program/expected/" + path.parent_path().filename().string() + "-" +
                          path.stem().string() + ".txt";
        if (std::getenv("STICKSLIP_UPDATE")) std::ofstream(kept) << lasting_lines(run.output);
        CHECK(lasting_lines(run.output) == program::read(kept));
    }
}
