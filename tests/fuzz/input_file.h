// Fuzzed bytes as a file that readers can open by its path.
#pragma once
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace fuzz {

inline std::string_view text_of(std::span<const std::uint8_t> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// A file in memory; gone with this.
class InputFile {
  public:
    explicit InputFile(std::span<const std::uint8_t> bytes) : descriptor_(memfd_create("input", MFD_CLOEXEC))
    {
        if (descriptor_ < 0) throw std::runtime_error("no file in memory");
        while (!bytes.empty()) {
            const auto written = ::write(descriptor_, bytes.data(), bytes.size());
            if (written <= 0) throw std::runtime_error("no room for a file in memory");
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        }
    }
    InputFile(const InputFile&) = delete;
    ~InputFile() { ::close(descriptor_); }
    std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

  private:
    int descriptor_;
};

/// What a fuzzed function promises and did not keep; ends the process, so that the fuzzer keeps the input.
inline void promise(bool kept, const char* what)
{
    if (kept) return;
    [[maybe_unused]] const auto ignored = ::write(2, what, std::char_traits<char>::length(what));
    [[maybe_unused]] const auto newline = ::write(2, "\n", 1);
    __builtin_trap();
}

}  // namespace fuzz
