#include "sweep/program/verbs/still_searching.h"

#include "tests/temporary_directory.h"

#include <catch2/catch.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

using namespace stickslip;

namespace {

/// Standard error goes to a file for the time that this stands.
class ErrorsToFile {
  public:
    explicit ErrorsToFile(const std::string& file) : kept_(dup(STDERR_FILENO))
    {
        const int opened = open(file.c_str(), O_WRONLY | O_CREAT, 0600);
        dup2(opened, STDERR_FILENO);
        close(opened);
    }
    ~ErrorsToFile()
    {
        dup2(kept_, STDERR_FILENO);
        close(kept_);
    }
    ErrorsToFile(const ErrorsToFile&) = delete;
    ErrorsToFile& operator=(const ErrorsToFile&) = delete;

  private:
    int kept_;
};

std::string said_with(std::chrono::milliseconds patience, bool wait_for_words)
{
    const TemporaryDirectory directory;
    const auto file = (directory / "said").string();
    const auto said = [&] {
        std::stringstream text;
        text << std::ifstream(file).rdbuf();
        return text.str();
    };
    const ErrorsToFile to_file(file);
    StillSearching searching("--effort 0.1 searches less", patience);
    searching.stage("the stable gains");
    while (wait_for_words && said().empty()) usleep(1000);
    return said();
}

}  // namespace

TEST_CASE("a stage that lasts longer than patience is named once, a shorter one never", "[program]")
{
    CHECK(said_with(std::chrono::milliseconds(0), true) ==
          "still searching: the stable gains (--effort 0.1 searches less)\n");
    CHECK(said_with(std::chrono::hours(1), false).empty());
}
