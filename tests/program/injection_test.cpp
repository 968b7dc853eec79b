// Titles, comments and file names of hostile users: pages stay text, files stay in their folder, commands stay
// commands.
#include "tests/program/run.h"

#include <catch2/catch.hpp>

#include <vector>

using program::Folder;
using program::stickslip;

namespace {

const std::string axes =
    "[axes]\n\"control.k_p\" = { from = 1e4, to = 1e5, points = 5, scale = \"log\" }\n"
    "\"control.k_v\" = { from = 1.0, to = 1e3, points = 4, scale = \"log\" }\n";
const std::string joint =
    "[joint]\nmotion = \"prismatic\"\nmodel = \"single-mass\"\ninertia = 1.0\n"
    "[control]\nk_p = 6e4\nk_v = 10.0\nV0 = 1e-3\n"
    "[friction]\nlaw = \"rate-and-state\"\nf0 = 60.0\nA = 1.0\nB = 1.5\nL = 1e-5\nV_star = 1e-3\n";

std::string quoted(const std::string& word)
{
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

std::size_t count(const std::string& text, const std::string& part)
{
    std::size_t n = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}

/// The pages and pictures of a folder, one behind the other.
std::string pages_of(const std::string& folder)
{
    std::string all;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".html" || entry.path().extension() == ".svg")
            all += program::read(entry.path());
    return all;
}

std::size_t entries_of(const std::string& folder)
{
    const std::filesystem::directory_iterator all(folder);
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

struct Attack {
    std::string as_toml, as_name;
};

const std::vector<Attack> attacks{
    {"</script><script>alert(1)</script>", "<script>alert(1)<"},
    {"\\\"><img src=x onerror=alert(1)>", "\"><img src=x onerror=alert(1)>"},
    {"'--><svg onload=alert(1)>", "'--><svg onload=alert(1)>"},
    {"../../escape", ".. escape"},
    {"two\\nlines", "two\nlines"},
    {"a\\u0000b\\u001b[31m", "$(touch escaped);`touch escaped`"},
    {"\\u202Egpj.exe\\u2066", "\u202egpj.exe"},
    {"\\u00ff", "\xff\xc3"},
};

/// What no page may have more of than the page of a harmless user, and what none may have at all.
void check_page(const std::string& page, const std::string& harmless)
{
    for (const char* tag : {"<script", "</script", "<img", "<svg", "<!--", "<iframe", "<a ", "href="})
        CHECK(count(page, tag) == count(harmless, tag));
    for (const std::string& never : {std::string(1, '\0'), std::string("\x1b"), std::string("\u202e"),
                                     std::string("\u2066"), std::string("\xff"), std::string("<img src=x")})
        CHECK(count(page, never) == 0);
}

}  // namespace

TEST_CASE("titles and file names inject nothing into pages and leave their folder nowhere", "[program][slow]")
{
    Folder harmless;
    const auto plain = harmless.write("spec.toml", "title = \"plain\"\n# plain\n" + joint + axes);
    REQUIRE(stickslip("sweep " + quoted(plain) + " -o " + quoted(harmless / "out")).exit_code == 0);
    const std::string page = pages_of(harmless / "out");
    REQUIRE(count(page, "<script") > 0);
    const auto joint_file = harmless.write("joint.toml", joint);
    REQUIRE(stickslip("evaluate " + quoted(joint_file) + " -o " + quoted(harmless / "answer")).exit_code == 0);
    const std::string answer = pages_of(harmless / "answer");

    for (const Attack& attack : attacks) {
        INFO(attack.as_toml);
        Folder folder;
        const auto spec = folder.write(attack.as_name + ".toml",
                                       "title = \"" + attack.as_toml + "\"\n# " + attack.as_toml + "\n" + joint + axes);
        const auto out = folder / (attack.as_name + ".out");
        const auto run = stickslip("sweep " + quoted(spec) + " -o " + quoted(out));
        INFO(run.output);
        REQUIRE(run.exit_code == 0);
        check_page(pages_of(out), page);

        const auto hostile_joint = folder.write("joint " + attack.as_name + ".toml", joint);
        REQUIRE(stickslip("evaluate " + quoted(hostile_joint) + " -o " + quoted(folder / "answer")).exit_code == 0);
        check_page(pages_of(folder / "answer"), answer);
        CHECK(entries_of(folder / ".") == 4);  // two files, two folders of results
    }
}
