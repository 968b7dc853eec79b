#include "render/drawing/encode.h"

#include <catch2/catch.hpp>

using namespace stickslip::drawing;

TEST_CASE("base64 gives the test vectors of RFC 4648", "[encode]")
{
    const std::pair<const char*, const char*> vectors[] = {{"", ""},
                                                           {"f", "Zg=="},
                                                           {"fo", "Zm8="},
                                                           {"foo", "Zm9v"},
                                                           {"foob", "Zm9vYg=="},
                                                           {"fooba", "Zm9vYmE="},
                                                           {"foobar", "Zm9vYmFy"}};
    for (const auto& [bytes, text] : vectors) CHECK(base64(bytes) == text);
    CHECK(base64(std::string("\xff\x00\xfe", 3)) == "/wD+");
}

TEST_CASE("a raster becomes a PNG of its size and kind", "[encode]")
{
    for (const int channels : {3, 4}) {
        const Raster raster{300, 2, channels, std::vector<std::uint8_t>(static_cast<std::size_t>(600 * channels), 77)};
        const std::string bytes = png(raster);
        // PNG specification, 5.2 and 11.2.2: signature, then IHDR with width, height, bit depth and colour type.
        REQUIRE(bytes.size() > 33);
        CHECK(bytes.substr(0, 8) == "\x89PNG\r\n\x1a\n");
        CHECK(bytes.substr(12, 12) == std::string("IHDR\0\0\x01\x2c\0\0\0\x02", 12));
        CHECK(bytes[24] == 8);
        CHECK(bytes[25] == (channels == 3 ? 2 : 6));
        CHECK(bytes.size() < 400);  // compressed: the pixels alone are 1800 bytes and more
    }
}
