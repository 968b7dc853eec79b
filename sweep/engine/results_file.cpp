#include "sweep/engine/results_file.h"

#include "sweep/engine/hyperslab.h"
#include "sweep/engine/plan_file.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace stickslip {
namespace {

int get(int file, int variable, const std::size_t* start, const std::size_t* count, double* out)
{
    return nc_get_vara_double(file, variable, start, count, out);
}
int get(int file, int variable, const std::size_t* start, const std::size_t* count, std::uint8_t* out)
{
    return nc_get_vara_schar(file, variable, start, count, reinterpret_cast<signed char*>(out));
}

std::vector<std::size_t> shape_of(const std::vector<Axis>& axes)
{
    std::vector<std::size_t> shape;
    for (const Axis& axis : axes) shape.push_back(axis.values.size());
    return shape;
}

}  // namespace

ResultsFile::ResultsFile(const std::filesystem::path& path) : file_(NetcdfFile::open(path))
{
    units_ = Units(attribute("motion") == "revolute" ? Motion::revolute : Motion::prismatic,
                   command_named(attribute("drive_signal")));
    int dimensions = 0;
    file_.check(nc_inq_ndims(file_.id(), &dimensions), "count the dimensions");
    for (int d = 0; d < dimensions; ++d) {
        char name[NC_MAX_NAME + 1];
        std::size_t length = 0;
        file_.check(nc_inq_dim(file_.id(), d, name, &length), "read a dimension");
        const int coordinate = variable(name);
        Axis axis;
        axis.path = file_.text(coordinate, "path");
        axis.symbol = file_.text(coordinate, "symbol");
        axis.name = file_.text(coordinate, "long_name");
        axis.quantity = quantity_in(file_.text(coordinate, "units"), units_);
        axis.log = file_.text(coordinate, "scale") == "log";
        axis.values.resize(length);
        file_.check(nc_get_var_double(file_.id(), coordinate, axis.values.data()), "read an axis");
        axes_.push_back(std::move(axis));
    }
}

std::uint64_t ResultsFile::points() const
{
    std::uint64_t product = 1;
    for (const Axis& axis : axes_) product *= axis.values.size();
    return product;
}

int ResultsFile::variable(std::string_view column) const
{
    const int found = file_.find_variable(column);
    if (found < 0) file_.check(NC_ENOTVAR, fmt::format("find \"{}\"", column));
    return found;
}

template <class Value>
std::vector<Value> ResultsFile::box(std::string_view column, std::span<const std::size_t> along,
                                    std::span<const std::size_t> at) const
{
    if (at.size() != axes_.size()) throw std::invalid_argument("a point of this file has one index an axis");
    std::vector<std::size_t> start(at.begin(), at.end()), count(axes_.size(), 1);
    std::size_t size = 1;
    for (const std::size_t axis : along) {
        start.at(axis) = 0;
        count[axis] = axes_[axis].values.size();
        size *= count[axis];
    }
    std::vector<Value> values(size);
    file_.check(get(file_.id(), variable(column), start.data(), count.data(), values.data()),
                fmt::format("read \"{}\"", column));
    return values;
}

namespace {

/// The library gives the slower axis of the file first; a plane has y first, whichever of the two that is.
template <class Value>
std::vector<Value> y_first(std::vector<Value> values, bool x_is_slower, std::size_t nx, std::size_t ny)
{
    if (!x_is_slower) return values;
    std::vector<Value> turned(values.size());
    for (std::size_t iy = 0; iy < ny; ++iy)
        for (std::size_t ix = 0; ix < nx; ++ix) turned[iy * nx + ix] = values[ix * ny + iy];
    return turned;
}

}  // namespace

std::vector<double> ResultsFile::plane(std::string_view column, std::size_t x, std::size_t y,
                                       std::span<const std::size_t> at) const
{
    return y_first(box<double>(column, std::array{x, y}, at), x < y, axes_.at(x).values.size(),
                   axes_.at(y).values.size());
}

std::vector<std::uint8_t> ResultsFile::code_plane(std::string_view column, std::size_t x, std::size_t y,
                                                  std::span<const std::size_t> at) const
{
    return y_first(box<std::uint8_t>(column, std::array{x, y}, at), x < y, axes_.at(x).values.size(),
                   axes_.at(y).values.size());
}

std::vector<double> ResultsFile::line(std::string_view column, std::size_t x, std::span<const std::size_t> at) const
{
    return box<double>(column, std::array{x}, at);
}

std::vector<double> ResultsFile::numbers(std::string_view column) const
{
    std::vector<double> values(points());
    file_.check(nc_get_var_double(file_.id(), variable(column), values.data()), fmt::format("read \"{}\"", column));
    return values;
}

std::vector<std::uint8_t> ResultsFile::codes(std::string_view column) const
{
    std::vector<std::uint8_t> values(points());
    file_.check(nc_get_var_schar(file_.id(), variable(column), reinterpret_cast<signed char*>(values.data())),
                fmt::format("read \"{}\"", column));
    return values;
}

std::vector<std::uint64_t> ResultsFile::count_codes(std::string_view column) const
{
    constexpr std::uint64_t block = 1 << 20;
    const auto shape = shape_of(axes_);
    const int id = variable(column);
    std::vector<std::uint64_t> counts(256);
    std::vector<std::uint8_t> values(std::min(block, points()));
    for (std::uint64_t first = 0; first < points(); first += block)
        for (const Hyperslab& slab : hyperslabs(shape, {first, std::min(block, points() - first)})) {
            file_.check(get(file_.id(), id, slab.start.data(), slab.count.data(), values.data()),
                        fmt::format("read \"{}\"", column));
            for (std::uint64_t i = 0; i < slab.points(); ++i) ++counts[values[i]];
        }
    return counts;
}

std::size_t nearest_index(const Axis& axis, double value)
{
    const auto distance = [&](double v) { return axis.log ? std::abs(std::log(v / value)) : std::abs(v - value); };
    const auto nearest = std::ranges::min_element(axis.values, {}, distance);
    return static_cast<std::size_t>(nearest - axis.values.begin());
}

}  // namespace stickslip
