#include "sweep/engine/netcdf_file.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <utility>

namespace stickslip {

static_assert(global_attribute == NC_GLOBAL);

NetcdfFile NetcdfFile::create(const std::filesystem::path& path)
{
    NetcdfFile file(path, -1);
    int id = -1;
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
    if (id_ >= 0) nc_close(id_);
}

void NetcdfFile::check(int status, std::string_view what) const
{
    if (status != NC_NOERR)
        throw NetcdfError(fmt::format("{}: cannot {}: {}", path_.string(), what, nc_strerror(status)));
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
    check(nc_close(std::exchange(id_, -1)), "finish");
}

}  // namespace stickslip
