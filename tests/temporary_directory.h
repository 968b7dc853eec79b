// A directory of a test's own.
#pragma once
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

/// A directory that is gone when the test ends.
class TemporaryDirectory {
  public:
    TemporaryDirectory()
    {
        std::string name = (std::filesystem::temp_directory_path() / "stickslip-test-XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("no temporary directory");
        path_ = name;
    }
    TemporaryDirectory(const TemporaryDirectory&) = delete;
    ~TemporaryDirectory() { std::filesystem::remove_all(path_); }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// One for all tests of a program that need no directory of their own. Made when first used: who does not write makes
/// none.
inline const TemporaryDirectory& shared_directory()
{
    static const TemporaryDirectory directory;
    return directory;
}
