// Reads results.nc back, a column or a slice at a time.
#pragma once
#include "analysis/results/stability_map.h"
#include "sweep/engine/netcdf_file.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip {

/// An open results.nc. Memory is what a call returns, whatever the size of the file. Not thread-safe.
class ResultsFile {
  public:
    /// Throws NetcdfError if the file cannot be read or is not a results file.
    explicit ResultsFile(const std::filesystem::path& path);

    const std::vector<Axis>& axes() const { return axes_; }  ///< slowest first, as in the plan
    Units units() const { return units_; }
    std::uint64_t points() const;

    /// A global attribute: title, spec, joint, plan_id, command, build …; throws NetcdfError for a name that is not
    /// there.
    std::string attribute(const char* name) const { return file_.text(global_attribute, name); }

    bool has(std::string_view column) const { return file_.find_variable(column) >= 0; }

    /// A whole column in the order of the points; codes come as they are. Throws NetcdfError for a name that is not
    /// there.
    std::vector<double> numbers(std::string_view column) const;
    std::vector<std::uint8_t> codes(std::string_view column) const;

    /// The plane over two axes (their places in axes()) through the point whose indices on all axes are `at` (those of
    /// x and y are ignored); row-major like StabilityMap: index = iy * nx + ix.
    std::vector<double> plane(std::string_view column, std::size_t x, std::size_t y,
                              std::span<const std::size_t> at) const;
    std::vector<std::uint8_t> code_plane(std::string_view column, std::size_t x, std::size_t y,
                                         std::span<const std::size_t> at) const;

    /// The line along one axis through that point.
    std::vector<double> line(std::string_view column, std::size_t x, std::span<const std::size_t> at) const;

    /// How often each of the 256 codes occurs in a coded column, read block by block.
    std::vector<std::uint64_t> count_codes(std::string_view column) const;

  private:
    int variable(std::string_view column) const;
    template <class Value>
    std::vector<Value> box(std::string_view column, std::span<const std::size_t> along,
                           std::span<const std::size_t> at) const;

    NetcdfFile file_;
    Units units_;
    std::vector<Axis> axes_;
};

/// The index of the axis value nearest to `value` (by ratio on a log axis).
std::size_t nearest_index(const Axis& axis, double value);

}  // namespace stickslip
