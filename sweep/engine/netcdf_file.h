// The NetCDF library with owned handles and errors that name the file.
#pragma once
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip {

/// What the NetCDF library refused, in words with the file's name.
struct NetcdfError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// One open file. Not thread-safe, nor are two files in two threads: the library is not.
class NetcdfFile {
  public:
    /// A new NetCDF-4 file in place of any other. Throws NetcdfError, like all members.
    static NetcdfFile create(const std::filesystem::path& path);
    static NetcdfFile open(const std::filesystem::path& path);

    NetcdfFile(NetcdfFile&& other) noexcept;
    NetcdfFile& operator=(NetcdfFile&&) = delete;
    ~NetcdfFile();

    int id() const { return id_; }

    /// Throws if status is an error; `what` is what was being done.
    void check(int status, std::string_view what) const;

    /// Text attributes; the variable is global_attribute for those of the file.
    void put_text(int variable, const char* name, std::string_view text) const;
    std::string text(int variable, const char* name) const;

    /// The variable of that name, or −1.
    int find_variable(std::string_view name) const;

    /// Writes what is buffered and ends the file; errors of the disk show here at the latest.
    void close();

  private:
    NetcdfFile(std::filesystem::path path, int id) : path_(std::move(path)), id_(id) {}
    std::filesystem::path path_;
    int id_;
};

inline constexpr int global_attribute = -1;

}  // namespace stickslip
