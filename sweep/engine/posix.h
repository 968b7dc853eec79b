// The few calls of the operating system that durability needs and <fstream> does not offer.
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace stickslip {

/// Owns a file descriptor.
class FileHandle {
  public:
    FileHandle() = default;
    explicit FileHandle(int descriptor) : descriptor_(descriptor) {}
    FileHandle(FileHandle&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
    FileHandle& operator=(FileHandle&& other) noexcept
    {
        std::swap(descriptor_, other.descriptor_);
        return *this;
    }
    ~FileHandle();

    int get() const { return descriptor_; }
    explicit operator bool() const { return descriptor_ >= 0; }

  private:
    int descriptor_ = -1;
};

/// The error of the last system call.
std::error_code last_error();

/// open(2) that closes on exec; throws std::system_error naming the file.
FileHandle open_file(const std::filesystem::path& path, int flags);

/// Writes all bytes, however often the system takes only a part.
std::error_code write_all(int descriptor, std::span<const std::byte> bytes);

/// Reads exactly that many bytes at the offset; false at the end of the file or on an error.
bool read_exactly(int descriptor, std::span<std::byte> bytes, std::uint64_t offset);

/// Makes creations, renames and removals in the directory survive a power cut.
void sync_directory(const std::filesystem::path& directory);

/// Replaces the file so that a reader, or a power cut, finds the old text or the new one and never a part.
/// Throws std::system_error.
void replace_file(const std::filesystem::path& path, std::string_view text);

/// The whole file. Throws std::system_error.
std::string read_text(const std::filesystem::path& path);

/// The machine's name, with characters that suit a file name.
std::string host_name();

}  // namespace stickslip
