#include "sweep/files/text/whole_file.h"

#include <cerrno>
#include <fstream>
#include <system_error>

namespace stickslip {

void write_whole(const std::filesystem::path& file, std::string_view bytes)
{
    namespace fs = std::filesystem;
    if (file.has_parent_path()) fs::create_directories(file.parent_path());
    // a terminal or a pipe is written to, not replaced
    const bool device = fs::exists(file) && !fs::is_regular_file(file) && !fs::is_directory(file);
    const auto temporary = device ? file : fs::path(file).concat(".part");
    errno = 0;
    std::ofstream out(temporary, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out) {
        const std::error_code reason(errno != 0 ? errno : EIO, std::generic_category());
        std::error_code ignored;
        if (!device) fs::remove(temporary, ignored);
        throw fs::filesystem_error("cannot be written", file, reason);
    }
    if (!device) fs::rename(temporary, file);
}

}  // namespace stickslip
