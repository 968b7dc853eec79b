#include "sweep/program/verbs/stage_line.h"

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
    StageLine line(searches_less(1), patience);
    line.stage("the stable gains");
    while (wait_for_words && said().empty()) usleep(1000);
    return said();
}

}  // namespace

TEST_CASE("an answer that lasts longer than patience names its stage, a shorter one says nothing", "[program]")
{
    const auto said = said_with(std::chrono::milliseconds(0), true);
    CHECK(said.starts_with("still searching: the stable gains  "));
    CHECK(said.ends_with(" s  (--effort 0.1 searches less)\n"));
    CHECK(said_with(std::chrono::hours(1), false).empty());
    // with less already, the advice is still one
    CHECK(searches_less(0.1) == "--effort 0.01 searches less");
}
