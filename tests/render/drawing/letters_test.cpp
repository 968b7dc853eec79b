#include "render/drawing/letters.h"
#include "render/drawing/fonts.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <vector>

using namespace stickslip::drawing;

namespace {

const std::string& font()
{
    static const std::string file = find_fonts().regular;
    return file;
}

std::vector<double> numbers(const std::string& path)
{
    std::vector<double> list;
    for (const char* at = path.c_str(); *at;) {
        char* end = nullptr;
        const double value = std::strtod(at, &end);
        if (end == at) {
            ++at;
            continue;
        }
        list.push_back(value);
        at = end;
    }
    return list;
}

}  // namespace

TEST_CASE("letters move the pen as far as the typeface's own tables say", "[letters]")
{
    // DejaVu Sans 2.37, tables hmtx and kern: k 1186, space 651, A 1401, V 1401, kern A-V -131.
    CHECK(text_advance(font(), "k") == 1186.0 / 2048);
    CHECK(text_advance(font(), " ") == 651.0 / 2048);
    CHECK(text_advance(font(), "AV") == (1401 + 1401 - 131) / 2048.0);
    CHECK(text_advance(font(), "") == 0);
    CHECK(text_advance(font(), "µ") == 1303.0 / 2048);
    CHECK(text_advance(font(), "\xff") == text_advance(font(), "\xef\xbf\xbd"));
    CHECK_THROWS_WITH(text_advance("/nowhere.ttf", "k"), Catch::Contains("/nowhere.ttf"));
}

TEST_CASE("a turned text is the straight text, turned, each letter behind the one before", "[letters]")
{
    const auto straight = numbers(outlines(font(), "Im s", 1000, 0));
    const auto upwards = numbers(outlines(font(), "Im s", 1000, 90));
    REQUIRE(straight.size() == upwards.size());
    REQUIRE(straight.size() > 40);
    for (std::size_t i = 0; i < straight.size(); i += 2) {
        CHECK(upwards[i] == Approx(straight[i + 1]).margin(0.11));
        CHECK(upwards[i + 1] == Approx(-straight[i]).margin(0.11));
    }
}

TEST_CASE("letters are the same whatever was written before", "[letters]")
{
    const std::string first = outlines(font(), "Im s [rad/s]", 130, 90);
    for (int size = 80; size < 160; ++size)
        for (const double angle : {0.0, 90.0, 33.0}) outlines(font(), "abcdefgh 0123456789", size, angle);
    CHECK(outlines(font(), "Im s [rad/s]", 130, 90) == first);
}

TEST_CASE("outlines stand on the baseline, and y points down", "[letters]")
{
    // The l of DejaVu Sans is a bar: from 193 to 377 of 2048 across, from 0 to 1556 up.
    CHECK(outlines(font(), "l", 2048, 0) == "M193-1556L377-1556L377 0L193 0L193-1556");
    CHECK(outlines(font(), "l", 204.8, 0) == "M19.3-155.6L37.7-155.6L37.7 0L19.3 0L19.3-155.6");
    CHECK(outlines(font(), " ", 2048, 0).empty());
}
