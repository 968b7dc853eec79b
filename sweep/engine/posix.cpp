#include "sweep/engine/posix.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <iterator>

namespace stickslip {

FileHandle::~FileHandle()
{
    if (descriptor_ >= 0) ::close(descriptor_);
}

std::error_code last_error()
{
    return {errno, std::generic_category()};
}

FileHandle open_file(const std::filesystem::path& path, int flags)
{
    FileHandle file(::open(path.c_str(), flags | O_CLOEXEC, 0666));
    if (!file) throw std::system_error(last_error(), path.string());
    return file;
}

std::error_code write_all(int descriptor, std::span<const std::byte> bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return last_error();
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return {};
}

bool read_exactly(int descriptor, std::span<std::byte> bytes, std::uint64_t offset)
{
    while (!bytes.empty()) {
        const ssize_t got = ::pread(descriptor, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(got));
        offset += static_cast<std::uint64_t>(got);
    }
    return true;
}

void sync_directory(const std::filesystem::path& directory)
{
    const FileHandle handle = open_file(directory, O_RDONLY | O_DIRECTORY);
    // Some network file systems cannot sync a directory and say EINVAL; there is nothing more to do on them.
    if (::fsync(handle.get()) != 0 && errno != EINVAL) throw std::system_error(last_error(), directory.string());
}

void replace_file(const std::filesystem::path& path, std::string_view text)
{
    const std::filesystem::path fresh = path.string() + "." + std::to_string(::getpid());
    {
        const FileHandle file = open_file(fresh, O_CREAT | O_TRUNC | O_WRONLY);
        std::error_code error = write_all(file.get(), std::as_bytes(std::span(text)));
        if (!error && ::fsync(file.get()) != 0) error = last_error();
        if (error) {
            ::unlink(fresh.c_str());
            throw std::system_error(error, path.string());
        }
    }
    std::filesystem::rename(fresh, path);
    sync_directory(path.parent_path());
}

std::string read_text(const std::filesystem::path& path)
{
    std::ifstream in(path, std::ios::binary);
    if (!in) throw std::system_error(last_error(), path.string());
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string host_name()
{
    std::array<char, 256> name{};
    ::gethostname(name.data(), name.size() - 1);
    std::string text = name.data();
    for (char& c : text)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-') c = '_';
    return text.empty() ? "host" : text;
}

}  // namespace stickslip
