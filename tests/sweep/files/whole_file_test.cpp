// Files of the program appear whole, or what stood there stays.
#include "sweep/files/text/whole_file.h"
#include "tests/sweep/engine/sample_sweep.h"
#include "tests/sweep/file_size_limit.h"

#include <catch2/catch.hpp>

using namespace stickslip;

namespace {

std::string content(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("a file is replaced whole, and its folders are made")
{
    const TemporaryDirectory folder;
    const auto file = folder / "new/design.json";
    write_whole(file, "one");
    write_whole(file, std::string_view("t\0wo", 4));
    CHECK(content(file) == std::string("t\0wo", 4));
    CHECK(std::distance(std::filesystem::directory_iterator(folder / "new"), {}) == 1);
}

TEST_CASE("on a full disk the old file stays, and the reason is told")
{
    const TemporaryDirectory folder;
    const auto file = folder / "design.json";
    write_whole(file, "old");
    const std::string large(1 << 20, 'x');
    {
        const FileSizeLimit full_disk(1000);
        try {
            write_whole(file, large);
            FAIL("a full disk took a file");
        } catch (const std::filesystem::filesystem_error& e) {
            CHECK(e.path1() == file);
            CHECK(e.code() == std::errc::file_too_large);
        }
    }
    CHECK(content(file) == "old");
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("a device is written to, not replaced")
{
    const TemporaryDirectory folder;
    const auto null = folder / "null";
    std::filesystem::create_symlink("/dev/null", null);
    write_whole(null, "one");
    CHECK(std::filesystem::is_symlink(null));
    std::filesystem::create_symlink("/dev/full", folder / "full");
    CHECK_THROWS_AS(write_whole(folder / "full", "one"), std::filesystem::filesystem_error);
    CHECK(std::filesystem::is_symlink(folder / "full"));
}
