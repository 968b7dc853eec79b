#include "sweep/engine/netcdf_file.h"

#include <fmt/format.h>
#include <netcdf.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <system_error>
#include <utility>

namespace stickslip {
namespace {

/// Why the disk takes no more, where it does not: the library says no more than "HDF error".
std::string reason_of_disk(int error)
{
    for (const int known : {ENOSPC, EDQUOT, EFBIG, EROFS, EIO})
        if (error == known) return fmt::format(" ({})", std::generic_category().message(error));
    return "";
}

/// When the program ends, HDF5 tries once more to write what it could not, and crashes (1.10.8). This handler is
/// registered after its own, and so comes before: nothing is left for it to do.
void end_without_hdf5()
{
    static std::once_flag once;
    std::call_once(once, [] {
        on_exit(
            [](int status, void*) {
                std::fflush(nullptr);
                ::_exit(status);
            },
            nullptr);
    });
}

}  // namespace

static_assert(global_attribute == NC_GLOBAL);

NetcdfFile NetcdfFile::create(const std::filesystem::path& path)
{
    NetcdfFile file(path, -1);
    int id = -1;
    errno = 0;
    file.check(nc_create(path.c_str(), NC_NETCDF4 | NC_CLOBBER, &id), "create");
    file.id_ = id;
    return file;
}

NetcdfFile NetcdfFile::open(const std::filesystem::path& path)
{
    NetcdfFile file(path, -1);
    int id = -1;
    file.check(nc_open(path.c_str(), NC_NOWRITE, &id), "open");
    file.id_ = id;
    return file;
}

NetcdfFile::NetcdfFile(NetcdfFile&& other) noexcept : path_(std::move(other.path_)), id_(std::exchange(other.id_, -1))
{
}

NetcdfFile::~NetcdfFile()
{
    if (id_ >= 0 && nc_close(id_) != NC_NOERR) end_without_hdf5();
}

void NetcdfFile::check(int status, std::string_view what) const
{
    if (status == NC_NOERR) return;
    const auto disk = reason_of_disk(errno);
    throw NetcdfError(fmt::format("{}: cannot {}: {}{}", path_.string(), what, nc_strerror(status), disk));
}

void NetcdfFile::put_text(int variable, const char* name, std::string_view text) const
{
    check(nc_put_att_text(id_, variable, name, text.size(), text.data()), fmt::format("write attribute {}", name));
}

std::string NetcdfFile::text(int variable, const char* name) const
{
    std::size_t length = 0;
    check(nc_inq_attlen(id_, variable, name, &length), fmt::format("read attribute {}", name));
    std::string text(length, '\0');
    if (length > 0) check(nc_get_att_text(id_, variable, name, text.data()), fmt::format("read attribute {}", name));
    return text;
}

int NetcdfFile::find_variable(std::string_view name) const
{
    int variable = -1;
    return nc_inq_varid(id_, std::string(name).c_str(), &variable) == NC_NOERR ? variable : -1;
}

void NetcdfFile::close()
{
    const int status = nc_close(std::exchange(id_, -1));
    if (status != NC_NOERR) end_without_hdf5();
    check(status, "finish");
}

}  // namespace stickslip
